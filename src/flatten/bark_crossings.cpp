// SPDX-License-Identifier: MIT
#include "flatten/bark_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace edaha {
namespace {

// Cells of a part's grid, in tiles: about as wide as a stroke's segment is long.
constexpr double kCell = 1.0 / 12;
// Ends that are further apart are none of one line: rounding of files and of (u,v) is less.
constexpr double kSameEnd = 1e-3, kSameEnd_px = 0.5;

struct Segment {
    std::uint32_t line = 0, index = 0;
    std::int32_t turn = 0;  // its cell's turns round the part
    auto operator<=>(const Segment&) const = default;
};

// The segments of a cover's lines by cells of (u,v), wrapped round the part.
class CoverGrid {
  public:
    explicit CoverGrid(const PartCover& cover) : cover_(cover) {
        if (cover.lines.empty()) return;
        cell_ = cover.tile * kCell;
        if (cover.around > 0) {
            columns_ = std::max(1.0, std::floor(cover.around / cell_.x));
            cell_.x = cover.around / columns_;
        }
        Vec2 low(std::numeric_limits<double>::max()), high(-low);
        for (const LaidLine& line : cover.lines) {
            for (const Vec2 p : line.places)
                low = glm::min(low, p), high = glm::max(high, p);
        }
        first_ = {cover.around > 0 ? 0 : cell_of(low.x, 0), cell_of(low.y, 1)};
        const std::int64_t wide =
            cover.around > 0 ? std::int64_t(columns_) : cell_of(high.x, 0) - first_[0] + 1;
        size_ = {wide, cell_of(high.y, 1) - first_[1] + 1};
        fill();
    }

