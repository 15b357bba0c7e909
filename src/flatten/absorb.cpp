// SPDX-License-Identifier: MIT
#include "flatten/absorb.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <glm/geometric.hpp>

#include "base/disjoint_sets.h"
#include "base/parallel.h"

namespace edaha {
namespace {

// Wider slivers are seen; to ask for more would cut tapering ends.
constexpr double kThinnest_px = 0.2;

class Absorber {
  public:
    // Lines part regions, too, if asked: then only their edges go, no label changes.
    Absorber(LabelledMap map, double min_area_px2, double thinnest_px, bool by_lines)
        : result_(std::move(map)),
          map_(result_.map),
          min_area_(min_area_px2 * result_.steps_per_px * result_.steps_per_px),
          thinnest_(thinnest_px * result_.steps_per_px),
          by_lines_(by_lines) {}

    LabelledMap absorb() {
        label_ = result_.labels;
        depth_ = result_.depth;
        join_equal_faces();
        measure();
        collect_small();
        while (!queue_.empty()) {
            const auto [area, region] = queue_.top();
            queue_.pop();
            // Others have grown since, or are part of another region.
            if (!waits_[region] || area != area_[region]) continue;
            waits_[region] = 0;
            dissolve(region);
        }
        by_lines_ ? erase_lines() : relabel();
        return std::move(result_);
    }

  private:
    std::uint32_t region_left_of(std::uint32_t h) { return sets_.find(map_.face_of(h)); }
    double edge_length(std::uint32_t h) const {
        return glm::distance(to_vec(map_.nodes[map_.origin(h)]),
                             to_vec(map_.nodes[map_.target(h)]));
    }
    bool is_background(std::uint32_t region) const { return label_[region].part == kNone; }

    void join_equal_faces() {
        sets_ = DisjointSets(map_.faces());
        for (std::uint32_t h = 0; h < map_.next.size(); h += 2) {
            const std::uint32_t a = map_.face_of(h), b = map_.face_of(h + 1);
            const bool parted = by_lines_ && result_.line[h / 2] < LineKind::tone;
            if (result_.labels[a] == result_.labels[b] && !parted) sets_.unite(a, b);
        }
        region_.resize(map_.faces());
        for (std::uint32_t face = 0; face < region_.size(); ++face)
            region_[face] = sets_.find(face);
    }

    // Edges between regions, once.
    struct Border {
        std::uint32_t half_edge = 0;        // the first of its edge
        std::uint32_t left = 0, right = 0;  // regions
        double length = 0;
    };

    void measure() {
        borders_ =
            gather<Border>(map_.edges.size(), [&](std::size_t e, std::vector<Border>& found) {
                const auto h = static_cast<std::uint32_t>(2 * e);
                const std::uint32_t a = region_[map_.face_of(h)], b = region_[map_.face_of(h + 1)];
                if (a != b) found.push_back({h, a, b, edge_length(h)});
            });
        area_.assign(map_.faces(), 0);
        border_.assign(map_.faces(), 0);
        sky_border_.assign(map_.faces(), 0);
        for (const PlanarMap::Loop& loop : map_.loops)
            area_[region_[loop.face]] += loop.area;
        area_[0] = std::numeric_limits<double>::infinity();
        for (const Border& border : borders_) {
            border_[border.left] += border.length;
            border_[border.right] += border.length;
            if (is_background(border.right)) sky_border_[border.left] += border.length;
            if (is_background(border.left)) sky_border_[border.right] += border.length;
        }
    }

    bool is_small(std::uint32_t region) const {
        if (area_[region] < min_area_) return true;
        if (2 * area_[region] >= thinnest_ * border_[region]) return false;
        return by_lines_ || 2 * sky_border_[region] < border_[region];
    }

    void wait(std::uint32_t region) {
        waits_[region] = 1;
        queue_.emplace(area_[region], region);
    }

    // Only small regions need to know their half-edges.
    void collect_small() {
        waits_.assign(map_.faces(), 0);
        first_edge_.assign(map_.faces(), kNone);
        last_edge_.assign(map_.faces(), kNone);
        next_edge_.assign(map_.next.size(), kNone);
        for (std::uint32_t face = 1; face < map_.faces(); ++face) {
            if (region_[face] == face && is_small(face)) wait(face);
        }
        for (const Border& border : borders_) {
            if (waits_[border.left]) append_edges(border.left, border.half_edge, border.half_edge);
            const std::uint32_t back = twin(border.half_edge);
            if (waits_[border.right]) append_edges(border.right, back, back);
        }
    }

