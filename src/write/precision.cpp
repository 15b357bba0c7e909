// SPDX-License-Identifier: MIT
#include "write/precision.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"

namespace edaha {
namespace {

// A root keeps the order: it is drawn once, of the largest.
double largest_square(const Affine& map) {
    const auto square = [](Vec2 v) { return v.x * v.x + v.y * v.y; };
    return std::max(square(map[0]), square(map[1]));
}

void find_scales(const std::vector<Element>& elements, std::vector<double>& squares) {
    for (const Element& element : elements) {
        if (const auto* use = std::get_if<Use>(&element)) {
            double& square = squares[use->symbol];
            square = std::max(square, largest_square(use->page_from_symbol));
        } else if (const auto* group = std::get_if<Group>(&element)) {
            find_scales(group->children, squares);
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
    std::vector<double> squares(drawing.symbols.size(), 0);
    for (const Layer& layer : drawing.layers)
        find_scales(layer.children, squares);
    std::vector<SymbolPrecision> precision;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        const double scale = squares[i] > 0 ? std::sqrt(squares[i]) : 1;
        precision.push_back({decimals_at_scale(decimals, scale),
                             decimals_at_scale(decimals, extent(drawing.symbols[i]))});
    }
    return precision;
}

double largest_scale(const Affine& map) {
    return std::sqrt(largest_square(map));
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
