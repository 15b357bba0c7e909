// SPDX-License-Identifier: MIT
#include "drawing/statistics.h"

#include "drawing/subpaths.h"

namespace edaha {
namespace {

void add_elements(DrawingCounts& counts, const std::vector<Element>& elements) {
    for (const Element& element : elements) {
        if (const auto* shape = std::get_if<Shape>(&element)) {
            ++counts.shapes;
            counts.nodes += node_count(shape->path);
        } else if (const auto* group = std::get_if<Group>(&element)) {
            ++counts.groups;
            add_elements(counts, group->children);
        } else {
            ++counts.uses;
        }
    }
}

}  // namespace

DrawingCounts count(const Drawing& drawing) {
    DrawingCounts counts;
    counts.layers = drawing.layers.size();
    counts.symbols = drawing.symbols.size();
    for (const Symbol& symbol : drawing.symbols) {
        for (const Shape& shape : symbol.shapes)
            counts.nodes += node_count(shape.path);
    }
    for (const Layer& layer : drawing.layers)
        add_elements(counts, layer.children);
    return counts;
}

}  // namespace edaha
