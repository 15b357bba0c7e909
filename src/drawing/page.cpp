// SPDX-License-Identifier: MIT
#include "drawing/page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "drawing/ink_box.h"

namespace edaha {
namespace {

void move(std::vector<Element>& elements, const Affine& map, double scale);

void move(Element& element, const Affine& map, double scale) {
    if (auto* group = std::get_if<Group>(&element)) {
        scale_pen(group->paint, scale);
        move(group->children, map, scale);
    } else if (auto* use = std::get_if<Use>(&element)) {
        use->page_from_symbol = compose(map, use->page_from_symbol);
    } else {
        auto& shape = std::get<Shape>(element);
        scale_pen(shape.paint, scale);
        for (Vec2& point : shape.path.points)
            point = transform(map, point);
    }
}

void move(std::vector<Element>& elements, const Affine& map, double scale) {
    constexpr std::size_t kWorthThreads = 4096;  // a tenth of a millisecond
    for_each_index(elements.size(), kWorthThreads,
                   [&](std::size_t i) { move(elements[i], map, scale); });
}

Layer background(const Drawing& drawing, Colour paper) {
    Path path;
    path.move_to({0, 0});
    path.line_to({drawing.width_mm, 0});
    path.line_to({drawing.width_mm, drawing.height_mm});
    path.line_to({0, drawing.height_mm});
    path.close();
    Layer layer{kBackgroundLabel, {}, {}};
    layer.paint.fill = paper;
    layer.children.emplace_back(Shape{"paper", path, {}});
    return layer;
}

}  // namespace

Drawing on_page(Drawing drawing, const PageParams& page, const Palette& palette) {
    const Bounds box = InkBoxes(drawing).of_all();
    return on_page(std::move(drawing), box, page, palette);
}

Drawing on_page(Drawing drawing, const Bounds& box, const PageParams& page,
                const Palette& palette) {
    std::erase_if(drawing.layers, [](const Layer& layer) { return layer.children.empty(); });
    const double longer = std::max({box.width(), box.height(), 1e-6});
    const double room = std::max(page.size_mm - 2 * page.margin_mm, 0.1 * page.size_mm);
    const double scale = page.size_mm > 0 ? room / longer : 1;
    // A margin that leaves no room gives way to the tree.
    const double margin = page.size_mm > 0 ? (page.size_mm - room) / 2 : page.margin_mm;
    const Vec2 offset = Vec2(margin, margin) - (box.empty() ? Vec2(0, 0) : box.min) * scale;
    const Affine map(Vec2(scale, 0), Vec2(0, scale), offset);
    for (Layer& layer : drawing.layers) {
        scale_pen(layer.paint, scale);
        move(layer.children, map, scale);
    }
    // Hundredths of a millimetre, so that sizes read well and are exact as text.
    drawing.width_mm = std::ceil((box.width() * scale + 2 * margin) * 100 - 1e-6) / 100;
    drawing.height_mm = std::ceil((box.height() * scale + 2 * margin) * 100 - 1e-6) / 100;
    if (page.background)
        drawing.layers.insert(drawing.layers.begin(), background(drawing, palette.paper));
    return drawing;
}

}  // namespace edaha
