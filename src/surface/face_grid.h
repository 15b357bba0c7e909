// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/growing_mesh.h"

namespace edaha {

// Round a face, in single precision and a little wider than it. Of four numbers a corner, the last
// 0, so that the hot tests below become a few vector instructions.
struct FaceBox {
    std::array<float, 4> low{1, 1, 1, 0}, high{-1, -1, -1, 0};  // empty

    bool empty() const { return low[0] > high[0]; }
    bool meets(const FaceBox& other) const {
        int apart = 0;
        for (std::size_t k = 0; k < 4; ++k)
            apart |= int(low[k] > other.high[k]) | int(other.low[k] > high[k]);
        return apart == 0;
    }
    bool holds(const FaceBox& other) const {
        int out = 0;
        for (std::size_t k = 0; k < 4; ++k)
            out |= int(low[k] > other.low[k]) | int(other.high[k] > high[k]);
        return out == 0;
    }
};

FaceBox box_round(const Vec3& low, const Vec3& high);
FaceBox box_round(const Vec3& a, const Vec3& b, const Vec3& c);

// Faces in cubic cells of equal size, to be found by where they are. A face is in all cells that
// its box meets; cells share buckets by a hash. Boxes are kept `slack_mm` wider than they were
// given, so that faces that creep stay where they are: what is found may be that far off. O(1) a
// change while faces are no larger than a few cells.
class FaceGrid {
  public:
    FaceGrid(double cell_mm, double slack_mm);
    FaceGrid(const GrowingMesh& mesh, double cell_mm);  // of all its faces, without slack

    // A face is in this box from now on; in none if that is empty.
    void put(std::uint32_t f, const FaceBox& box);
    // The same of each face by its number; those beyond are in none.
    void put_all(std::span<const FaceBox> boxes);

    // Faces get these numbers, kNone where they go.
    void renumber(std::span<const std::uint32_t> number);

    // Calls visit(face) for each face whose box meets this one, once (those in more than 64 cells
    // perhaps again), in an order that depends on the calls alone that made the grid.
    template <typename Visit>
    void visit(const FaceBox& box, const Visit& visit) const;

    // Each pair of faces whose boxes meet lies in just one bucket.
    std::size_t buckets() const { return buckets_.size(); }
    template <typename Visit>
    void visit_pairs(std::size_t bucket, const Visit& visit) const;

  private:
    using Cell = std::array<std::int32_t, 3>;
    struct Entry {
        FaceBox box;
        std::uint32_t face;
    };

    Cell cell_of(const std::array<float, 4>& point) const {
        Cell cell{};
        for (std::size_t k = 0; k < 3; ++k) {  // the floor: without a function, as it is a hot spot
            const float at = point[k] * per_mm_;
            const auto whole = static_cast<std::int32_t>(at);
            cell[k] = whole - static_cast<std::int32_t>(at < static_cast<float>(whole));
        }
        return cell;
    }
    // Both are in the cell of the lowest corner of what they have in common.
    Cell common_cell(const FaceBox& one, const FaceBox& other) const {
        std::array<float, 4> corner{};
        for (std::size_t k = 0; k < 4; ++k)
            corner[k] = std::max(one.low[k], other.low[k]);
        return cell_of(corner);
    }
    std::size_t bucket_of(const Cell& cell) const {
        std::uint32_t key = static_cast<std::uint32_t>(cell[0]) * 0x9e3779b1U;
        key = (key ^ (key >> 15U)) + static_cast<std::uint32_t>(cell[1]) * 0x85ebca77U;
        key = (key ^ (key >> 13U)) + static_cast<std::uint32_t>(cell[2]) * 0xc2b2ae3dU;
        return (key ^ (key >> 16U)) & (buckets_.size() - 1);
    }
    template <typename Visit>
    void visit_cells(const FaceBox& box, const Visit& visit) const {
        const Cell first = cell_of(box.low), last = cell_of(box.high);
        for (std::int32_t i = first[0]; i <= last[0]; ++i)
            for (std::int32_t j = first[1]; j <= last[1]; ++j)
                for (std::int32_t k = first[2]; k <= last[2]; ++k)
                    visit(Cell{i, j, k});
    }
    bool is_in_place(std::uint32_t f, const FaceBox& box) const;
    void add(std::uint32_t f);
    void remove(std::uint32_t f);
    void make_room(std::size_t faces);

    float per_mm_, slack_mm_;
    std::vector<std::vector<Entry>> buckets_;
    std::vector<FaceBox> boxes_;  // a face, as kept
};

template <typename Visit>
void FaceGrid::visit(const FaceBox& box, const Visit& visit) const {
    visit_cells(box, [&](const Cell& cell) {
        for (const Entry& entry : buckets_[bucket_of(cell)])
            if (entry.box.meets(box) && common_cell(entry.box, box) == cell) visit(entry.face);
    });
}

template <typename Visit>
void FaceGrid::visit_pairs(std::size_t bucket, const Visit& visit) const {
    const std::vector<Entry>& entries = buckets_[bucket];
    for (std::size_t i = 0; i < entries.size(); ++i) {
        for (std::size_t j = i + 1; j < entries.size(); ++j) {
            if (entries[i].box.meets(entries[j].box) &&
                bucket_of(common_cell(entries[i].box, entries[j].box)) == bucket)
                visit(entries[i].face, entries[j].face);
        }
    }
}

}  // namespace edaha
