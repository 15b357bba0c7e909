// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "drawing/paint.h"
#include "ornament/css.h"
#include "ornament/report.h"
#include "ornament/svg_document.h"
#include "ornament/svg_values.h"

namespace edaha::svg {

// A fill or stroke with everything resolved. `leaf` is the palette's leaf colour.
struct SvgInk {
    enum class Kind { none, leaf, colour };
    Kind kind = Kind::none;
    Colour colour;
    double opacity = 1;  // of the colour itself, as in #rrggbbaa
};

// What an element is drawn with, inheritance done. Widths are in the element's user units.
struct SvgStyle {
    SvgInk fill{SvgInk::Kind::colour, {0, 0, 0}, 1};
    SvgInk stroke;
    double stroke_width = 1;
    double fill_opacity = 1;
    double stroke_opacity = 1;
    double opacity = 1;  // the product of the groups' and its own
    double own_opacity = 1;
    bool even_odd = false;
    bool is_visible = true;
    bool is_displayed = true;  // false once a group above is display:none
    bool stroke_below = false;
    bool takes_leaf_colour = true;  // class "recolour" on it or the nearest group with a class
    Spot fill_rule_spot;
};

// Resolves presentation attributes, style sheets and style attributes, the stronger last
// (CSS 2.1, 6.4). Values that are wrong are errors; what has no counterpart in a flat drawing is a
// warning, and gradients become their first colour. Unknown names are warnings too.
class StyleResolver {
  public:
    // Reads the document's style sheets. Keeps references to both.
    StyleResolver(const SvgDocument& document, Report& report);

    SvgStyle resolve(const SvgStyle& parent, pugi::xml_node node) const;

    // Rules and declarations looked at since the beginning.
    std::size_t work() const { return work_; }

  private:
    struct Declared {
        std::string property;
        std::string value;
        Spot spot;  // of the value
        bool important = false;
    };

    void add_attributes(std::vector<Declared>& declared, pugi::xml_node node) const;
    void add_style_attribute(std::vector<Declared>& declared, pugi::xml_node node) const;
    std::vector<Declared> cascade(pugi::xml_node node) const;
    void apply(SvgStyle& style, const Declared& declared) const;
    void set(SvgStyle& style, const Declared& declared) const;
    SvgInk ink(const Declared& declared) const;
    SvgInk server_ink(const SvgPaint& paint, const Declared& declared) const;
    std::vector<pugi::xml_node> stops(pugi::xml_node gradient) const;
    SvgColour stop_colour(pugi::xml_node stop) const;

    const SvgDocument& document_;
    Report& report_;
    CssSheet sheet_;
    mutable std::size_t work_ = 0;
};

// The blank-separated words of a class attribute.
std::vector<std::string_view> class_tokens(std::string_view text);

}  // namespace edaha::svg
