// SPDX-License-Identifier: MIT
#include "style/catalogue.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "style/built_in.h"
#include "style/style_xml.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, gone afterwards.
class CatalogueTest : public testing::Test {
  protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  ("edaha-" + std::to_string(::getpid()) + '-' + info->name());
        fs::create_directories(folder_ / "styles" / "paper");
        fs::create_directories(folder_ / "leaves");
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }

    fs::path folder_;
};

template <class Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

std::vector<std::string> names_on_disk(const fs::path& folder, const std::string& ending) {
    std::vector<std::string> names;
    if (!fs::exists(folder)) return names;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ending) continue;
        names.push_back(entry.path().lexically_relative(folder).replace_extension().string());
    }
    std::ranges::sort(names);
    return names;
}

TEST(BuiltIn, EveryFileOfTheFoldersIsCompiledIn) {
    const fs::path project = PROJECT_DIR;
    EXPECT_EQ(Catalogue().style_names(), names_on_disk(project / "styles", ".xml"));
    EXPECT_EQ(Catalogue().leaf_names(), names_on_disk(project / "leaves", ".svg"));
}

TEST(BuiltIn, TextsAreThoseOfTheFiles) {
    ASSERT_FALSE(built_in_leaves().empty());
    for (const BuiltIn& leaf : built_in_leaves()) {
        std::ifstream file(PROJECT_DIR "/leaves/" + std::string(leaf.name) + ".svg");
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        EXPECT_EQ(leaf.text, text) << leaf.name;
    }
}

TEST(BuiltIn, EveryStyleIsReadAndNamedAsItsFile) {
    for (const std::string& name : Catalogue().style_names()) {
        const Style style = read_style(Catalogue().find_style(name), Catalogue());
        EXPECT_EQ(style.name, fs::path(name).filename()) << name;
        EXPECT_FALSE(style.description.empty()) << name;
    }
}

TEST_F(CatalogueTest, TheUsersFolderComesBeforeWhatIsBuiltIn) {
    write("leaves/oak.svg", "mine");
    const Catalogue catalogue(folder_);
    EXPECT_EQ(catalogue.find_leaf("oak").text, "mine");
    EXPECT_EQ(catalogue.find_leaf("oak").origin, folder_ / "leaves/oak.svg");
    EXPECT_EQ(catalogue.find_leaf("maple").origin, "built-in leaves/maple.svg");
    EXPECT_EQ(std::ranges::count(catalogue.leaf_names(), "oak"), 1);
}

TEST_F(CatalogueTest, NamesMayHaveFolders) {
    write("styles/paper/one.xml", "<tree name='one'/>");
    write("styles/.hidden.xml", "");
    write("styles/Bad Name.xml", "");
    const Catalogue catalogue(folder_);
    EXPECT_EQ(catalogue.find_style("paper/one").text, "<tree name='one'/>");
    const auto names = catalogue.style_names();
    EXPECT_EQ(std::ranges::count(names, "paper/one"), 1);
    EXPECT_EQ(names.size(), Catalogue().style_names().size() + 1);
}

TEST_F(CatalogueTest, PathsComeFirst) {
    write("one.xml", "<tree name='one'/>");
    const Catalogue catalogue;
    const std::string path = (folder_ / "one.xml").string();
    EXPECT_EQ(catalogue.find_style(path).origin, path);
    EXPECT_EQ(catalogue.find_style("one.xml", folder_).origin, path);
    EXPECT_EQ(catalogue.find_style(path).folder, folder_);
}

TEST_F(CatalogueTest, WhatIsNotThereIsSaid) {
    write("styles/mine.xml", "<tree name='mine'/>");
    const Catalogue catalogue(folder_);
    EXPECT_EQ(message_of([&] { catalogue.find_style("mien"); }),
              "there is no style 'mien' (did you mean 'mine'?)");
    EXPECT_EQ(message_of([&] { catalogue.find_leaf("papyrus"); }), "there is no leaf 'papyrus'");
    EXPECT_EQ(message_of([&] { catalogue.find_style("gone.xml"); }),
              "cannot read 'gone.xml': No such file or directory");
    EXPECT_EQ(message_of([&] { catalogue.find_style("../mine"); }), "there is no style '../mine'");
}

TEST_F(CatalogueTest, OnlyFilesOfASensibleSizeAreRead) {
    fs::create_directory(folder_ / "folder.xml");
    const std::string path = (folder_ / "folder.xml").string();
    EXPECT_EQ(message_of([&] { Catalogue().find_style(path); }),
              "cannot read '" + path + "': it is not a file");
    write("large.xml", std::string(1'000'001, ' '));
    const std::string large = (folder_ / "large.xml").string();
    EXPECT_NE(message_of([&] { Catalogue().find_style(large); }), "no error");
}

TEST_F(CatalogueTest, ChainsOfBasesHaveAnEnd) {
    for (int i = 0; i < 18; ++i) {
        write(fmt::format("s{}.xml", i), fmt::format("<tree name='x' extends='s{}.xml'/>", i + 1));
    }
    write("s18.xml", "<tree name='x'/>");
    const auto read = [&](const std::string& name) {
        return message_of([&] { read_style(Catalogue().find_style(name, folder_), Catalogue()); });
    };
    EXPECT_EQ(read("s2.xml"), "no error");
    EXPECT_EQ(read("s1.xml"),
              (folder_ / "s17.xml").string() + ":1:16: tree.extends: more than 16 bases deep");
}

TEST_F(CatalogueTest, DrawingsAreFoundFromTheStylesFolder) {
    fs::create_directory(folder_ / "mine");
    write("mine/nut.svg", "<svg/>");
    write("mine/tree.xml", "<tree name='x'><leaf shape='nut.svg'/></tree>");
    const std::string path = (folder_ / "mine/tree.xml").string();
    const Style style = read_style(Catalogue().find_style(path), Catalogue());
    EXPECT_EQ(style.leaf.shape, (folder_ / "mine/nut.svg").generic_string());
    EXPECT_EQ(Catalogue().find_leaf(style.leaf.shape).text, "<svg/>");
}

TEST(Names, AreSmallLettersDigitsAndHyphens) {
    EXPECT_TRUE(is_name("cherry-2"));
    for (const char* wrong : {"", "-a", "a-", "A", "a b", "a/b", "a.b", "é"})
        EXPECT_FALSE(is_name(wrong)) << wrong;
}

}  // namespace
}  // namespace edaha
