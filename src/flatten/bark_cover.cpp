// SPDX-License-Identifier: MIT
#include "flatten/bark_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "base/keyed_random.h"
#include "base/parallel.h"
#include "base/stable_math.h"
#include "mesh/edges.h"

namespace edaha {
namespace {

// How far copies are swayed, in tiles: less, and the repeat is seen; more, and strokes that should
// stay apart come to lie on each other.
constexpr double kSway = 0.05;
// A tile is not laid smaller than this along thin branches: marks would become dots.
constexpr double kShortestTile = 0.6, kLongestTile = 1.4;
// Beyond that many strokes on one part the tile is laid larger: they could not be told apart.
constexpr double kMostLines = 40'000;
// Strokes nearer to each other than this share of what the tile has are thinned out.
constexpr double kCrowded = 0.6;
// No nearer than this: they would be one dark patch.
constexpr double kLeastSpacing_px = 4;
// No triangle has more room: seen straight it is 1, and twice that only where places are distorted.
constexpr double kMostRoom = 2;
// Part of a rank that is chance, so that copies keep different strokes.
constexpr double kChance = 0.3;

double fraction(Key key) {
    return double(key >> 11) * 0x1p-53;
}

// What of a part's places is known from its triangles.
struct UvExtent {
    Vec2 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
    // Lengths of a unit of u and of v, by triangle, with its area.
    std::array<std::vector<std::pair<double, double>>, 2> lengths;
    std::vector<double> jumps;  // of u, at seams
};

// The length that half of the area has or exceeds: a few triangles may be stretched without bounds.
double middle_length(std::vector<std::pair<double, double>>& lengths) {
    std::sort(lengths.begin(), lengths.end());
    double all = 0, passed = 0;
    for (const auto& [length, area] : lengths)
        all += area;
    for (const auto& [length, area] : lengths) {
        passed += area;
        if (2 * passed >= all) return length;
    }
    return 0;
}

class CoverLayer {
  public:
    CoverLayer(const Mesh& mesh, const View& view, const BarkTile& tile,
               const BarkCoverParams& params)
        : mesh_(mesh), view_(view), tile_(tile), params_(params), extents_(mesh.parts.size()) {
        for (const BarkLine& line : tile.lines) {
            for (const Vec2 p : line.points) {
                const Vec2 at = p / Vec2(tile.width_mm, tile.height_mm);
                strokes_.low = glm::min(strokes_.low, at);
                strokes_.high = glm::max(strokes_.high, at);
            }
        }
    }

    std::vector<PartCover> run() {
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
            measure(t);
        for (const MeshEdge& edge : mesh_edges(mesh_))
            find_jump(edge);
        std::vector<PartCover> covers(mesh_.parts.size());
        for_each_index(covers.size(), 16, [&](std::size_t part) { covers[part] = cover(part); });
        return covers;
    }

  private:
    bool has_bark(std::size_t part) const {
        const std::uint32_t material = mesh_.parts[part].material;
        if (material >= mesh_.materials.size()) return true;
        const std::string& name = mesh_.materials[material].name;
        return name != "leaf" && name != "xylem";
    }

    void measure(std::uint32_t t) {
        UvExtent& extent = extents_[mesh_.part_of[t]];
        const auto& uv = mesh_.uv[t];
        const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
        const double det = a.x * b.y - a.y * b.x;
        if (!(std::abs(det) > 1e-12 * (glm::dot(a, a) + glm::dot(b, b)))) return;
        const auto& corners = mesh_.triangles[t];
        const Vec3 p = mesh_.points[corners[1]] - mesh_.points[corners[0]];
        const Vec3 q = mesh_.points[corners[2]] - mesh_.points[corners[0]];
        const double area = glm::length(glm::cross(p, q));
        extent.lengths[0].emplace_back(glm::length((p * b.y - q * a.y) / det), area);
        extent.lengths[1].emplace_back(glm::length((q * a.x - p * b.x) / det), area);
        if (view_.front[t] == 0) return;
        for (const Vec2 place : uv) {
            extent.low = glm::min(extent.low, place);
            extent.high = glm::max(extent.high, place);
        }
    }

    Vec2 place_at(std::uint32_t t, std::uint32_t point) const {
        const auto& corners = mesh_.triangles[t];
        const auto k = std::find(corners.begin(), corners.end(), point) - corners.begin();
        return mesh_.uv[t][static_cast<std::size_t>(k)];
    }

    // Both ends of an edge jump alike.
    void find_jump(const MeshEdge& edge) {
        if (edge.left == kNone || edge.right == kNone) return;
        if (mesh_.part_of[edge.left] != mesh_.part_of[edge.right]) return;
        const Vec2 a = place_at(edge.left, edge.a) - place_at(edge.right, edge.a);
        const Vec2 b = place_at(edge.left, edge.b) - place_at(edge.right, edge.b);
        const double jump = std::abs(a.x);
        const double along =
            glm::distance(place_at(edge.left, edge.a), place_at(edge.left, edge.b));
        if (!(jump > 1e-3 * along) || !(glm::length(a - b) < 1e-3 * jump) ||
            !(std::abs(a.y) < 1e-3 * jump))
            return;
        extents_[mesh_.part_of[edge.left]].jumps.push_back(jump);
    }

