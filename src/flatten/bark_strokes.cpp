// SPDX-License-Identifier: MIT
#include "flatten/bark_strokes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/keyed_random.h"
#include "base/parallel.h"
#include "flatten/seen_stretches.h"
#include "flatten/taper.h"

namespace edaha {
namespace {

// Lines nearer to each other than this share of their spacing would become one dark patch.
constexpr double kCrowded = 0.45;
// Dashes and gaps, in spacings: long enough to flow, short enough to look drawn.
constexpr double kShortestDash = 5, kDashRange = 14, kShortestGap = 0.8, kGapRange = 3;
constexpr double kShortestStroke_px = 3;

// A place on a line: in the view, where it crosses an edge of the mesh.
struct Crossing {
    Vec3 at{0};
    std::uint32_t low = 0, high = 0;  // points of the edge
};

// The way of one line over one triangle.
struct Passage {
    std::int64_t line = 0;
    std::uint32_t triangle = 0;
    Crossing ends[2];
};

Vec2 on_plane(Vec3 p) {
    return {p.x, p.y};
}

class BarkTracer {
  public:
    BarkTracer(const Scene& scene, const BarkParams& params)
        : scene_(scene), mesh_(scene.mesh), params_(params) {}

    std::vector<BarkStroke> trace() {
        passages_ = gather<Passage>(mesh_.triangles.size(),
                                    [&](std::size_t i, std::vector<Passage>& found) {
                                        cross_triangle(static_cast<std::uint32_t>(i), found);
                                    });
        link();
        const std::vector<Chain> chains = follow();
        return gather_chunks<BarkStroke>(
            chains.size(), 64,
            [&](std::size_t i, std::vector<BarkStroke>& found) { cut(chains[i], found); });
    }

  private:
    using Chain = std::vector<std::uint32_t>;  // passages with their direction: 2 * index + 1 back

    bool has_bark(std::uint32_t triangle) const {
        if (!scene_.view.front[triangle]) return false;
        const MeshPart& part = mesh_.parts[mesh_.part_of[triangle]];
        return part.material >= mesh_.materials.size() ||
               mesh_.materials[part.material].name != "leaf";
    }

    void cross_triangle(std::uint32_t t, std::vector<Passage>& found) const {
        if (!has_bark(t)) return;
        const auto& uv = mesh_.uv[t];
        const double step = params_.units_per_spacing;
        const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
        const double area = a.x * b.y - a.y * b.x;
        if (!(std::abs(area) > 1e-12 * (glm::dot(a, a) + glm::dot(b, b)))) return;
        if (spacing_in_view(t, a, b, area) < kCrowded * params_.spacing_px * kStepsPerPx) return;
        const auto [low, high] = std::minmax({uv[0].x, uv[1].x, uv[2].x});
        // Half a step off: u = 0 is where tubes are sewn.
        for (auto k = static_cast<std::int64_t>(std::ceil(low / step - 0.5));
             (double(k) + 0.5) * step < high; ++k) {
            Passage passage{k, t, {}};
            if (find_ends(passage, (double(k) + 0.5) * step)) found.push_back(passage);
        }
    }

    // How far two lines are apart in the view, in its steps: the triangle's height over a line of
    // constant u, a step of u away.
    double spacing_in_view(std::uint32_t t, glm::dvec2 a, glm::dvec2 b, double area) const {
        const auto& corners = mesh_.triangles[t];
        const Vec2 origin = on_plane(to_vec3(scene_.view.at[corners[0]]));
        const Vec2 p = on_plane(to_vec3(scene_.view.at[corners[1]])) - origin;
        const Vec2 q = on_plane(to_vec3(scene_.view.at[corners[2]])) - origin;
        const Vec2 along_v = (q * a.x - p * b.x) / area;
        const double length = glm::length(along_v);
        if (!(length > 0)) return 0;
        return std::abs((p.x * q.y - p.y * q.x) / area) / length * params_.units_per_spacing;
    }

    bool find_ends(Passage& passage, double u) const {
        const auto& corners = mesh_.triangles[passage.triangle];
        const auto& uv = mesh_.uv[passage.triangle];
        int count = 0;
        for (std::size_t i = 0; i < 3 && count < 2; ++i) {
            const std::size_t j = (i + 1) % 3;
            if ((uv[i].x < u) == (uv[j].x < u)) continue;
            // From the lower point on, so that both triangles of an edge say the same.
            const std::size_t from = corners[i] < corners[j] ? i : j;
            const std::size_t to = from == i ? j : i;
            const double t = (u - uv[from].x) / (uv[to].x - uv[from].x);
            const Vec3 a = to_vec3(scene_.view.at[corners[from]]);
            const Vec3 b = to_vec3(scene_.view.at[corners[to]]);
            passage.ends[count++] = {a + (b - a) * t, corners[from], corners[to]};
        }
        return count == 2;
    }

