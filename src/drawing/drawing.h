// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drawing/paint.h"
#include "geometry/path.h"

namespace edaha {

// The 2D picture between growth and the writers. Contract, asserted by check(Drawing):
//   - millimetres, y down, origin at the page's top left; every curve inside the page, with half
//     its stroke's width;
//   - paths are absolute move/line/cubic/close, finite, without zero-length segments; every subpath
//     starts with a move and has a segment; filled ones are closed (by a way back of any length);
//   - a filled path of several subpaths starts with an outline: positive by signed_area(); each
//     hole, negative, lies within the box of the outlines before it. One subpath may run either
//     way;
//   - paint order is list order; paint that a node leaves unset is its parent's; a stroke that is
//     drawn has a width above 0, and one of an instance no dashes;
//   - instances name a symbol that exists, and their maps are finite and invertible;
//   - ids are unique, non-empty for layers and symbols, and XML names: [A-Za-z][A-Za-z0-9._-]*.
struct Shape {
    std::string id;  // may be empty: the writers then give none
    Path path;
    Paint paint;
};

// An instance of a symbol: page_from_symbol maps the symbol's own coordinates.
struct Use {
    std::uint32_t symbol = 0;  // index into Drawing::symbols
    Affine page_from_symbol{1, 0, 0, 1, 0, 0};
    Paint paint;
};

struct Element;

struct Group {
    std::string id;
    Paint paint;
    std::vector<Element> children;
};

struct Element : std::variant<Shape, Use, Group> {
    using variant::variant;
};

// A drawing used many times (a leaf). Shapes whose fill is unset take the instance's.
struct Symbol {
    std::string id;
    std::vector<Shape> shapes;
};

// The label with everything but ASCII letters, digits, . _ - replaced by `-`.
std::string id_from_label(std::string_view label);

// The layer that holds the painted paper, if there is one: the lowest.
inline constexpr const char* kBackgroundLabel = "Background";

struct Layer {
    std::string label;  // as a person would name it: "Leaves behind"
    Paint paint;
    std::vector<Element> children;

    std::string id() const { return id_from_label(label); }
};

// What remakes the file. `style_xml` is the resolved style, complete, as edaha reads it.
struct Metadata {
    std::string title;
    std::string description;
    std::string command;
    std::string style_xml;
    std::string version;
    std::string recipe;  // fingerprint of all that decides the file's bytes but its format
    std::uint64_t seed = 0;
};

// A colour of the palette by its name, for the user who recolours: "Bark, light".
struct Swatch {
    std::string name;
    Colour colour;
};

struct Drawing {
    double width_mm = 0;
    double height_mm = 0;
    std::vector<Symbol> symbols;
    std::vector<Layer> layers;  // bottom first
    std::vector<Swatch> swatches;
    Metadata metadata;
};

}  // namespace edaha
