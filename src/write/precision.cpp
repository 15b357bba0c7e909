// SPDX-License-Identifier: MIT
#include "write/precision.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"

namespace edaha {
namespace {

void find_scales(const std::vector<Element>& elements, std::vector<double>& scales) {
    for (const Element& element : elements) {
        if (const auto* use = std::get_if<Use>(&element)) {
            double& scale = scales[use->symbol];
            scale = std::max(scale, largest_scale(use->page_from_symbol));
        } else if (const auto* group = std::get_if<Group>(&element)) {
            find_scales(group->children, scales);
        }
    }
}

}  // namespace

int page_decimals(double width_mm, double height_mm) {
    // The finest step that is not below a hundredth of a pixel.
    const double pixel_mm = std::max(width_mm, height_mm) / 1000;
    int decimals = 0;
    for (double step = 0.1; step >= pixel_mm / 100 && decimals < kMostDecimals; step /= 10) {
        ++decimals;
    }
    return decimals;
}

int decimals_at_scale(int decimals, double scale) {
    // By comparison, not by log10, whose last digit differs between libraries.
    for (; scale > 1 && decimals < kMostDecimals; scale /= 10)
        ++decimals;
    for (; scale <= 0.1 && decimals > 0; scale *= 10)
        --decimals;
    return decimals;
}

std::vector<SymbolPrecision> symbol_precision(const Drawing& drawing, int decimals) {
    std::vector<double> scales(drawing.symbols.size(), 0);
    for (const Layer& layer : drawing.layers)
        find_scales(layer.children, scales);
    std::vector<SymbolPrecision> precision;
    for (std::size_t i = 0; i < scales.size(); ++i) {
        const double scale = scales[i] > 0 ? scales[i] : 1;
        precision.push_back({decimals_at_scale(decimals, scale),
                             decimals_at_scale(decimals, extent(drawing.symbols[i]))});
    }
    return precision;
}

double largest_scale(const Affine& map) {
    const auto length = [](Vec2 v) { return std::sqrt(v.x * v.x + v.y * v.y); };
    return std::max(length(map[0]), length(map[1]));
}

double mean_scale(const Affine& map) {
    return std::sqrt(std::abs(map[0].x * map[1].y - map[0].y * map[1].x));
}

double extent(const Symbol& symbol) {
    double largest = 0;
    for (const Shape& shape : symbol.shapes) {
        for (const Vec2 p : shape.path.points) {
            largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
        }
    }
    return largest;
}

}  // namespace edaha
