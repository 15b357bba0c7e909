// SPDX-License-Identifier: MIT
#include "app/overlap.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <glm/common.hpp>

#include "geometry/bit_raster.h"
#include "geometry/bounds.h"

namespace edaha {
namespace {

// Samples that lie in the tree, counted as often as it has layers there. A quarter of them errs by
// up to 0.009 where these err by 0.004; four times as many cost twice the time.
constexpr double kSamples = 1 << 15;
// Rows lie twice as far apart as that takes, samples within them half as far: a row costs as much
// as ten samples.
constexpr double kRowPitch = 2;
// Where the tree is next to nothing on its page: this bounds the raster to 2 MB.
constexpr double kMostRows = 4096;
// Of limbs' outlines, in samples: less makes no difference to the ratio. (For leaves it does:
// chords lie inside of round shapes, and a leaf of 64 samples' length would lose a hundredth of its
// area.)
constexpr double kTolerance = 0.1;
// Samples along and across a leaf, finer than the page's.
constexpr int kStampSide = 64;

// Of the points: a little more than the curve's.
Bounds box_of(const Path& path) {
    Bounds box;
    for (const Vec2 p : path.points)
        box.include(p);
    return box;
}

// Of the polygons through a path's nodes: enough to choose a pitch by. Taken from where each
// starts, so that the way back there adds nothing.
double rough_area(const Path& path) {
    double twice = 0;
    Vec2 start(0), at(0);
    const Vec2* p = path.points.data();
    for (const Verb verb : path.verbs) {
        if (verb == Verb::close) continue;
        p += verb == Verb::cubic ? 3 : 1;
        const Vec2 to = p[-1] - start;
        if (verb == Verb::move) {
            start = p[-1];
            at = Vec2(0);
        } else {
            twice += at.x * to.y - at.y * to.x;
            at = to;
        }
    }
    return std::abs(twice) / 2;
}

Affine raster_from(Vec2 origin, Vec2 pitch) {
    return {Vec2(1 / pitch.x, 0), Vec2(0, 1 / pitch.y), -origin / pitch};
}

// A leaf as one outline, so that what is drawn on its blade does not count.
struct LeafStamp {
    BitStamp stamp;
    Affine symbol_from_stamp;
    double area;  // in the symbol's units
};

LeafStamp stamp_of(const Symbol& symbol) {
    Bounds box;
    for (const Shape& shape : symbol.shapes)
        box.include(box_of(shape.path));
    const Vec2 origin = box.empty() ? Vec2(0) : box.min;
    const Vec2 pitch = Vec2(std::max(box.width(), 1e-9), std::max(box.height(), 1e-9)) /
                       static_cast<double>(kStampSide);
    BitRaster raster(kStampSide, kStampSide);
    for (const Shape& shape : symbol.shapes)
        raster.fill(shape.path, raster_from(origin, pitch));
    return {BitStamp(raster), Affine(Vec2(pitch.x, 0), Vec2(0, pitch.y), origin),
            static_cast<double>(raster.count()) * pitch.x * pitch.y};
}

class Overlap {
  public:
    explicit Overlap(const Drawing& drawing) {
        for (const Symbol& symbol : drawing.symbols)
            stamps_.push_back(stamp_of(symbol));
        for (const Layer& layer : drawing.layers) {
            if (layer.label != "Background" && layer.label != "Ground") add_all(layer.children);
        }
    }

    double ratio() const {
        const double extent = std::max(box_.width(), box_.height());
        if (!(area_ > 0) || !(extent > 0)) return 0;
        const double pitch = std::max(std::sqrt(area_ / kSamples), extent / kMostRows);
        const Vec2 pitches(pitch / kRowPitch, pitch * kRowPitch);
        BitRaster raster(static_cast<int>(box_.width() / pitches.x) + 1,
                         static_cast<int>(box_.height() / pitches.y) + 1);
        const Affine raster_from_page = raster_from(box_.min, pitches);
        std::int64_t covered = 0;
        for (const Path* path : paths_)
            covered += raster.fill(*path, raster_from_page, kTolerance);
        for (const Leaf& leaf : leaves_)
            covered += leaf.stamp->set_on(raster, compose(raster_from_page, leaf.page_from_stamp));
        if (covered == 0) return 0;
        return 1 - static_cast<double>(raster.count()) / static_cast<double>(covered);
    }

  private:
    struct Leaf {
        const BitStamp* stamp;
        Affine page_from_stamp;
    };

    void add_all(const std::vector<Element>& elements) {
        for (const Element& element : elements) {
            if (const auto* group = std::get_if<Group>(&element)) {
                add_all(group->children);
            } else if (const auto* use = std::get_if<Use>(&element)) {
                add(*use);
            } else {
                add(std::get<Shape>(element));
            }
        }
    }

    void add(const Use& use) {
        const LeafStamp& leaf = stamps_[use.symbol];
        const Affine& map = use.page_from_symbol;
        const Affine page_from_stamp = compose(map, leaf.symbol_from_stamp);
        const Vec2 along = page_from_stamp[0] * static_cast<double>(kStampSide);
        const Vec2 across = page_from_stamp[1] * static_cast<double>(kStampSide);
        const Vec2 zero(0), origin = page_from_stamp[2];
        box_.include(origin + glm::min(along, zero) + glm::min(across, zero));
        box_.include(origin + glm::max(along, zero) + glm::max(across, zero));
        area_ += leaf.area * std::abs(map[0].x * map[1].y - map[0].y * map[1].x);
        leaves_.push_back({&leaf.stamp, page_from_stamp});
    }

    void add(const Shape& shape) {
        const std::string_view id = shape.id;
        if (id.ends_with(".shade") || id.ends_with(".marks")) return;
        area_ += rough_area(shape.path);
        box_.include(box_of(shape.path));
        paths_.push_back(&shape.path);
    }

    std::vector<LeafStamp> stamps_;  // of the symbols
    std::vector<const Path*> paths_;
    std::vector<Leaf> leaves_;
    Bounds box_;
    double area_ = 0;
};

}  // namespace

double overlap_ratio(const Drawing& drawing) {
    return Overlap(drawing).ratio();
}

}  // namespace edaha
