// SPDX-License-Identifier: MIT
#include "style/schema.h"

#include <gtest/gtest.h>

#include "style/parameter.h"
#include "style/reference_page.h"
#include "style/style_xml.h"
#include "support/run.h"

namespace edaha {
namespace {

// xmllint is an independent judge of both the schema and the styles.
class Schema : public testing::Test {
  protected:
    Schema() { test::write_whole(folder_ / "style.xsd", style_schema()); }

    test::RunResult validate(const std::string& xml) const {
        test::write_whole(folder_ / "style.xml", xml);
        return test::run("xmllint --noout --schema " + (folder_ / "style.xsd") + ' ' +
                         (folder_ / "style.xml"));
    }

    test::TemporaryFolder folder_;
};

TEST_F(Schema, AcceptsEveryBuiltInStyle) {
    const Catalogue catalogue;
    for (const std::string& name : catalogue.style_names()) {
        const SourceText source = catalogue.find_style(name);
        const auto as_written = validate(source.text);
        EXPECT_EQ(as_written.exit_code, 0) << as_written.err;
        const auto canonical = validate(to_xml(read_style(source, catalogue)));
        EXPECT_EQ(canonical.exit_code, 0) << canonical.err;
    }
}

TEST_F(Schema, AcceptsEveryKindOfValue) {
    const auto sample = test::read_whole(TESTS_DIR "/unit/style/styles/cherry.xml");
    const auto result = validate(sample);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    Style style;
    style.name = "default";
    const auto defaults = validate(to_xml(style));
    EXPECT_EQ(defaults.exit_code, 0) << defaults.err;
}

TEST_F(Schema, RefusesWhatTheReaderRefuses) {
    constexpr int kNotValid = 3;  // xmllint's exit code
    for (const char* name :
         {"not-a-number", "out-of-range", "not-whole", "broken-range", "broken-colour",
          "unknown-choice", "unknown-flag", "unknown-group", "unknown-parameter",
          "unknown-attribute", "unknown-model", "no-model", "no-name", "bad-name", "palette-twice",
          "text-inside", "element-inside", "wrong-root"}) {
        const auto xml =
            test::read_whole(TESTS_DIR "/unit/style/malformed/" + std::string(name) + ".xml");
        EXPECT_EQ(validate(xml).exit_code, kNotValid) << name;
    }
}

TEST(ReferencePage, HasALineForEveryParameter) {
    const std::string page = reference_page();
    for (const Parameter& parameter : parameters()) {
        EXPECT_NE(page.find("| `" + parameter.key() + "` |"), std::string::npos) << parameter.key();
    }
}

}  // namespace
}  // namespace edaha
