// SPDX-License-Identifier: MIT
#include "surface/face_grid.h"

#include <algorithm>
#include <cmath>

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

FaceGrid::FaceGrid(double cell_mm, double slack_mm)
    : per_mm_(static_cast<float>(1 / cell_mm)), slack_mm_(static_cast<float>(slack_mm)) {
    make_room(0);
}

FaceGrid::FaceGrid(const GrowingMesh& mesh, double cell_mm) : FaceGrid(cell_mm, 0) {
    put_all(boxes_of(mesh));
}

void FaceGrid::put(std::uint32_t f, const FaceBox& box) {
    if (f >= boxes_.size()) make_room(f + 1);
    if (is_in_place(f, box)) return;
    if (!boxes_[f].empty()) remove(f);
    boxes_[f] = box;
    if (box.empty()) return;
    for (std::size_t k = 0; k < 3; ++k) {
        boxes_[f].low[k] -= slack_mm_;
        boxes_[f].high[k] += slack_mm_;
    }
    add(f);
}

void FaceGrid::put_all(std::span<const FaceBox> boxes) {
    if (boxes.size() > boxes_.size()) make_room(boxes.size());
    const auto changed =
        gather<std::uint32_t>(boxes_.size(), [&](std::size_t i, std::vector<std::uint32_t>& found) {
            const auto f = static_cast<std::uint32_t>(i);
            if (!is_in_place(f, i < boxes.size() ? boxes[i] : FaceBox{})) found.push_back(f);
        });
    for (const std::uint32_t f : changed)
        put(f, f < boxes.size() ? boxes[f] : FaceBox{});
}

void FaceGrid::renumber(std::span<const std::uint32_t> number) {
    make_room(number.size());
    for (std::uint32_t f = 0; f < boxes_.size(); ++f)
        if (f >= number.size() || number[f] == kNone) put(f, {});
    for_each_index(buckets_.size(), kWorthThreads, [&](std::size_t bucket) {
        for (Entry& entry : buckets_[bucket])
            entry.face = number[entry.face];
    });
    std::vector<FaceBox> boxes(boxes_.size());
    for (std::uint32_t f = 0; f < number.size(); ++f)
        if (number[f] != kNone) boxes[number[f]] = boxes_[f];
    boxes_ = std::move(boxes);
}

// In the box that is kept, which is not much too wide either.
bool FaceGrid::is_in_place(std::uint32_t f, const FaceBox& box) const {
    constexpr float kTooWide = 6;  // slacks
    const FaceBox& kept = boxes_[f];
    if (box.empty() || kept.empty()) return box.empty() && kept.empty();
    bool fits = kept.holds(box);
    for (std::size_t k = 0; k < 3; ++k)
        fits &= (kept.high[k] - kept.low[k]) - (box.high[k] - box.low[k]) <= kTooWide * slack_mm_;
    return fits;
}

// Once into each bucket; boxes of more than 64 cells may be twice in one, and are found twice then.
void FaceGrid::add(std::uint32_t f) {
    std::array<std::size_t, 64> seen{};
    std::size_t count = 0;
    visit_cells(boxes_[f], [&](const Cell& cell) {
        const std::size_t bucket = bucket_of(cell);
        const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::find(seen.begin(), end, bucket) != end) return;
        if (count < seen.size()) seen[count++] = bucket;
        buckets_[bucket].push_back({boxes_[f], f});
    });
}

void FaceGrid::remove(std::uint32_t f) {
    visit_cells(boxes_[f], [&](const Cell& cell) {
        std::vector<Entry>& entries = buckets_[bucket_of(cell)];
        for (std::size_t i = 0; i < entries.size();) {
            if (entries[i].face != f) {
                ++i;
                continue;
            }
            entries[i] = entries.back();
            entries.pop_back();
        }
    });
}

// As many buckets as faces at least; all of them go to new ones when there are more.
void FaceGrid::make_room(std::size_t faces) {
    constexpr std::size_t kFewest = 1024;
    boxes_.resize(std::max(faces, boxes_.size()));
    std::size_t count = std::max(kFewest, buckets_.size());
    while (count < boxes_.size())
        count *= 2;
    if (count == buckets_.size()) return;
    buckets_.assign(count, {});
    for (std::uint32_t f = 0; f < boxes_.size(); ++f)
        if (!boxes_[f].empty()) add(f);
}

}  // namespace edaha
