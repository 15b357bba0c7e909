// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/leaf_shelf.h"
#include "app/tree_style.h"
#include "style/catalogue.h"
#include "style/xml_tree.h"

namespace edaha {

// A tree as an element of gallery.xml names it, and where, for messages.
struct TreeWords {
    TreeOptions options;
    std::size_t style_offset = 0;
    std::size_t palette_offset = 0;
};

// Reads which tree an element means. What is wrong is said at its place.
class TreeReader {
  public:
    TreeReader(const Catalogue& catalogue, std::filesystem::path folder, LeafShelf& leaves,
               XmlProblems& problems)
        : catalogue_(catalogue), folder_(std::move(folder)), leaves_(leaves), problems_(problems) {}

    // The attributes that are a tree's.
    static std::vector<std::string> attributes();

    // The element's attributes and its <set>s, over those of an element around it. Values that
    // can't be meant are left out.
    TreeWords read(const XmlElement& element, TreeWords outer = {});

    // Sets a parameter, again if it was set before; `offset` is the value's, for messages.
    void set(TreeWords& words, const std::string& key, const std::string& value,
             std::size_t offset);

    // Nothing if there is no such tree, or it can't be drawn.
    std::optional<TreeStyle> tree(const TreeWords& words);

  private:
    void read_attribute(const XmlAttribute& attribute, TreeWords& words);
    void read_set(const XmlElement& set_element, TreeWords& words);
    const std::optional<TreeStyle>& base(const TreeWords& words);
    bool has_leaves(const Style& style, std::size_t offset);
    void take_error(const std::exception& error, std::size_t offset);

    const Catalogue& catalogue_;
    std::filesystem::path folder_;
    LeafShelf& leaves_;
    XmlProblems& problems_;
    std::map<std::string, std::optional<TreeStyle>> bases_;
};

}  // namespace edaha
