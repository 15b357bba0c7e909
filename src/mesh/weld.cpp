// SPDX-License-Identifier: MIT
#include "mesh/weld.h"

#include <bit>

#include "mesh/edges.h"

namespace edaha {
namespace {

// The first point at each place of each part: open addressing, at most half full.
class PlaceTable {
  public:
    PlaceTable(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& part_of_point,
               std::size_t count)
        : points_(points),
          part_of_point_(part_of_point),
          slots_(std::bit_ceil(2 * count + 2), kNone) {}

    std::uint32_t first_at_place_of(std::uint32_t point) {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash(point) & mask;; slot = (slot + 1) & mask) {
            std::uint32_t& held = slots_[slot];
            if (held == kNone) held = point;
            if (held == point || same(held, point)) return held;
        }
    }

  private:
    bool same(std::uint32_t a, std::uint32_t b) const {
        return points_[a] == points_[b] && part_of_point_[a] == part_of_point_[b];
    }

    std::size_t hash(std::uint32_t point) const {
        std::uint64_t state = part_of_point_[point];
        for (int axis = 0; axis < 3; ++axis) {
            const double place = points_[point][axis] + 0.0;  // -0 is 0
            state = (state ^ std::bit_cast<std::uint64_t>(place)) * 0x9e3779b97f4a7c15ULL;
            state ^= state >> 32;
        }
        return static_cast<std::size_t>(state);
    }

    const std::vector<Vec3>& points_;
    const std::vector<std::uint32_t>& part_of_point_;
    std::vector<std::uint32_t> slots_;
};

std::vector<std::uint32_t> parts_of_points(const Mesh& mesh) {
    std::vector<std::uint32_t> part_of_point(mesh.points.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::uint32_t point : mesh.triangles[t])
            part_of_point[point] = mesh.part_of[t];
    }
    return part_of_point;
}

// In their order.
std::vector<std::uint32_t> points_of_open_edges(const Mesh& mesh) {
    std::vector<char> is_open(mesh.points.size(), 0);
    for (const MeshEdge& edge : mesh_edges(mesh)) {
        if (edge.left == kNone || edge.right == kNone) is_open[edge.a] = is_open[edge.b] = 1;
    }
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < is_open.size(); ++i) {
        if (is_open[i] != 0) open.push_back(i);
    }
    return open;
}

}  // namespace

void weld_open(Mesh& mesh) {
    const std::vector<std::uint32_t> open = points_of_open_edges(mesh);
    if (open.empty()) return;
    const std::vector<std::uint32_t> part_of_point = parts_of_points(mesh);
    PlaceTable table(mesh.points, part_of_point, open.size());
    std::vector<std::uint32_t> joined(mesh.points.size(), kNone);
    for (const std::uint32_t point : open)
        joined[point] = table.first_at_place_of(point);
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& point : triangle) {
            if (joined[point] != kNone) point = joined[point];
        }
    }
    drop_unused_points(mesh);
}

void drop_unused_points(Mesh& mesh) {
    std::vector<std::uint32_t> place(mesh.points.size(), kNone);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t point : triangle)
            place[point] = 0;
    }
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (place[i] == kNone) continue;
        mesh.points[kept] = mesh.points[i];
        place[i] = kept++;
    }
    mesh.points.resize(kept);
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& point : triangle)
            point = place[point];
    }
}

}  // namespace edaha
