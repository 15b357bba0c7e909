// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/growing_mesh.h"

namespace edaha {

// Round a face, in single precision and a little wider than it.
struct FaceBox {
    std::array<float, 3> low{1, 1, 1}, high{-1, -1, -1};  // empty

    bool empty() const { return low[0] > high[0]; }

    bool meets(const FaceBox& other) const {
        bool meets = true;
        for (std::size_t k = 0; k < 3; ++k)
            meets = meets && low[k] <= other.high[k] && other.low[k] <= high[k];
        return meets;
    }
};

FaceBox box_round(const Vec3& low, const Vec3& high);
FaceBox box_round(const Vec3& a, const Vec3& b, const Vec3& c);

// The faces of a mesh in cubic cells of equal size, to be found by where they are. A face is in
// all cells that its box meets; cells share buckets by a hash. Does not follow the mesh as it
// changes: made anew each step. O(faces) while faces are no larger than a few cells.
class FaceGrid {
  public:
    FaceGrid(const GrowingMesh& mesh, double cell_mm);
    // Of boxes that faces take up on their way, one a face; empty ones are in no cell.
    FaceGrid(std::span<const FaceBox> boxes, double cell_mm);

    // Calls visit(face) for each face whose box meets this one, in an order that depends on the
    // mesh alone; those in several cells several times.
    template <typename Visit>
    void visit(const FaceBox& box, const Visit& visit) const {
        visit_of(
            box, [](std::uint32_t) { return true; }, visit);
    }
    // The same, of the buckets that are wanted.
    template <typename Wants, typename Visit>
    void visit_of(const FaceBox& box, const Wants& wants, const Visit& visit) const;

    std::span<const std::uint32_t> faces_in(std::size_t bucket) const {
        return std::span(faces_).subspan(start_[bucket], start_[bucket + 1] - start_[bucket]);
    }

    // Each pair of faces whose boxes meet lies in just one bucket.
    std::size_t buckets() const { return start_.size() - 1; }
    template <typename Visit>
    void visit_pairs(std::size_t bucket, const Visit& visit) const;

  private:
    using Cell = std::array<std::int32_t, 3>;

    Cell cell_of(const std::array<float, 3>& point) const {
        Cell cell{};
        for (std::size_t k = 0; k < 3; ++k)
            cell[k] = static_cast<std::int32_t>(std::floor(point[k] * per_mm_));
        return cell;
    }
    std::uint32_t bucket_of(const Cell& cell) const {
        std::uint32_t key = static_cast<std::uint32_t>(cell[0]) * 0x9e3779b1U;
        key = (key ^ (key >> 15U)) + static_cast<std::uint32_t>(cell[1]) * 0x85ebca77U;
        key = (key ^ (key >> 13U)) + static_cast<std::uint32_t>(cell[2]) * 0xc2b2ae3dU;
        return (key ^ (key >> 16U)) & mask_;
    }
    template <typename Visit>
    void visit_cells(const FaceBox& box, const Visit& visit) const {
        const Cell first = cell_of(box.low), last = cell_of(box.high);
        for (std::int32_t i = first[0]; i <= last[0]; ++i)
            for (std::int32_t j = first[1]; j <= last[1]; ++j)
                for (std::int32_t k = first[2]; k <= last[2]; ++k)
                    visit(Cell{i, j, k});
    }
    template <typename Visit>
    void visit_buckets(const FaceBox& box, const Visit& visit) const;

    float per_mm_;
    std::uint32_t mask_ = 0;
    std::vector<std::uint32_t> start_;  // a bucket: where its faces begin
    std::vector<std::uint32_t> faces_;
    std::vector<FaceBox> boxes_;  // theirs, in the same order
};

template <typename Wants, typename Visit>
void FaceGrid::visit_of(const FaceBox& box, const Wants& wants, const Visit& visit) const {
    visit_cells(box, [&](const Cell& cell) {
        const std::uint32_t bucket = bucket_of(cell);
        if (!wants(bucket)) return;
        for (std::uint32_t i = start_[bucket]; i < start_[bucket + 1]; ++i)
            if (boxes_[i].meets(box)) visit(faces_[i]);
    });
}

template <typename Visit>
void FaceGrid::visit_pairs(std::size_t bucket, const Visit& visit) const {
    for (std::uint32_t i = start_[bucket]; i < start_[bucket + 1]; ++i) {
        const FaceBox& one = boxes_[i];
        for (std::uint32_t j = i + 1; j < start_[bucket + 1]; ++j) {
            const FaceBox& other = boxes_[j];
            if (!one.meets(other)) continue;
            // Both are in the cell of the lowest corner of what they have in common.
            std::array<float, 3> corner{};
            for (std::size_t k = 0; k < 3; ++k)
                corner[k] = std::max(one.low[k], other.low[k]);
            if (bucket_of(cell_of(corner)) == bucket) visit(faces_[i], faces_[j]);
        }
    }
}

}  // namespace edaha