    PartCover cover(std::size_t part) {
        PartCover cover;
        UvExtent& extent = extents_[part];
        if (!has_bark(part) || !(extent.low.x <= extent.high.x)) return cover;
        cover.size = {middle_length(extent.lengths[0]), middle_length(extent.lengths[1])};
        if (!(cover.size.x > 0) || !(cover.size.y > 0)) return cover;
        if (!extent.jumps.empty()) {
            const auto middle =
                extent.jumps.begin() + static_cast<std::ptrdiff_t>(extent.jumps.size() / 2);
            std::nth_element(extent.jumps.begin(), middle, extent.jumps.end());
            cover.around = *middle;
        }
        const Vec2 range = extent.high - extent.low;
        const double width = (cover.around > 0 ? cover.around / std::numbers::pi : range.x);
        if (!(width * cover.size.x > params_.thinnest_units)) return cover;
        choose_tile(cover, range);
        lay(cover, extent, name_key(mesh_.parts[part].name));
        return cover;
    }

    void choose_tile(PartCover& cover, Vec2 range) const {
        const Vec2 size = Vec2(tile_.width_mm, tile_.height_mm) * params_.units_per_mm / cover.size;
        const Vec2 copies = glm::max(range / size, Vec2(1));
        const double count = copies.x * copies.y * double(tile_.lines.size()) / kMostLines;
        const double scale = std::max(1.0, count);  // one side alone may be long
        cover.tile = size * scale;
        if (cover.around > 0)
            cover.tile.x =
                cover.around / std::max(1.0, std::floor(cover.around / cover.tile.x + 0.5));
        cover.squeeze = cover.tile.x / size.x;
        cover.tile.y = size.y * std::clamp(cover.squeeze, kShortestTile, kLongestTile * scale);
    }

    void lay(PartCover& cover, const UvExtent& extent, Key key) const {
        // Copies of which a stroke may come that far, swayed by two waves.
        const auto first = [&](double low, int axis) {
            return static_cast<std::int64_t>(
                std::ceil(low / cover.tile[axis] - strokes_.high[axis] - 2 * kSway));
        };
        const auto last = [&](double high, int axis) {
            return static_cast<std::int64_t>(
                std::floor(high / cover.tile[axis] - strokes_.low[axis] + 2 * kSway));
        };
        std::int64_t left = first(extent.low.x, 0), right = last(extent.high.x, 0);
        if (cover.around > 0) {
            left = 0;
            right = static_cast<std::int64_t>(std::floor(cover.around / cover.tile.x + 0.5)) - 1;
        }
        for (std::int64_t row = first(extent.low.y, 1); row <= last(extent.high.y, 1); ++row) {
            for (std::int64_t column = left; column <= right; ++column)
                lay_copy(cover, key, column, row);
        }
    }

    void lay_copy(PartCover& cover, Key key, std::int64_t column, std::int64_t row) const {
        const Key own = step(step(key, static_cast<Key>(column)), static_cast<Key>(row));
        const Vec2 scale = cover.tile / Vec2(tile_.width_mm, tile_.height_mm);
        const Vec2 corner = cover.tile * Vec2(double(column), double(row));
        const double most = crowd_demand(params_.spacing_px, cover.squeeze, kMostRoom);
        for (std::uint32_t i = 0; i < tile_.lines.size(); ++i) {
            LaidLine line;
            line.line = i;
            line.rank = (1 - kChance) * (i + 0.5) / double(tile_.lines.size()) +
                        kChance * fraction(step(own, i));
            if (line.rank >= most) continue;
            for (const Vec2 p : tile_.lines[i].points)
                line.places.push_back(swayed(cover, key, corner + p * scale));
            cover.lines.push_back(std::move(line));
        }
    }

    // Two waves each way, whole ones round the part.
    static Vec2 swayed(const PartCover& cover, Key key, Vec2 place) {
        const double turn = cover.around > 0 ? place.x / cover.around : place.x / cover.tile.x / 3;
        const double rise = place.y / cover.tile.y;
        Vec2 sum(0);
        const double waves[2][2] = {{1, 0.43}, {2, -0.71}};
        for (int axis = 0; axis < 2; ++axis) {
            for (int i = 0; i < 2; ++i) {
                const double phase =
                    fraction(step(key, Key{2} * static_cast<Key>(axis) + static_cast<Key>(i))) +
                    waves[i][0] * turn + waves[i][1] * rise;
                sum[axis] +=
                    stable::sin_cos(2 * std::numbers::pi * (phase - std::floor(phase))).sin;
            }
        }
        return place + kSway * sum * cover.tile;
    }

    const Mesh& mesh_;
    const View& view_;
    const BarkTile& tile_;
    const BarkCoverParams params_;
    struct {
        Vec2 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
    } strokes_;  // of the tile, in tiles
    std::vector<UvExtent> extents_;
};

}  // namespace

double crowd_demand(double spacing_px, double squeeze, double room) {
    return std::min(room * std::min(1.0, squeeze) / kCrowded,
                    spacing_px * squeeze * room / kLeastSpacing_px);
}

std::vector<PartCover> lay_bark(const Mesh& mesh, const View& view, const BarkTile& tile,
                                const BarkCoverParams& params) {
    if (mesh.uv.size() != mesh.triangles.size() || tile.empty() || !(params.units_per_mm > 0))
        return {};
    return CoverLayer(mesh, view, tile, params).run();
}

}  // namespace edaha
