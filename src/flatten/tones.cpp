// SPDX-License-Identifier: MIT
#include "flatten/tones.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "flatten/light.h"
#include "mesh/corner_groups.h"
#include "mesh/facets.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 10'000;

class ToneMaker {
  public:
    ToneMaker(const Mesh& mesh, const View& view, const FlattenParams& params)
        : mesh_(mesh), params_(params) {
        const Vec3 light = seen_light(params);
        light_ = view.right * light.x + view.up * light.y + view.to_eye * light.z;
    }

    std::vector<std::array<float, 3>> flat() const {
        std::vector<std::array<float, 3>> at(mesh_.triangles.size());
        for_each_index(at.size(), kWorthThreads, [&](std::size_t i) {
            at[i].fill(brightness(facet_normal(mesh_, static_cast<std::uint32_t>(i))));
        });
        return at;
    }

    std::vector<std::array<float, 3>> smooth(std::span<const MeshEdge> edges) const {
        const std::vector<std::uint32_t> group = group_corners(mesh_, edges, params_.crease_rad);
        std::vector<Vec3> normals = sum_normals(group);
        for (int round = 0; round < static_cast<int>(params_.tone_smoothing); ++round)
            normals = averaged(group, normals);
        std::vector<std::array<float, 3>> at(mesh_.triangles.size());
        for_each_index(at.size(), kWorthThreads, [&](std::size_t i) {
            for (std::size_t k = 0; k < 3; ++k)
                at[i][k] = brightness(normals[group[3 * i + k]]);
        });
        if (params_.axis_normals) turn_from_axes(at);
        return at;
    }

  private:
    float brightness(Vec3 normal) const {
        const double length = glm::length(normal);
        return length > 0 ? static_cast<float>(glm::dot(normal, light_) / length) : 0.0F;
    }

    // Weighted with the triangles' areas.
    std::vector<Vec3> sum_normals(std::span<const std::uint32_t> group) const {
        std::vector<Vec3> sums(group.size(), Vec3(0));
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            const Vec3 normal = facet_normal(mesh_, i);
            for (std::size_t k = 0; k < 3; ++k)
                sums[group[3 * i + k]] += normal;
        }
        return sums;
    }

    // Half of each normal is its neighbours' mean.
    std::vector<Vec3> averaged(std::span<const std::uint32_t> group,
                               const std::vector<Vec3>& normals) const {
        const auto unit = [&](std::uint32_t g) {
            const double length = glm::length(normals[g]);
            return length > 0 ? normals[g] / length : Vec3(0);
        };
        std::vector<Vec3> sums(normals.size(), Vec3(0));
        for (std::size_t i = 0; i < group.size(); i += 3) {
            const std::array<Vec3, 3> n{unit(group[i]), unit(group[i + 1]), unit(group[i + 2])};
            for (std::size_t k = 0; k < 3; ++k)
                sums[group[i + k]] += n[(k + 1) % 3] + n[(k + 2) % 3];
        }
        for (std::uint32_t g = 0; g < sums.size(); ++g) {
            const double length = glm::length(sums[g]);
            if (group[g] == g && length > 0) sums[g] = sums[g] / length + unit(g);
        }
        return sums;
    }

    void turn_from_axes(std::vector<std::array<float, 3>>& at) const {
        for_each_index(at.size(), kWorthThreads, [&](std::size_t i) {
            const std::optional<Axis>& axis = mesh_.parts[mesh_.part_of[i]].axis;
            if (!axis) return;
            const Vec3 along = axis->to - axis->from;
            const double square = std::max(glm::dot(along, along), 1e-300);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 out = mesh_.points[mesh_.triangles[i][k]] - axis->from;
                at[i][k] = brightness(out - along * (glm::dot(out, along) / square));
            }
        });
    }

    const Mesh& mesh_;
    const FlattenParams& params_;
    Vec3 light_;
};

std::vector<float> thresholds_of(const FlattenParams& params) {
    std::vector<float> thresholds;
    const int count = params.bands - 1;
    for (int i = 0; i < count; ++i) {
        const double part = count == 1 ? 0.5 : double(i) / (count - 1);
        thresholds.push_back(
            static_cast<float>(params.shade + (params.shine - params.shade) * part));
    }
    return thresholds;
}

