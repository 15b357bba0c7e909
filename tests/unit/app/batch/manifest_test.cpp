// SPDX-License-Identifier: MIT
#include "app/batch/manifest.h"

#include <gtest/gtest.h>

#include "app/batch/merge.h"
#include "app/batch/row.h"
#include "base/error.h"
#include "support/run.h"

namespace edaha {
namespace {

using test::read_whole;
using test::TemporaryFolder;

std::string row_line(std::size_t variant, const std::string& format) {
    return R"({"file":"a, \"b\" )" + std::to_string(variant) + '.' + format +
           R"(","seed":1000000,"growth.energy":1e-7,"palette.leaf":"#102030","width_mm":1.5,)"
           R"("height_mm":2,"branches":3,"leaves":2,"overlap":0.25,"nodes":3,"bytes":4,"recipe":"x"})";
}

ManifestHead head_of(const Shard& shard) {
    return {"0.1.0",        "edaha batch x -n 7",
            "0123",         7,
            {"svg", "pdf"}, {"file", "seed", "growth.energy", "palette.leaf", "width_mm", "recipe"},
            shard};
}

// Writes the manifest of a share, of which the last `missing` rows are not there.
void write_share(const std::string& folder, const ManifestHead& head, std::size_t missing = 0) {
    std::vector<std::string> rows;
    for (std::size_t place = 0; place < head.shard.size(head.variants); ++place)
        for (const std::string& format : head.formats)
            rows.push_back(row_line(head.shard.variant(place), format));
    rows.resize(rows.size() - missing);
    std::size_t next = 0;
    write_manifest(folder, head, [&]() -> std::optional<std::string> {
        return next < rows.size() ? std::optional(rows[next++]) : std::nullopt;
    });
}

std::string merge_error(const std::string& folder, const std::vector<std::string>& paths = {}) {
    try {
        merge_manifests(folder, paths);
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

TEST(Manifest, IsJsonAndCsvOfTheSameRows) {
    const TemporaryFolder folder;
    write_share(folder.path(), head_of({}));
    const auto json = nlohmann::json::parse(read_whole(folder / "manifest.json"));
    EXPECT_EQ(json.at("edaha"), "0.1.0");
    EXPECT_EQ(json.at("variants"), 7);
    EXPECT_EQ(json.at("files").size(), 14u);
    EXPECT_EQ(json.at("files").at(3).at("file"), "a, \"b\" 1.pdf");
    EXPECT_FALSE(json.contains("shard"));
    const std::string csv = read_whole(folder / "manifest.csv");
    EXPECT_TRUE(
        csv.starts_with("file,seed,growth.energy,palette.leaf,width_mm,recipe\r\n"
                        "\"a, \"\"b\"\" 0.svg\",1000000,1e-7,#102030,1.5,x\r\n"));
}

TEST(Manifest, IsReadAsItWasWritten) {
    const TemporaryFolder folder;
    write_share(folder.path(), head_of({2, 3}));
    ManifestReader reader(folder / "manifest.2-of-3.json");
    EXPECT_TRUE(reader.head().is_same_run(head_of({})));
    EXPECT_EQ(shard_text(reader.head().shard), "2/3");
    EXPECT_EQ(reader.next_row(), row_line(1, "svg"));
    EXPECT_EQ(reader.next_row(), row_line(1, "pdf"));
    EXPECT_EQ(reader.next_row(), row_line(4, "svg"));
    EXPECT_EQ(reader.next_row(), row_line(4, "pdf"));
    EXPECT_EQ(reader.next_row(), std::nullopt);
}

TEST(Manifest, OthersFilesAreRefused) {
    const TemporaryFolder folder;
    for (const char* text :
         {"", "{}", "[1]\n", "{\n\"files\": [\n]}\n", "{\n\"edaha\": 3,\n\"files\": [\n]}\n"}) {
        test::write_whole(folder / "m.json", text);
        try {
            const ManifestReader reader(folder / "m.json");
            FAIL() << text;
        } catch (const IoError& error) {
            EXPECT_EQ(error.what(),
                      "'" + (folder / "m.json") + "' is no manifest that edaha batch wrote");
        }
    }
    write_share(folder.path(), head_of({}));
    const std::string whole = read_whole(folder / "manifest.json");
    test::write_whole(folder / "m.json", whole.substr(0, whole.size() - 50));
    ManifestReader torn(folder / "m.json");
    EXPECT_THROW(while (torn.next_row()){}, IoError);
}

TEST(Merge, SharesMakeTheWhole) {
    const TemporaryFolder whole, parts;
    write_share(whole.path(), head_of({}));
    for (const std::size_t count : {2u, 3u, 9u}) {  // nine: some are empty
        for (std::size_t index = 1; index <= count; ++index)
            write_share(parts.path(), head_of({index, count}));
        std::vector<std::string> paths;
        for (std::size_t index = count; index >= 1; --index)
            paths.push_back(manifest_path(parts.path(), {index, count}) + ".json");
        EXPECT_EQ(merge_manifests(parts.path(), paths), 7u);
        for (const char* file : {"manifest.json", "manifest.csv"})
            EXPECT_EQ(read_whole(parts / file), read_whole(whole / file)) << count;
    }
}

TEST(Merge, SaysWhatIsMissing) {
    const TemporaryFolder folder;
    EXPECT_EQ(merge_error(folder.path()),
              "there are no manifests of shares in '" + folder.path() + "'");
    for (const std::size_t index : {2u, 5u})
        write_share(folder.path(), head_of({index, 5}));
    EXPECT_EQ(merge_error(folder.path()), "shares are missing: 1/5, 3/5, 4/5");
    for (const std::size_t index : {1u, 3u, 4u})
        write_share(folder.path(), head_of({index, 5}), index == 3 ? 1 : 0);
    EXPECT_EQ(merge_error(folder.path()), "'" + (folder / "manifest.3-of-5.json") +
                                              "' is not complete: 1 of 2 files (--resume of its "
                                              "share goes on)");
    EXPECT_FALSE(std::filesystem::exists(folder / "manifest.json"));
}

TEST(Merge, OtherRunsAreNoShares) {
    const TemporaryFolder folder;
    write_share(folder.path(), head_of({1, 2}));
    ManifestHead other = head_of({2, 2});
    other.recipe = "4567";
    write_share(folder.path(), other);
    const std::string first = folder / "manifest.1-of-2.json";
    const std::string second = folder / "manifest.2-of-2.json";
    EXPECT_EQ(merge_error(folder.path()),
              "'" + first + "' and '" + second + "' are not shares of one run");
    EXPECT_EQ(merge_error(folder.path(), {first, first}),
              "'" + first + "' and '" + first + "' are the same share");
}

}  // namespace
}  // namespace edaha