    // Puts a list of half-edges behind a region's own.
    void append_edges(std::uint32_t region, std::uint32_t first, std::uint32_t last) {
        std::uint32_t& end = last_edge_[region];
        (end == kNone ? first_edge_[region] : next_edge_[end]) = first;
        end = last;
    }

    // The neighbour with the longest border; of equal ones the lowest. The sky only if there is no
    // other: twigs are made of many small parts.
    std::uint32_t best_neighbour(std::uint32_t region) {
        std::vector<std::pair<std::uint32_t, double>>& shares = shares_;
        shares.clear();
        for (std::uint32_t h = first_edge_[region]; h != kNone; h = next_edge_[h]) {
            const std::uint32_t other = region_left_of(twin(h));
            if (other == region || (by_lines_ && label_[other] != label_[region])) continue;
            shares.emplace_back(other, edge_length(h));
        }
        std::sort(shares.begin(), shares.end());
        std::uint32_t best = kNone;
        double longest = 0;
        for (std::size_t i = 0; i < shares.size();) {
            double sum = 0;
            const std::uint32_t other = shares[i].first;
            for (; i < shares.size() && shares[i].first == other; ++i)
                sum += shares[i].second;
            const bool instead_of_sky =
                best != kNone && is_background(best) && !is_background(other);
            if (best != kNone && is_background(other) && !is_background(best)) continue;
            if (sum > longest || instead_of_sky) longest = sum, best = other;
        }
        return best;
    }

    void dissolve(std::uint32_t region) {
        const std::uint32_t other = best_neighbour(region);
        if (other == kNone) return;
        const FaceLabel label = label_[other];
        const float depth = depth_[other];
        const bool other_waits = waits_[other] != 0;
        waits_[other] = 0;
        sets_.unite(region, other);
        const std::uint32_t joined = std::min(region, other);
        area_[joined] = area_[region] + area_[other];
        border_[joined] = border_[other];  // roughly: it matters for thin regions alone
        sky_border_[joined] = sky_border_[other];
        label_[joined] = label;
        depth_[joined] = depth;
        if (!other_waits) return;
        const std::uint32_t added = joined == other ? region : other;
        if (first_edge_[added] != kNone)
            append_edges(joined, first_edge_[added], last_edge_[added]);
        if (is_small(joined)) wait(joined);
    }

    void relabel() {
        const std::vector<FaceLabel> before = result_.labels;
        for (std::uint32_t face = 0; face < map_.faces(); ++face) {
            const std::uint32_t region = sets_.find(face);
            if (before[face] == label_[region]) continue;
            result_.labels[face] = label_[region];
            result_.depth[face] = depth_[region];
        }
        for (const Border& border : borders_) {
            const std::uint32_t h = border.half_edge;
            const std::uint32_t a = map_.face_of(h), b = map_.face_of(h + 1);
            if (before[a].part == before[b].part) continue;
            if (result_.labels[a].part == result_.labels[b].part)
                result_.line[h / 2] = LineKind::none;
        }
    }

    void erase_lines() {
        for (const Border& border : borders_) {
            if (sets_.find(border.left) == sets_.find(border.right))
                result_.line[border.half_edge / 2] = LineKind::none;
        }
    }

    LabelledMap result_;
    const PlanarMap& map_;
    double min_area_, thinnest_;
    bool by_lines_;
    DisjointSets sets_;                  // of faces: regions, by their lowest face
    std::vector<std::uint32_t> region_;  // a face: its region before any was absorbed
    std::vector<FaceLabel> label_;       // a region, by its lowest face
    std::vector<float> depth_;
    std::vector<double> area_, border_, sky_border_;
    std::vector<Border> borders_;
    std::vector<std::uint32_t> first_edge_, last_edge_;  // a waiting region: list of half-edges
    std::vector<std::uint32_t> next_edge_;               // a half-edge: the next of its list
    std::vector<std::pair<std::uint32_t, double>> shares_;
    using Small = std::pair<double, std::uint32_t>;  // area, region
    std::priority_queue<Small, std::vector<Small>, std::greater<>> queue_;
    std::vector<std::uint8_t> waits_;
};

}  // namespace

LabelledMap absorb_small_regions(LabelledMap map, double min_area_px2) {
    return Absorber(std::move(map), min_area_px2, kThinnest_px, false).absorb();
}

LabelledMap erase_crowded_lines(LabelledMap map, double min_area_px2, double line_px) {
    return Absorber(std::move(map), min_area_px2, line_px, true).absorb();
}

}  // namespace edaha