// A millionth is far below what a tone shows, and far above the rounding of a float.
void nudge(ToneField& field) {
    constexpr float kNudge = 1e-6F;
    for_each_index(field.at.size(), kWorthThreads, [&](std::size_t i) {
        for (float& value : field.at[i]) {
            for (const float threshold : field.thresholds) {
                if (std::abs(value - threshold) < kNudge) value = threshold + kNudge;
            }
        }
    });
}

// Where the isoline crosses the side p -> q of a triangle, p < q.
ViewPoint crossing(const View& view, std::uint32_t p, std::uint32_t q, double t) {
    const ViewPoint a = view.at[p], b = view.at[q];
    const auto place = [t](std::int32_t from, std::int32_t to) {
        return static_cast<std::int32_t>(std::floor(from + t * (double(to) - from) + 0.5));
    };
    return {place(a.x, b.x), place(a.y, b.y), place(a.z, b.z)};
}

std::optional<ViewSegment> isoline(const Mesh& mesh, const View& view, const ToneField& field,
                                   std::uint32_t triangle, float threshold) {
    const Triangle& t = mesh.triangles[triangle];
    const std::array<float, 3>& at = field.at[triangle];
    std::array<ViewPoint, 2> ends;
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        std::size_t p = i, q = (i + 1) % 3;
        if ((at[p] < threshold) == (at[q] < threshold)) continue;
        if (t[p] > t[q]) std::swap(p, q);
        const double part = (double(threshold) - at[p]) / (double(at[q]) - at[p]);
        ends[found++] = crossing(view, t[p], t[q], part);
    }
    if (found != 2 || on_screen(ends[0]) == on_screen(ends[1])) return std::nullopt;
    return ViewSegment{ends[0], ends[1], triangle, kNone, LineKind::tone};
}

// Between facets of different bands.
std::optional<ViewSegment> step_between(const View& view, const ToneField& field,
                                        const MeshEdge& edge) {
    if (edge.left == kNone || edge.right == kNone) return std::nullopt;
    if (!view.shown[edge.left] || !view.shown[edge.right]) return std::nullopt;
    if (field.band(field.at[edge.left][0]) == field.band(field.at[edge.right][0]))
        return std::nullopt;
    const ViewPoint a = view.at[edge.a], b = view.at[edge.b];
    if (on_screen(a) == on_screen(b)) return std::nullopt;
    return ViewSegment{a, b, edge.left, edge.right, LineKind::tone};
}

}  // namespace

std::uint8_t ToneField::band(float brightness) const {
    std::uint8_t band = 0;
    for (const float threshold : thresholds)
        band = static_cast<std::uint8_t>(band + (brightness >= threshold ? 1 : 0));
    return band;
}

ToneField make_tones(const Mesh& mesh, std::span<const MeshEdge> edges, const View& view,
                     const FlattenParams& params) {
    ToneField field;
    field.flat = params.look == FlatLook::facets;
    if (!field.flat && params.look != FlatLook::tones) return field;
    field.thresholds = thresholds_of(params);
    const ToneMaker maker(mesh, view, params);
    field.at = field.flat ? maker.flat() : maker.smooth(edges);
    nudge(field);
    return field;
}

std::vector<ViewSegment> tone_segments(const Mesh& mesh, std::span<const MeshEdge> edges,
                                       const View& view, const ToneField& field) {
    if (field.flat) {
        return gather<ViewSegment>(edges.size(), [&](std::size_t i, auto& found) {
            if (const auto step = step_between(view, field, edges[i])) found.push_back(*step);
        });
    }
    return gather<ViewSegment>(field.at.size(), [&](std::size_t i, auto& found) {
        if (!view.shown[i]) return;
        for (const float threshold : field.thresholds) {
            const auto line = isoline(mesh, view, field, static_cast<std::uint32_t>(i), threshold);
            if (line) found.push_back(*line);
        }
    });
}

}  // namespace edaha
