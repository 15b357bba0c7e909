// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/gallery/words.h"
#include "app/tree_style.h"
#include "drawing/sheet.h"
#include "style/parameter.h"

namespace edaha {

// A gallery as gallery.xml describes it (gallery_xml.h), each tree's style read and changed: all
// that is needed to draw its pictures and write its pages.

struct GalleryTree {
    TreeStyle tree;
    std::string caption;  // beneath it, in a strip
};

// How several trees stand together; a tree alone is arranged by nothing.
using Arrangement = std::variant<std::monostate, StripParams, SheetParams, PosterParams>;

// One picture of the gallery: the files PAGE/NAME.svg and PAGE/NAME.png.
struct Plate {
    std::string page;
    std::string name;
    Line caption;
    std::vector<GalleryTree> trees;
    Arrangement arrangement;
    int thumbnail_px = 0;  // across; 0: as suits its kind
    std::string keywords;  // for searching, besides its words and commands

    std::string stem() const { return page + '/' + name; }
    bool is_single() const { return std::holds_alternative<std::monostate>(arrangement); }
    std::string alt() const { return caption.empty() ? name : to_plain(caption); }
};

struct Table {
    struct Row {
        bool head = false;
        std::vector<Line> cells;
    };
    std::vector<Row> rows;
};

// What the illustrated manual says of a parameter; the rest stands in the parameter table.
struct ManualEntry {
    const Parameter* parameter;
    std::vector<std::string> circumstances;  // "space.drop=yes": what else was set for its strip
    std::optional<std::size_t> plate;        // none where there is nothing to see
};

struct ManualGroup {
    const ParameterGroup* group;
    std::vector<ManualEntry> entries;
};

struct PlateReference {
    std::size_t index;  // into Gallery::plates
};

using Block = std::variant<Line, PlateReference, Table, ManualGroup>;

struct GalleryPage {
    std::string name;
    std::string title;
    std::vector<Block> blocks;
};

struct Gallery {
    std::string title;
    Line description;
    std::vector<GalleryPage> pages;
    std::vector<Plate> plates;  // in the order of the file; each stem once
};

}  // namespace edaha
