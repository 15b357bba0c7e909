// SPDX-License-Identifier: MIT
#include "app/batch/name_pattern.h"

#include <gtest/gtest.h>

#include "app/options.h"

namespace edaha {
namespace {

std::string name_of(const std::string& pattern) {
    return NamePattern(pattern).name([](const std::string& field) -> std::string {
        if (field == "seed") return "7";
        if (field == "leaf.shape") return "../my leaf";
        if (field == "style") return "..";
        return '<' + field + '>';
    });
}

std::string error_of(const std::string& pattern) {
    try {
        name_of(pattern);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(NamePattern, FillsFieldsIn) {
    EXPECT_EQ(name_of("tree"), "tree");
    EXPECT_EQ(name_of("{seed}"), "7");
    EXPECT_EQ(name_of("a/{palette}-{seed:04}/{growth.energy}.x"),
              "a/<palette>-0007/<growth.energy>.x");
    EXPECT_EQ(name_of("{seed:01}{seed:018}"), "7000000000000000007");
}

TEST(NamePattern, ValuesMakeNoFolders) {
    EXPECT_EQ(name_of("{leaf.shape}"), "..-my_leaf");
}

TEST(NamePattern, StaysInItsFolder) {
    const std::string outside = " is no path within the folder of -o";
    for (const std::string pattern : {"/tmp/x", "../x", "a/../x", "a/", "a//b", ".", "a/."})
        EXPECT_EQ(error_of(pattern), "--name: '" + pattern + "'" + outside);
    EXPECT_EQ(error_of("{style}/x"), "--name: '../x'" + outside);
    EXPECT_EQ(error_of(std::string(251, 'x')).substr(0, 12), "--name: 'xxx");
    EXPECT_EQ(error_of(std::string(250, 'x')), "");
}

TEST(NamePattern, SaysWhatIsWrong) {
    EXPECT_EQ(error_of(""), "--name: is empty");
    EXPECT_EQ(error_of("{sede}"),
              "--name: '{sede}' is no field (expected style, seed, index, family, palette or a "
              "parameter; did you mean '{seed}'?)");
    EXPECT_EQ(error_of("{growth.enery}"),
              "--name: '{growth.enery}' is no field (expected style, seed, index, family, palette "
              "or a parameter; did you mean '{growth.energy}'?)");
    EXPECT_EQ(error_of("{style:04}"), "--name: '{style:04}': only whole numbers have a width");
    EXPECT_EQ(error_of("{seed:4}"), "--name: '{seed:4}': ':4' is no width (expected :01 … :18)");
    EXPECT_EQ(error_of("{seed:019}"),
              "--name: '{seed:019}': ':019' is no width (expected :01 … :18)");
    for (const std::string pattern : {"{seed", "seed}", "{{seed}}", "a{"})
        EXPECT_EQ(error_of(pattern), "--name: '" + pattern + "' has a brace without its other");
    EXPECT_EQ(error_of("a\nb"), "--name: 'a?b' is not plain text");
    EXPECT_EQ(error_of("a\xff"), "--name: 'a\xff' is not plain text");
}

}  // namespace
}  // namespace edaha