    // Those whose boxes' cells touch a box; each once.
    void find(Vec2 low, Vec2 high, std::vector<Segment>& found) const {
        found.clear();
        if (cover_.lines.empty()) return;
        // Larger boxes are no triangle's but a file's mistake.
        if (!((high.x - low.x) / cell_.x * ((high.y - low.y) / cell_.y) < 1e5)) return;
        for (std::int64_t y = cell_of(low.y, 1); y <= cell_of(high.y, 1); ++y) {
            for (std::int64_t x = cell_of(low.x, 0); x <= cell_of(high.x, 0); ++x) {
                const auto [cell, turn] = wrapped(x, y);
                if (cell < 0) continue;
                for (std::uint32_t i = start_[std::size_t(cell)]; i < start_[std::size_t(cell) + 1];
                     ++i) {
                    Segment segment = segments_[i];
                    segment.turn = turn - segment.turn;
                    found.push_back(segment);
                }
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
    }

  private:
    std::int64_t cell_of(double place, int axis) const {
        return static_cast<std::int64_t>(std::floor(place / cell_[axis]));
    }

    // Its number, -1 outside, and how often it lies round the part.
    std::pair<std::int64_t, std::int32_t> wrapped(std::int64_t x, std::int64_t y) const {
        std::int64_t turn = 0;
        x -= first_[0], y -= first_[1];
        if (cover_.around > 0) {
            turn = static_cast<std::int64_t>(std::floor(double(x) / double(size_[0])));
            x -= turn * size_[0];
        }
        if (x < 0 || y < 0 || x >= size_[0] || y >= size_[1]) return {-1, 0};
        return {y * size_[0] + x, static_cast<std::int32_t>(turn)};
    }

    template <typename Visit>
    void visit_cells(const Visit& visit) const {
        for (std::uint32_t line = 0; line < cover_.lines.size(); ++line) {
            const std::vector<Vec2>& places = cover_.lines[line].places;
            for (std::uint32_t i = 0; i + 1 < places.size(); ++i) {
                const Vec2 low = glm::min(places[i], places[i + 1]);
                const Vec2 high = glm::max(places[i], places[i + 1]);
                for (std::int64_t y = cell_of(low.y, 1); y <= cell_of(high.y, 1); ++y) {
                    for (std::int64_t x = cell_of(low.x, 0); x <= cell_of(high.x, 0); ++x) {
                        const auto [cell, turn] = wrapped(x, y);
                        if (cell >= 0) visit(std::size_t(cell), Segment{line, i, turn});
                    }
                }
            }
        }
    }

    void fill() {
        start_.assign(std::size_t(size_[0] * size_[1]) + 1, 0);
        visit_cells([&](std::size_t cell, const Segment&) { ++start_[cell + 1]; });
        for (std::size_t i = 1; i < start_.size(); ++i)
            start_[i] += start_[i - 1];
        segments_.resize(start_.back());
        std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
        visit_cells([&](std::size_t cell, const Segment& s) { segments_[next[cell]++] = s; });
    }

    const PartCover& cover_;
    Vec2 cell_{1};
    double columns_ = 1;
    std::array<std::int64_t, 2> first_{0, 0}, size_{0, 0};
    std::vector<std::uint32_t> start_;
    std::vector<Segment> segments_;
};

double cross_of(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

// A front triangle in (u,v) and in the view.
class BarkTriangle {
  public:
    BarkTriangle(const Scene& scene, std::uint32_t t, const PartCover& cover, double px_per_unit)
        : scene_(scene), t_(t), uv_(scene.mesh.uv[t]), cover_(cover) {
        for (std::size_t k = 0; k < 3; ++k)
            at_[k] = to_vec3(scene.view.at[scene.mesh.triangles[t][k]]);
        a_ = uv_[1] - uv_[0], b_ = uv_[2] - uv_[0];
        det_ = cross_of(a_, b_);
        const Vec2 p = Vec2(at_[1] - at_[0]), q = Vec2(at_[2] - at_[0]);
        if (!is_proper()) return;
        const double flat = glm::length(glm::cross(at_[1] - at_[0], at_[2] - at_[0]));
        facing_ = flat > 0 ? std::abs(cross_of(p, q)) / flat : 0;
        const double scale = 1 / (px_per_unit * kStepsPerPx * det_);
        along_u_ = (p * b_.y - q * a_.y) * (scale / cover.size.x);
        along_v_ = (q * a_.x - p * b_.x) * (scale / cover.size.y);
        area_ = std::abs(cross_of(along_u_, along_v_));
    }

    bool is_proper() const {
        return std::abs(det_) > 1e-12 * (glm::dot(a_, a_) + glm::dot(b_, b_));
    }

    // The part of a segment within the triangle, if there is one.
    bool clip(Vec2 from, Vec2 to, BarkPiece& piece) const {
        double enter = 0, leave = 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 corner = uv_[k], side = uv_[(k + 1) % 3] - corner;
            const double sign = det_ > 0 ? 1 : -1;
            const double f = sign * cross_of(side, from - corner);
            const double g = sign * cross_of(side, to - corner);
            if (f < 0 && g < 0) return false;
            if (f < 0) enter = std::max(enter, f / (f - g));
            if (g < 0) leave = std::min(leave, f / (f - g));
        }
        if (!(leave - enter > 1e-9)) return false;
        const Vec2 way = to - from;
        piece.start = enter, piece.end = leave;
        std::tie(piece.step.from, piece.bright_from) = look_up(from + way * enter);
        std::tie(piece.step.to, piece.bright_to) = look_up(from + way * leave);
        piece.step.triangle = t_;
        const Vec2 real = way * cover_.size;
        const double seen = glm::length(along_u_ * real.x + along_v_ * real.y);
        piece.room = static_cast<float>(seen > 0 ? area_ * glm::length(real) / seen : 0);
        piece.facing = static_cast<float>(facing_);
        return true;
    }

  private:
    std::pair<Vec3, float> look_up(Vec2 place) const {
        const Vec2 p = place - uv_[0];
        const double s = cross_of(p, b_) / det_, t = cross_of(a_, p) / det_;
        float bright = 0;
        if (!scene_.tones.at.empty()) {
            const auto& tone = scene_.tones.at[t_];
            bright = static_cast<float>(tone[0] + s * (double(tone[1]) - tone[0]) +
                                        t * (double(tone[2]) - tone[0]));
        }
        return {at_[0] + (at_[1] - at_[0]) * s + (at_[2] - at_[0]) * t, bright};
    }

    const Scene& scene_;
    std::uint32_t t_;
    const std::array<Vec2, 3>& uv_;
    const PartCover& cover_;
    std::array<Vec3, 3> at_;
    Vec2 a_{0}, b_{0}, along_u_{0}, along_v_{0};
    double det_ = 0, area_ = 0, facing_ = 0;
};

bool joins(const BarkPiece& before, const BarkPiece& after) {
    return std::abs(before.end - after.start) < kSameEnd &&
           glm::distance(before.step.to, after.step.from) < kSameEnd_px * kStepsPerPx;
}

// Of pieces of one line, by their starts. Few are open at a time.
void chain(std::span<const BarkPiece> pieces, std::vector<BarkWay>& ways) {
    std::vector<BarkWay> open;
    for (const BarkPiece& piece : pieces) {
        for (std::size_t i = open.size(); i-- > 0;) {
            if (open[i].back().end > piece.start - 2 * kSameEnd) continue;
            ways.push_back(std::move(open[i]));
            open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
        }
        const auto way = std::find_if(open.begin(), open.end(),
                                      [&](const BarkWay& w) { return joins(w.back(), piece); });
        if (way == open.end()) {
            open.push_back({piece});
        } else {
            way->push_back(piece);
        }
    }
    for (BarkWay& way : open)
        ways.push_back(std::move(way));
}

std::vector<BarkPiece> find_pieces(const Scene& scene, std::span<const PartCover> covers,
                                   double px_per_unit) {
    const Mesh& mesh = scene.mesh;
    std::vector<CoverGrid> grids(covers.begin(), covers.end());
    return gather<BarkPiece>(
        mesh.triangles.size(), [&](std::size_t i, std::vector<BarkPiece>& pieces) {
            const std::uint32_t part = mesh.part_of[i];
            const PartCover& cover = covers[part];
            if (scene.view.front[i] == 0 || cover.lines.empty()) return;
            const BarkTriangle triangle(scene, static_cast<std::uint32_t>(i), cover, px_per_unit);
            if (!triangle.is_proper()) return;
            const auto& uv = mesh.uv[i];
            thread_local std::vector<Segment> near;
            grids[part].find(glm::min(glm::min(uv[0], uv[1]), uv[2]),
                             glm::max(glm::max(uv[0], uv[1]), uv[2]), near);
            for (const Segment& s : near) {
                const std::vector<Vec2>& places = cover.lines[s.line].places;
                const Vec2 turn(s.turn * cover.around, 0);
                BarkPiece piece;
                if (!triangle.clip(places[s.index] + turn, places[s.index + 1] + turn, piece))
                    continue;
                piece.part = part, piece.line = s.line;
                piece.start += s.index, piece.end += s.index;
                pieces.push_back(piece);
            }
        });
}

}  // namespace

std::vector<BarkWay> cross_bark(const Scene& scene, std::span<const PartCover> covers,
                                double px_per_unit) {
    if (covers.empty()) return {};
    std::vector<BarkPiece> pieces = find_pieces(scene, covers, px_per_unit);
    sort_all(pieces, [](const BarkPiece& a, const BarkPiece& b) {
        return std::tie(a.part, a.line, a.start, a.step.triangle, a.end) <
               std::tie(b.part, b.line, b.start, b.step.triangle, b.end);
    });
    std::vector<BarkWay> ways;
    for (std::size_t i = 0, end = 0; i < pieces.size(); i = end) {
        while (end < pieces.size() && pieces[end].part == pieces[i].part &&
               pieces[end].line == pieces[i].line)
            ++end;
        chain(std::span(pieces).subspan(i, end - i), ways);
    }
    return ways;
}

}  // namespace edaha
