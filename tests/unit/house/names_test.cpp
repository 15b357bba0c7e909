// SPDX-License-Identifier: MIT
// One name, one type: two types of one name in one program get each other's functions, by whatever
// order they are linked in.
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "unit/house/project_text.h"

namespace edaha::test {
namespace {

// The types that a file defines for all: not in a namespace without a name, nor within a type.
std::set<std::string> public_types(const std::vector<std::string>& lines) {
    static const std::regex kType("(?:struct|class) (\\w+)(?: final)? ?[:{].*");
    std::set<std::string> names;
    bool is_private = false;
    for (const std::string& line : lines) {
        if (line == "namespace {") is_private = true;
        if (line == "}  // namespace") is_private = false;
        std::smatch match;
        if (!is_private && std::regex_match(line, match, kType)) names.insert(match[1]);
    }
    return names;
}

TEST(Names, OfTypesAreThoseOfOneHeader) {
    std::map<std::string, std::string> home;
    for (const TextFile& file : project_files({"src"}, {".h"})) {
        for (const std::string& name : public_types(file.lines)) {
            const auto [known, is_new] = home.emplace(name, file.path);
            EXPECT_TRUE(is_new) << name << " is in " << known->second << " and in " << file.path;
        }
    }
    EXPECT_GT(home.size(), 100U);
}

TEST(Names, ArePrivateInNamelessNamespaces) {
    const auto types =
        split_lines("struct A {\nnamespace {\nstruct B {\n}  // namespace\nclass C : A {");
    EXPECT_EQ(public_types(types), (std::set<std::string>{"A", "C"}));
}

}  // namespace
}  // namespace edaha::test
