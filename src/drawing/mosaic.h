// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <unordered_set>
#include <vector>

#include "drawing/drawing.h"
#include "drawing/inherit.h"
#include "drawing/sheet.h"

namespace edaha {

// Puts whole drawings into one, each as a group, smaller or larger: see sheet_page(). Symbols with
// the same name and shapes are taken once.
class Mosaic {
  public:
    // Unless `keep_ids`, ids within the drawings are left out, and symbols have short ones.
    Mosaic(Drawing& page, bool keep_ids);

    // page = offset + scale * tile. `card`, if it has any, is the first child.
    Group group_of(const Tile& tile, double scale, Vec2 offset, std::vector<Element> card);

    // `wanted`, or with a number where that is taken. Empty stays empty.
    std::string unique(const std::string& wanted);

  private:
    struct Known {
        std::string name;     // as the tiles call it
        std::uint32_t index;  // into the page's symbols
    };

    void take_symbols(const Drawing& drawing);
    std::uint32_t take_symbol(const Symbol& symbol);
    std::string id_of(const std::string& id);
    std::vector<Element> mapped(const std::vector<Element>& elements, const InheritedPaint& parent);
    Group mapped(const Group& group, const InheritedPaint& parent);
    Shape mapped(const Shape& shape);
    Use mapped(const Use& use, const InheritedPaint& parent) const;
    Paint mapped(Paint paint) const;

    Drawing& page_;
    bool keep_ids_;
    std::vector<Known> known_;
    std::unordered_set<std::string> ids_;  // asked, never walked through

    // Of the tile at hand.
    std::string prefix_;
    double scale_ = 1;
    Affine map_{1, 0, 0, 1, 0, 0};
    std::vector<std::uint32_t> symbols_;  // the page's index of each
    std::vector<bool> takes_pen_;         // of each symbol of the page: draws with the parent's pen
};

}  // namespace edaha