    // Ends of passages of one line on one edge belong together.
    void link() {
        std::vector<std::uint32_t> ends(2 * passages_.size());
        for (std::uint32_t i = 0; i < ends.size(); ++i)
            ends[i] = i;
        const auto key = [&](std::uint32_t end) {
            const Passage& passage = passages_[end / 2];
            const Crossing& crossing = passage.ends[end % 2];
            return std::tuple(crossing.low, crossing.high, passage.line);
        };
        sort_all(ends, [&](std::uint32_t a, std::uint32_t b) {
            return std::tuple_cat(key(a), std::tuple(a)) < std::tuple_cat(key(b), std::tuple(b));
        });
        partner_.assign(ends.size(), kNone);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            if (key(ends[i]) != key(ends[i + 1])) continue;
            partner_[ends[i]] = ends[i + 1];
            partner_[ends[i + 1]] = ends[i];
            ++i;
        }
    }

    std::vector<Chain> follow() const {
        std::vector<std::uint8_t> done(passages_.size(), 0);
        std::vector<Chain> chains;
        for (const bool loops : {false, true}) {
            for (std::uint32_t end = 0; end < partner_.size(); ++end) {
                if (done[end / 2] || (!loops && partner_[end] != kNone)) continue;
                Chain chain;
                for (std::uint32_t at = end; at != kNone && !done[at / 2]; at = partner_[at ^ 1U]) {
                    done[at / 2] = 1;
                    chain.push_back(at);
                }
                chains.push_back(std::move(chain));
            }
        }
        return chains;
    }

    Vec3 at(std::uint32_t passage, double t) const {
        const Passage& p = passages_[passage / 2];
        const Vec3 a = p.ends[passage % 2].at, b = p.ends[1 - passage % 2].at;
        return a + (b - a) * t;
    }
    // The visible stretches of a chain, as dashes.
    void cut(const Chain& chain, std::vector<BarkStroke>& found) const {
        std::vector<SurfaceStep> way;
        for (const std::uint32_t passage : chain)
            way.push_back({at(passage, 0), at(passage, 1), passages_[passage / 2].triangle});
        for (const SeenStretch& stretch : seen_stretches(scene_.rays, way)) {
            std::vector<Vec2> points;
            for (const SeenPlace& place : stretch)
                points.push_back(place.at / double(kStepsPerPx));
            dash(points, chain.front(), found);
        }
    }

    void dash(const std::vector<Vec2>& points, std::uint32_t first,
              std::vector<BarkStroke>& found) const {
        const Passage& passage = passages_[first / 2];
        Key key = step(mesh_.part_of[passage.triangle], static_cast<std::uint64_t>(passage.line));
        const auto chance = [&](double least, double range) {
            key = step(key, 1);
            return (least + range * (double(key >> 11) * 0x1p-53)) * params_.spacing_px;
        };
        BarkStroke stroke;
        bool drawing = true;
        double rest = chance(kShortestDash, kDashRange), length = 0;
        stroke.points.push_back(points[0]);
        const auto finish = [&] {
            if (drawing && length >= kShortestStroke_px) found.push_back(stroke);
            stroke.points.clear();
            length = 0;
        };
        for (std::size_t i = 1; i < points.size(); ++i) {
            Vec2 from = points[i - 1];
            double way = glm::distance(from, points[i]);
            while (way > rest) {
                from += (points[i] - from) * (rest / way);
                way -= rest;
                length += rest;
                if (drawing) stroke.points.push_back(from);
                finish();
                drawing = !drawing;
                if (drawing) stroke.points.push_back(from);
                rest =
                    drawing ? chance(kShortestDash, kDashRange) : chance(kShortestGap, kGapRange);
            }
            rest -= way;
            length += way;
            if (drawing && way > 1e-6) stroke.points.push_back(points[i]);
        }
        finish();
    }

    const Scene& scene_;
    const Mesh& mesh_;
    BarkParams params_;
    std::vector<Passage> passages_;
    std::vector<std::uint32_t> partner_;  // an end: 2 * passage, + 1 for its second
};

}  // namespace

std::vector<BarkStroke> trace_bark(const Scene& scene, const BarkParams& params) {
    if (scene.mesh.uv.size() != scene.mesh.triangles.size()) return {};
    return BarkTracer(scene, params).trace();
}

Layer draw_bark(const Scene& scene, const FlattenParams& params, const FlattenInks& inks,
                const FlatPlace& place) {
    Layer layer{"Bark", {inks.line, Ink::none()}, {}};
    BarkParams bark;
    bark.spacing_px = params.bark_mm / place.mm_per_px;
    bark.units_per_spacing = bark.spacing_px * kStepsPerPx / scene.view.steps_per_unit;
    const std::vector<BarkStroke> strokes = trace_bark(scene, bark);
    const double s = place.mm_per_px;
    const Affine page_from_px(s, 0, 0, s, place.origin_mm.x, place.origin_mm.y);
    std::vector<Shape> shapes(strokes.size());
    for_each_index(strokes.size(), 256, [&](std::size_t i) {
        SmoothParams smooth;
        smooth.tolerance = params.smoothing_px;
        const std::vector<CurvePiece> line = smooth_line(strokes[i].points, false, smooth);
        const TaperParams taper{params.crease_mm / s, 3 * bark.spacing_px};
        shapes[i].path = tapered(line, taper, page_from_px);
    });
    for (Shape& shape : shapes) {
        if (!shape.path.empty()) layer.children.emplace_back(std::move(shape));
    }
    return layer;
}

}  // namespace edaha
