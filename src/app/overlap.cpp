// SPDX-License-Identifier: MIT
#include "app/overlap.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "geometry/measure.h"
#include "geometry/unite.h"

namespace edaha {
namespace {

// Well below a twig's width, 0.2 mm and more: areas are right to a few parts in a thousand.
constexpr double kTolerance_mm = 0.04;

double determinant(const Affine& map) {
    return map[0].x * map[1].y - map[0].y * map[1].x;
}

class Overlap {
  public:
    explicit Overlap(const Drawing& drawing) {
        for (const Symbol& symbol : drawing.symbols) {
            outlines_.push_back(outline(symbol));
            areas_.push_back(area_of_union(std::span(&outlines_.back(), 1), kTolerance_mm));
        }
        for (const Layer& layer : drawing.layers) {
            if (layer.label != "Background" && layer.label != "Ground") add_all(layer.children);
        }
    }

    double ratio() const {
        return sum_ > 0 ? std::max(0.0, 1 - area_of_union(shapes_, kTolerance_mm) / sum_) : 0;
    }

  private:
    // A leaf as one outline, so that what is drawn on its blade does not count. In its own units,
    // ten of which are its length: of the same order as millimetres.
    static Path outline(const Symbol& symbol) {
        std::vector<Path> paths;
        for (const Shape& shape : symbol.shapes)
            paths.push_back(shape.path);
        UniteParams params;
        params.tolerance = kTolerance_mm;
        return unite(paths, params);
    }

    void add_all(const std::vector<Element>& elements) {
        for (const Element& element : elements) {
            if (const auto* group = std::get_if<Group>(&element)) {
                add_all(group->children);
            } else if (const auto* use = std::get_if<Use>(&element)) {
                sum_ += areas_[use->symbol] * std::abs(determinant(use->page_from_symbol));
                shapes_.push_back(transformed(use->page_from_symbol, outlines_[use->symbol]));
            } else {
                add(std::get<Shape>(element));
            }
        }
    }

    void add(const Shape& shape) {
        const std::string_view id = shape.id;
        if (id.ends_with(".shade") || id.ends_with(".marks")) return;
        sum_ += area_of_union(std::span(&shape.path, 1), kTolerance_mm);
        shapes_.push_back(shape.path);
    }

    std::vector<Path> outlines_;  // of the symbols
    std::vector<double> areas_;
    std::vector<Path> shapes_;
    double sum_ = 0;
};

}  // namespace

double overlap_ratio(const Drawing& drawing) {
    return Overlap(drawing).ratio();
}

}  // namespace edaha
