// SPDX-License-Identifier: MIT
#include "mesh/triangulate.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

using Place2 = glm::dvec2;

Vec3 normal_of(std::span<const Vec3> polygon) {
    Vec3 sum(0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return sum;
}

// Leaves out the normal's longest axis, so that the polygon runs counter-clockwise.
std::vector<Place2> flat(std::span<const Vec3> polygon) {
    const Vec3 normal = normal_of(polygon);
    const Vec3 size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<Place2> places;
    places.reserve(polygon.size());
    for (const Vec3& point : polygon)
        places.push_back(normal[axis] < 0 ? Place2(point[v], point[u])
                                          : Place2(point[u], point[v]));
    return places;
}

// Twice the area of a, b, c; positive if they run counter-clockwise.
double turn(Place2 a, Place2 b, Place2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarCutter {
  public:
    explicit EarCutter(std::vector<Place2> places)
        : places_(std::move(places)),
          next_(places_.size()),
          previous_(places_.size()),
          is_ear_(places_.size()) {}

    std::vector<Triangle> run() {
        const auto count = static_cast<std::uint32_t>(places_.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            next_[i] = (i + 1) % count;
            previous_[i] = (i + count - 1) % count;
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            if (turn_at(i) <= 0) hollows_.push_back(i);
        }
        for (std::uint32_t i = 0; i < count; ++i)
            is_ear_[i] = looks_like_ear(i);
        cut(count);
        return std::move(triangles_);
    }

  private:
    double turn_at(std::uint32_t i) const {
        return turn(places_[previous_[i]], places_[i], places_[next_[i]]);
    }

    bool looks_like_ear(std::uint32_t i) const {
        if (!(turn_at(i) > 0)) return false;
        for (const std::uint32_t hollow : hollows_) {
            if (next_[hollow] != kCut && blocks(hollow, i)) return false;
        }
        return true;
    }

    // Points at a corner's own place don't: a hole's bridge has its ends twice.
    bool blocks(std::uint32_t point, std::uint32_t tip) const {
        const Place2 p = places_[point];
        const Place2 a = places_[previous_[tip]], b = places_[tip], c = places_[next_[tip]];
        if (p == a || p == b || p == c) return false;
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    }

    // Every second ear, round and round, which keeps the triangles from becoming a fan. A round
    // without an ear (the sides cross, or the rest is flat) cuts where it stands.
    void cut(std::uint32_t left) {
        std::uint32_t at = 0, idle = 0;
        while (left > 3) {
            if (!is_ear_[at] && idle < left) {
                at = next_[at];
                ++idle;
                continue;
            }
            at = cut_tip(at);
            --left;
            idle = 0;
        }
        triangles_.push_back({previous_[at], at, next_[at]});
    }

    // Returns where to go on.
    std::uint32_t cut_tip(std::uint32_t tip) {
        const std::uint32_t before = previous_[tip], after = next_[tip];
        triangles_.push_back({before, tip, after});
        next_[before] = after;
        previous_[after] = before;
        next_[tip] = kCut;
        is_ear_[before] = looks_like_ear(before);
        is_ear_[after] = looks_like_ear(after);
        return next_[after];
    }

    static constexpr std::uint32_t kCut = 0xffffffffu;
    std::vector<Place2> places_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<char> is_ear_;
    std::vector<std::uint32_t> hollows_;  // points that may lie in another's ear
    std::vector<Triangle> triangles_;
};

// Along the diagonal that lies inside, the shorter one if both do.
std::vector<Triangle> cut_quad(std::span<const Vec3> quad) {
    const std::vector<Place2> p = flat(quad);
    const bool first = turn(p[0], p[1], p[2]) > 0 && turn(p[0], p[2], p[3]) > 0;
    const bool second = turn(p[0], p[1], p[3]) > 0 && turn(p[1], p[2], p[3]) > 0;
    const bool shorter = glm::distance(quad[1], quad[3]) < glm::distance(quad[0], quad[2]);
    if (second && (shorter || !first)) return {{0, 1, 3}, {1, 2, 3}};
    return {{0, 1, 2}, {0, 2, 3}};
}

}  // namespace

std::vector<Triangle> triangulate(std::span<const Vec3> polygon) {
    if (polygon.size() < 3) return {};
    if (polygon.size() == 3) return {{0, 1, 2}};
    if (polygon.size() == 4) return cut_quad(polygon);
    return EarCutter(flat(polygon)).run();
}

}  // namespace edaha
