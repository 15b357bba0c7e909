// SPDX-License-Identifier: MIT
#include "drawing/ink_box.h"

#include <glm/common.hpp>

namespace edaha {
namespace {

Bounds box_of(const Path& path, const Paint& paint) {
    Bounds box = bounds(path);
    if (paint.stroke.kind == Ink::Kind::colour) {
        box.min -= paint.stroke_width_mm / 2;
        box.max += paint.stroke_width_mm / 2;
    }
    return box;
}

Paint merged(Paint paint, const Paint& own) {
    if (own.stroke.kind != Ink::Kind::inherit) paint.stroke = own.stroke;
    if (own.stroke_width_mm > 0) paint.stroke_width_mm = own.stroke_width_mm;
    return paint;
}

}  // namespace

InkBoxes::InkBoxes(const Drawing& drawing) : drawing_(drawing) {
    for (const Symbol& symbol : drawing.symbols) {
        Bounds& box = symbols_.emplace_back();
        for (const Shape& shape : symbol.shapes)
            box.include(box_of(shape.path, shape.paint));
    }
}

Bounds InkBoxes::of_all() const {
    Bounds box;
    for (const Layer& layer : drawing_.layers)
        box.include(of(layer));
    return box;
}

Bounds InkBoxes::of(const Layer& layer) const {
    Bounds box;
    include(box, layer.children, layer.paint);
    return box;
}

void InkBoxes::include(Bounds& box, const std::vector<Element>& elements,
                       const Paint& inherited) const {
    for (const Element& element : elements) {
        if (const auto* group = std::get_if<Group>(&element)) {
            include(box, group->children, merged(inherited, group->paint));
        } else if (const auto* use = std::get_if<Use>(&element)) {
            include(box, *use);
        } else {
            const auto& shape = std::get<Shape>(element);
            box.include(box_of(shape.path, merged(inherited, shape.paint)));
        }
    }
}

void InkBoxes::include(Bounds& box, const Use& use) const {
    const Bounds& b = symbols_[use.symbol];
    if (b.empty()) return;
    // Rounding keeps order: these are the very numbers that the four corners give.
    const Affine& map = use.page_from_symbol;
    const Vec2 left = map[0] * b.min.x, right = map[0] * b.max.x;
    const Vec2 top = map[1] * b.min.y, bottom = map[1] * b.max.y;
    box.include(glm::min(left, right) + glm::min(top, bottom) + map[2]);
    box.include(glm::max(left, right) + glm::max(top, bottom) + map[2]);
}

}  // namespace edaha
