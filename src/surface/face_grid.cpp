// SPDX-License-Identifier: MIT
#include "surface/face_grid.h"

#include <limits>

#include <glm/common.hpp>

#include "base/parallel.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 5000;
// Wider than what rounding to single precision takes.
constexpr double kWider_mm = 1e-3;
constexpr double kWider = 2e-7;

std::vector<FaceBox> boxes_of(const GrowingMesh& mesh) {
    std::vector<FaceBox> boxes(mesh.origin.size() / 3);
    for_each_index(boxes.size(), kWorthThreads, [&](std::size_t f) {
        if (mesh.origin[3 * f] == kNone) return;
        boxes[f] =
            box_round(mesh.position[mesh.origin[3 * f]], mesh.position[mesh.origin[3 * f + 1]],
                      mesh.position[mesh.origin[3 * f + 2]]);
    });
    return boxes;
}

}  // namespace

FaceBox box_round(const Vec3& low, const Vec3& high) {
    FaceBox box;
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        box.low[at] = static_cast<float>(low[k] - kWider_mm - kWider * std::abs(low[k]));
        box.high[at] = static_cast<float>(high[k] + kWider_mm + kWider * std::abs(high[k]));
    }
    return box;
}

FaceBox box_round(const Vec3& a, const Vec3& b, const Vec3& c) {
    return box_round(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c));
}

// Calls visit(bucket) for each bucket that the box is in, once.
template <typename Visit>
void FaceGrid::visit_buckets(const FaceBox& box, const Visit& visit) const {
    // Boxes of more cells than that may be in a bucket twice, and pairs of them be found twice.
    std::array<std::uint32_t, 64> seen{};
    std::size_t count = 0;
    visit_cells(box, [&](const Cell& cell) {
        const std::uint32_t bucket = bucket_of(cell);
        const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::find(seen.begin(), end, bucket) != end) return;
        if (count < seen.size()) seen[count++] = bucket;
        visit(bucket);
    });
}

FaceGrid::FaceGrid(const GrowingMesh& mesh, double cell_mm) : FaceGrid(boxes_of(mesh), cell_mm) {}

// By counting: how many a bucket has, where they begin, and then each into its place.
FaceGrid::FaceGrid(std::span<const FaceBox> boxes, double cell_mm)
    : per_mm_(static_cast<float>(1 / cell_mm)) {
    std::uint32_t buckets = 16;
    while (buckets < boxes.size())
        buckets *= 2;
    mask_ = buckets - 1;
    start_.assign(buckets + 1, 0);
    const auto visit_all = [&](const auto& put) {
        for (std::uint32_t f = 0; f < boxes.size(); ++f) {
            if (boxes[f].empty()) continue;
            visit_buckets(boxes[f], [&](std::uint32_t bucket) { put(bucket, f); });
        }
    };
    visit_all([&](std::uint32_t bucket, std::uint32_t) { ++start_[bucket]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& at : start_)
        at = sum += at;
    faces_.resize(sum);
    boxes_.resize(sum);
    visit_all([&](std::uint32_t bucket, std::uint32_t f) {
        faces_[--start_[bucket]] = f;
        boxes_[start_[bucket]] = boxes[f];
    });
}

}  // namespace edaha
