// SPDX-License-Identifier: MIT
#include "drawing/mosaic.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "drawing/check.h"

namespace edaha {
namespace {

bool same_path(const Path& a, const Path& b) {
    return a.verbs == b.verbs && a.points == b.points;
}

bool same_shapes(const Symbol& a, const Symbol& b) {
    return std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(),
                      [](const Shape& x, const Shape& y) {
                          return x.paint == y.paint && same_path(x.path, y.path);
                      });
}

bool takes_pen(const Symbol& symbol) {
    return std::any_of(symbol.shapes.begin(), symbol.shapes.end(), [](const Shape& shape) {
        return shape.paint.stroke.kind != Ink::Kind::none && shape.paint.stroke_width_mm == 0;
    });
}

bool near(Vec2 a, Vec2 b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) <= kShortestSegment_mm;
}

// Maps a path and leaves out what gets too short for the contract: segments, and subpaths without
// any.
class PathMapper {
  public:
    explicit PathMapper(const Affine& map) : map_(map) {}

    Path operator()(const Path& path) {
        const Vec2* p = path.points.data();
        for (const Verb verb : path.verbs) {
            if (verb == Verb::close) {
                if (!pending_) result_.close();
                continue;
            }
            const Vec2 first = transform(map_, *p++);
            if (verb == Verb::move) {
                at_ = first;
                pending_ = true;
            } else if (verb == Verb::line) {
                if (begin(near(at_, first))) result_.line_to(at_ = first);
            } else {
                const Vec2 second = transform(map_, p[0]), end = transform(map_, p[1]);
                p += 2;
                const bool is_short = near(at_, first) && near(at_, second) && near(at_, end);
                if (begin(is_short)) result_.cubic_to(first, second, at_ = end);
            }
        }
        return std::move(result_);
    }

  private:
    // Whether the segment is drawn; the move goes before the first that is.
    bool begin(bool is_short) {
        if (is_short) return false;
        if (std::exchange(pending_, false)) result_.move_to(at_);
        return true;
    }

    const Affine& map_;
    Path result_;
    Vec2 at_{0, 0};
    bool pending_ = false;
};

}  // namespace

Mosaic::Mosaic(Drawing& page, bool keep_ids) : page_(page), keep_ids_(keep_ids) {}

std::string Mosaic::unique(const std::string& wanted) {
    if (wanted.empty()) return wanted;
    std::string id = wanted;
    for (int number = 2; !ids_.insert(id).second; ++number)
        id = wanted + '-' + std::to_string(number);
    return id;
}

Group Mosaic::group_of(const Tile& tile, double scale, Vec2 offset, std::vector<Element> card) {
    prefix_ = tile.id + '.';
    scale_ = scale;
    map_ = Affine(Vec2(scale, 0), Vec2(0, scale), offset);
    take_symbols(tile.drawing);
    Group group{unique(tile.id), {}, std::move(card)};
    for (const Layer& layer : tile.drawing.layers) {
        if (layer.label == kBackgroundLabel) continue;
        Group own{id_of(layer.id()), mapped(layer.paint),
                  mapped(layer.children, inherit({}, layer.paint))};
        if (!own.children.empty()) group.children.emplace_back(std::move(own));
    }
    return group;
}

void Mosaic::take_symbols(const Drawing& drawing) {
    symbols_.clear();
    for (const Symbol& symbol : drawing.symbols)
        symbols_.push_back(take_symbol(symbol));
}

std::uint32_t Mosaic::take_symbol(const Symbol& symbol) {
    for (const Known& known : known_) {
        if (known.name == symbol.id && same_shapes(page_.symbols[known.index], symbol))
            return known.index;
    }
    const auto index = static_cast<std::uint32_t>(page_.symbols.size());
    known_.push_back({symbol.id, index});
    takes_pen_.push_back(takes_pen(symbol));
    Symbol& taken = page_.symbols.emplace_back(symbol);
    // Instances name it thousands of times: without the tiles' ids, as short as can be.
    taken.id = unique(keep_ids_ ? symbol.id : "s");
    for (Shape& shape : taken.shapes)
        shape.id = keep_ids_ ? unique(shape.id) : "";
    return index;
}

std::string Mosaic::id_of(const std::string& id) {
    return keep_ids_ && !id.empty() ? unique(prefix_ + id) : "";
}

std::vector<Element> Mosaic::mapped(const std::vector<Element>& elements,
                                    const InheritedPaint& parent) {
    std::vector<Element> result;
    result.reserve(elements.size());
    for (const Element& element : elements) {
        if (const auto* group = std::get_if<Group>(&element)) {
            Group own = mapped(*group, parent);
            if (own.id.empty() && own.paint == Paint{}) {  // holds nothing together any more
                std::move(own.children.begin(), own.children.end(), std::back_inserter(result));
            } else if (!own.children.empty()) {
                result.emplace_back(std::move(own));
            }
        } else if (const auto* use = std::get_if<Use>(&element)) {
            result.emplace_back(mapped(*use, parent));
        } else {
            Shape shape = mapped(std::get<Shape>(element));
            if (!shape.path.empty()) result.emplace_back(std::move(shape));
        }
    }
    return result;
}

Group Mosaic::mapped(const Group& group, const InheritedPaint& parent) {
    return {id_of(group.id), mapped(group.paint),
            mapped(group.children, inherit(parent, group.paint))};
}

Shape Mosaic::mapped(const Shape& shape) {
    return {id_of(shape.id), PathMapper(map_)(shape.path), mapped(shape.paint)};
}

// A pen that the instance is given from above is in the symbol's own units: it must not shrink with
// the page.
Use Mosaic::mapped(const Use& use, const InheritedPaint& parent) const {
    Use result{symbols_[use.symbol], compose(map_, use.page_from_symbol), use.paint};
    if (use.paint.stroke_width_mm == 0 && scale_ != 1 && takes_pen_[result.symbol])
        result.paint.stroke_width_mm = parent.stroke_width_mm;
    return result;
}

Paint Mosaic::mapped(Paint paint) const {
    scale_pen(paint, scale_);
    return paint;
}

}  // namespace edaha
