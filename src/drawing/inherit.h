// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <variant>
#include <vector>

#include "drawing/drawing.h"

namespace edaha {

// What a node is drawn with once its parents have been asked. As it starts: the root's, nothing.
struct InheritedPaint {
    std::optional<Colour> fill;
    std::optional<Colour> stroke;
    double stroke_width_mm = 0;
    double dash_mm = 0;
    float fill_opacity = 1;
    float stroke_opacity = 1;
    bool operator==(const InheritedPaint&) const = default;
};

// The rules of Paint, applied once.
InheritedPaint inherit(const InheritedPaint& parent, const Paint& own);

// Every shape and instance below, in paint order, with the paint that it ends up with:
// visit(const Shape&, const InheritedPaint&) and visit(const Use&, const InheritedPaint&).
template <class Visit>
void for_each_painted(const std::vector<Element>& elements, const InheritedPaint& parent,
                      const Visit& visit) {
    for (const Element& element : elements) {
        if (const auto* shape = std::get_if<Shape>(&element)) {
            visit(*shape, inherit(parent, shape->paint));
        } else if (const auto* use = std::get_if<Use>(&element)) {
            visit(*use, inherit(parent, use->paint));
        } else {
            const auto& group = std::get<Group>(element);
            for_each_painted(group.children, inherit(parent, group.paint), visit);
        }
    }
}

}  // namespace edaha
