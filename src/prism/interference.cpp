// SPDX-License-Identifier: MIT
#include "prism/interference.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace edaha {
namespace {

// Touching isn't crossing: by this part of the larger prism's size.
constexpr double kTouch = 1e-6;

// Corners of each face, any three that span it, counter-clockwise seen from outside. A pyramid's
// top spans nothing; its sides are seen from their base.
constexpr int kFaces[5][3] = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {1, 2, 5}, {2, 0, 3}};
// With both diagonals of each side: bent ones bulge along one of them.
constexpr int kEdges[15][2] = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4},
                               {2, 5}, {0, 4}, {1, 3}, {1, 5}, {2, 4}, {2, 3}, {0, 5}};

struct Plane {
    Vec3 outward;  // of length 1, or 0 where there is no face
    double offset;
};

std::array<Plane, 5> planes_of(const PrismCorners& c, double shrunk_by) {
    std::array<Plane, 5> planes;
    for (std::size_t i = 0; i < 5; ++i) {
        const auto& [p, q, r] = kFaces[i];
        const auto at = [&](int k) { return c[static_cast<std::size_t>(k)]; };
        const Vec3 normal = glm::cross(at(q) - at(p), at(r) - at(p));
        const double size = glm::length(normal);
        const Vec3 outward = size > 0 ? normal / size : Vec3(0);
        double offset = glm::dot(outward, at(p));
        for (const Vec3& corner : c)  // beyond the plane where a side is bent
            offset = std::max(offset, glm::dot(outward, corner));
        planes[i] = {outward, offset - (size > 0 ? shrunk_by : 0)};
    }
    return planes;
}

// Whether part of the segment lies behind all planes.
bool enters(Vec3 from, Vec3 to, const std::array<Plane, 5>& planes) {
    double first = 0, last = 1;
    for (const Plane& plane : planes) {
        const double f = glm::dot(plane.outward, from) - plane.offset;
        const double t = glm::dot(plane.outward, to) - plane.offset;
        if (f <= 0 && t <= 0) continue;
        if (f > 0 && t > 0) return false;
        const double at = f / (f - t);
        if (f > 0) {
            first = std::max(first, at);
        } else {
            last = std::min(last, at);
        }
        if (first > last) return false;
    }
    return true;
}

// Its axis counts as an edge: bodies that share all their sides are found by that.
bool any_edge_enters(const PrismCorners& c, const std::array<Plane, 5>& planes) {
    if (enters((c[0] + c[1] + c[2]) / 3.0, (c[3] + c[4] + c[5]) / 3.0, planes)) return true;
    return std::ranges::any_of(kEdges, [&](const auto& edge) {
        return enters(c[static_cast<std::size_t>(edge[0])], c[static_cast<std::size_t>(edge[1])],
                      planes);
    });
}

double size_of(const PrismCorners& c) {
    return glm::distance(c[0], c[3]) + glm::distance(c[0], c[1]);
}

}  // namespace

// Of two convex bodies that overlap, an edge of one enters the other, or they share their sides.
bool overlap(const PrismCorners& a, const PrismCorners& b) {
    const double touch = kTouch * std::max(size_of(a), size_of(b));
    return any_edge_enters(a, planes_of(b, touch)) || any_edge_enters(b, planes_of(a, touch));
}

StandingPrisms::Box StandingPrisms::box_of(const PrismCorners& corners) {
    Box box{corners[0], corners[0]};
    for (const Vec3& corner : corners)
        box = {glm::min(box.low, corner), glm::max(box.high, corner)};
    return box;
}

StandingPrisms::Cells StandingPrisms::cells_of(const Box& box, int level) {
    const double cells_per_mm = std::ldexp(1.0, -level);
    const auto first = glm::floor(box.low * cells_per_mm);
    return {first, glm::floor(box.high * cells_per_mm) - first + 1.0, level};
}

// Cells go by a hash: two may share one, which only costs time.
template <class Visit>
void StandingPrisms::visit_cells(const Cells& cells, Visit&& visit) {
    const auto key = [](double x) { return static_cast<Key>(static_cast<std::int64_t>(x)); };
    const Key all = step(0, key(cells.level));
    for (double i = 0; i < cells.count.x; ++i) {
        const Key column = step(all, key(cells.first.x + i));
        for (double j = 0; j < cells.count.y; ++j) {
            const Key row = step(column, key(cells.first.y + j));
            for (double k = 0; k < cells.count.z; ++k)
                visit(step(row, key(cells.first.z + k)));
        }
    }
}

bool StandingPrisms::in_the_way(const PrismCorners& corners, std::int32_t parent) const {
    const Standing prism{corners, box_of(corners), parent};
    const auto among = [&](const std::vector<std::uint32_t>& others) {
        return std::ranges::any_of(others, [&](std::uint32_t other) {
            const bool kin = std::cmp_equal(other, parent) || prisms_[other].parent == parent;
            return !kin && meets(prisms_[other], prism);
        });
    };
    for (const auto& [level, members] : levels_) {
        const Cells cells = cells_of(prism.box, level);
        bool found = false;
        // Far smaller ones than this are sooner looked through than their cells.
        if (cells.count.x * cells.count.y * cells.count.z > static_cast<double>(members.size())) {
            found = among(members);
        } else {
            visit_cells(cells, [&](Key cell) {
                const auto here = cells_.find(cell);
                found = found || (here != cells_.end() && among(here->second));
            });
        }
        if (found) return true;
    }
    return false;
}

bool StandingPrisms::meets(const Standing& other, const Standing& prism) {
    const Vec3 gap = glm::max(other.box.low - prism.box.high, prism.box.low - other.box.high);
    return std::max({gap.x, gap.y, gap.z}) < 0 && overlap(other.corners, prism.corners);
}

void StandingPrisms::add(const PrismCorners& corners, std::int32_t parent) {
    const Box box = box_of(corners);
    const Vec3 extent = box.high - box.low;
    const int level = std::ilogb(std::max({extent.x, extent.y, extent.z})) + 1;
    const auto index = static_cast<std::uint32_t>(prisms_.size());
    levels_[level].push_back(index);
    visit_cells(cells_of(box, level), [&](Key cell) { cells_[cell].push_back(index); });
    prisms_.push_back({corners, box, parent});
}

}  // namespace edaha
