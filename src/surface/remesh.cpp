// SPDX-License-Identifier: MIT
#include "surface/remesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "base/stable_math.h"
#include "surface/crossings.h"

namespace edaha {
namespace {

// After so many rounds the rest is left to the next step.
constexpr int kMostRounds = 12;
// A face may turn by this much when a corner of it is moved into another (cosine).
constexpr double kLeastTurn = 0.3;
// Faces that look at each other at less than 60 degrees make a fold (cosine of their normals).
constexpr double kFoldAngle = -0.5;
// Edges turn only on surfaces flatter than this (cosine), so that creases stay.
constexpr double kFlatEnough = 0.5;
// How much beyond two right angles the facing angles have to be: against turning back and forth.
constexpr double kFlipGain = 0.02;

struct LongEdge {
    double length2;
    std::uint32_t half_edge;
};

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
    return glm::cross(b - a, c - a);
}

double length2(const Vec3& v) {
    return glm::dot(v, v);
}

class Remesher {
  public:
    Remesher(GrowingMesh& mesh, std::span<const Apex> apices, const RemeshParams& params)
        : mesh_(mesh),
          apices_(apices),
          params_(params),
          own_grid_(params.grid
                        ? std::nullopt
                        : std::optional<FaceGrid>(std::in_place, mesh, 2 * params.split_mm)),
          grid_(params.grid ? *params.grid : *own_grid_) {}

    void run() {
        split_long();
        merge_short();
        close_folds();
        if (params_.flips) flip_all();
    }

  private:
    void place(std::uint32_t f) {
        const Corners t = corners_of(mesh_, f);
        grid_.put(f, box_round(t[0], t[1], t[2]));
    }
    // The face is not what it was, not even a part of that.
    void changed(std::uint32_t f) {
        place(f);
        mesh_.face_rest[f] = 0;
    }
    void changed_round(std::uint32_t v) {
        mesh_.vertex_rest[v] = 0;
        mesh_.for_each_out(v, [&](std::uint32_t h) { changed(h / 3); });
    }

    const Vec3& at(std::uint32_t v) const { return mesh_.position[v]; }
    double edge_length2(std::uint32_t h) const {
        return length2(at(mesh_.origin[h]) - at(mesh_.target(h)));
    }

    // Half-edges of which `wanted` holds, one an edge.
    template <typename Wanted>
    std::vector<LongEdge> edges(const Wanted& wanted) const {
        return gather<LongEdge>(mesh_.origin.size(),
                                [&](std::size_t i, std::vector<LongEdge>& found) {
                                    const auto h = static_cast<std::uint32_t>(i);
                                    if (mesh_.origin[h] == kNone || mesh_.twin[h] < h) return;
                                    const double length = edge_length2(h);
                                    if (wanted(h, length)) found.push_back({length, h});
                                });
    }

    void split_long() {
        const double most = params_.split_mm * params_.split_mm;
        std::vector<LongEdge> list =
            edges([&](std::uint32_t, double length) { return length > most; });
        for (int round = 0; round < kMostRounds && !list.empty(); ++round) {
            std::sort(list.begin(), list.end(), [](const LongEdge& a, const LongEdge& b) {
                return a.length2 != b.length2 ? a.length2 > b.length2 : a.half_edge < b.half_edge;
            });
            std::vector<std::uint32_t> added;
            for (const LongEdge& edge : list)
                if (edge_length2(edge.half_edge) > most) added.push_back(split(edge.half_edge));
            // Splits leave some of the half-edges round them to other edges: all are looked at
            // again.
            list.clear();
            for (const std::uint32_t v : added) {
                mesh_.for_each_out(v, [&](std::uint32_t h) {
                    for (const std::uint32_t edge : {h, GrowingMesh::next(h)}) {
                        if (const double length = edge_length2(edge); length > most)
                            list.push_back({length, std::min(edge, mesh_.twin[edge])});
                    }
                });
            }
        }
    }

    // Table 1.
    std::uint32_t split(std::uint32_t h) {
        const std::uint32_t a = mesh_.origin[h], b = mesh_.target(h);
        const Tissue one = mesh_.tissue[a], other = mesh_.tissue[b];
        const std::uint32_t other_face = mesh_.twin[h] / 3;
        const std::uint32_t m = split_edge(mesh_, h);
        const bool decays = one != Tissue::apex && other != Tissue::apex &&
                            (one == Tissue::xylem || other == Tissue::xylem);
        mesh_.tissue[m] = decays ? Tissue::xylem : Tissue::cambium;
        // Where two branches meet, the earlier one gets the vertex: it swells over the foot of the
        // other, which would creep over it otherwise (the faces between go to the later one).
        const std::uint32_t nearer = mesh_.branch[a] <= mesh_.branch[b] ? a : b;
        mesh_.branch[m] = mesh_.branch[nearer];
        if (mesh_.branch[a] != mesh_.branch[b]) mesh_.travel[m] = mesh_.travel[nearer];
        if (one == Tissue::apex || other == Tissue::apex) {
            const std::uint32_t apex = one == Tissue::apex ? a : b;
            born_at_apex(m, apex, apex == a ? b : a);
        } else {
            link_between(m, a, b);
            link_between(m, b, a);
        }
        mesh_.for_each_out(m, [&](std::uint32_t i) {  // the others are where they were
            if (i / 3 != h / 3 && i / 3 != other_face) place(i / 3);
        });
        return m;
    }

    // The line of phloem from `below` to `above` goes through m, if there is one.
    void link_between(std::uint32_t m, std::uint32_t below, std::uint32_t above) {
        if (mesh_.phloem_up[below] != above) return;
        mesh_.phloem_up[below] = m;
        mesh_.phloem_down[m] = below;
        mesh_.phloem_up[m] = above;
        if (mesh_.tissue[above] != Tissue::apex) mesh_.phloem_down[above] = m;
    }

    // Between an apex and cambium: takes its rate from the apex, and winds (eq. 7): the line below
    // has turned with the travel up to there, so what is added is the travel from there to here.
    void born_at_apex(std::uint32_t m, std::uint32_t apex, std::uint32_t below) {
        const Apex& tip = apices_[mesh_.branch[apex]];
        const double from_tip = glm::distance(at(m), at(apex));
        mesh_.branch[m] = mesh_.branch[apex];
        mesh_.thickening[m] = tip.state.thickening_mm;
        mesh_.travel[m] = tip.travel - from_tip;
        link_between(m, below, apex);
        mesh_.phloem_up[m] = apex;  // where no line comes from below, one begins
        if (params_.winding_rad == 0 || mesh_.branch[below] != mesh_.branch[m]) return;
        const double turn = params_.winding_rad * (mesh_.travel[m] - mesh_.travel[below]);
        const auto [sine, cosine] = stable::sin_cos(turn);
        const Vec3 axis = tip.state.frame[0];
        const Vec3 off = at(m) - at(apex);
        const Vec3 along = axis * glm::dot(off, axis), out = off - along;
        const Vec3 straight = mesh_.position[m];
        mesh_.position[m] = at(apex) + along + out * cosine + glm::cross(axis, out) * sine;
        if (crosses_round(m))
            mesh_.position[m] = straight;
        else
            changed_round(m);
    }

    bool crosses_round(std::uint32_t v) const {
        bool crosses_one = false;
        mesh_.for_each_out(v, [&](std::uint32_t h) {
            crosses_one = crosses_one || crosses(corners_of(mesh_, h / 3),
                                                 [&](std::uint32_t f) { return place_of(f); });
        });
        return crosses_one;
    }

    // Eq. 2: only what has become shorter.
    bool shrinks(std::uint32_t h, double length) const {
        if (!params_.only_shrinking) return true;
        return length < length2(mesh_.last[mesh_.origin[h]] - mesh_.last[mesh_.target(h)]);
    }

    void merge_short() {
        const double least = params_.merge_mm * params_.merge_mm;
        const auto is_short = [&](std::uint32_t h, double length) {
            return length < least && shrinks(h, length);
        };
        std::vector<LongEdge> list = edges(is_short);
        std::sort(list.begin(), list.end(), [](const LongEdge& a, const LongEdge& b) {
            return a.length2 != b.length2 ? a.length2 < b.length2 : a.half_edge < b.half_edge;
        });
        for (const LongEdge& edge : list) {
            const std::uint32_t h = edge.half_edge;
            if (mesh_.origin[h] != kNone && is_short(h, edge_length2(h))) merge(h);
        }
    }

    // How much a vertex is to be kept.
    int rank(std::uint32_t v) const {
        if (mesh_.tissue[v] == Tissue::apex) return 3;
        if (mesh_.is_bud[v] != 0) return 2;
        return mesh_.tissue[v] == Tissue::cambium ? 1 : 0;
    }

    // Table 2. Whether it could be.
    bool merge(std::uint32_t h) {
        if (rank(mesh_.origin[h]) < rank(mesh_.target(h))) h = mesh_.twin[h];
        const std::uint32_t kept = mesh_.origin[h], lost = mesh_.target(h);
        if (rank(lost) >= 2 || !can_collapse(mesh_, h)) return false;
        const bool alike = rank(kept) == rank(lost);
        const Vec3 place = alike ? (at(kept) + at(lost)) / 2.0 : at(kept);
        if (!keeps_faces(kept, lost, place) || !keeps_faces(lost, kept, place) ||
            merges_into(kept, lost, place) || merges_into(lost, kept, place))
            return false;
        const Vec3 last = alike ? (mesh_.last[kept] + mesh_.last[lost]) / 2.0 : mesh_.last[kept];
        pass_links(kept, lost);
        collapse_edge(mesh_, h);
        mesh_.position[kept] = place;
        mesh_.last[kept] = last;
        changed_round(kept);
        return true;
    }

    std::optional<Corners> place_of(std::uint32_t f) const {
        if (!mesh_.is_face(f)) return {};
        return corners_of(mesh_, f);
    }

    template <typename CornersOf>
    bool crosses(const Corners& face, const CornersOf& corners) const {
        return crosses_any(grid_, face, corners);
    }

    // Calls visit(b, c) for each face v b c that stays when v and `other` become one.
    template <typename Visit>
    void visit_staying(std::uint32_t v, std::uint32_t other, const Visit& visit) const {
        mesh_.for_each_out(v, [&](std::uint32_t h) {
            const std::uint32_t b = mesh_.target(h), c = mesh_.origin[GrowingMesh::previous(h)];
            if (b != other && c != other) visit(b, c);
        });
    }

    // Whether all faces round v that stay are what they are if v moves, and may lie there.
    bool keeps_faces(std::uint32_t v, std::uint32_t other, const Vec3& place) const {
        const double most = 4 * params_.split_mm * params_.split_mm;
        bool keeps = true;
        visit_staying(v, other, [&](std::uint32_t b, std::uint32_t c) {
            if (!keeps) return;
            const Vec3 before = area_vector(at(v), at(b), at(c));
            const Vec3 after = area_vector(place, at(b), at(c));
            const double product = glm::dot(before, after);
            const double lengths = std::sqrt(length2(before) * length2(after));
            keeps = product > kLeastTurn * lengths && length2(place - at(b)) < most &&
                    !(params_.is_barred && params_.is_barred(place, at(b), at(c)));
        });
        return keeps;
    }

    // Whether one of those passes through another one once v and `other` are one at `place`, and
    // did not before.
    bool merges_into(std::uint32_t v, std::uint32_t other, const Vec3& place) const {
        if (at(v) == place) return false;
        const auto merged = [&](std::uint32_t f) {
            std::optional<Corners> corners = place_of(f);
            if (!corners) return corners;
            int moved = 0;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t corner = mesh_.origin[3 * f + k];
                if (corner != v && corner != other) continue;
                (*corners)[k] = place;
                ++moved;
            }
            if (moved > 1) corners.reset();  // it goes
            return corners;
        };
        const auto old = [&](std::uint32_t f) { return place_of(f); };
        bool into = false;
        visit_staying(v, other, [&](std::uint32_t b, std::uint32_t c) {
            into = into ||
                   (crosses({place, at(b), at(c)}, merged) && !crosses({at(v), at(b), at(c)}, old));
        });
        return into;
    }

    // Whether the two faces at an edge look at each other across a crotch, at less than 60 degrees,
    // and their far corners are about to meet.
    bool is_fold(std::uint32_t h) const {
        const std::uint32_t t = mesh_.twin[h];
        const Vec3 &a = at(mesh_.origin[h]), &b = at(mesh_.origin[t]);
        const Vec3& c = at(mesh_.origin[GrowingMesh::previous(h)]);
        const Vec3& d = at(mesh_.origin[GrowingMesh::previous(t)]);
        if (length2(c - d) >= params_.merge_mm * params_.merge_mm) return false;
        const Vec3 n = area_vector(a, b, c), m = area_vector(b, a, d);
        return glm::dot(n, m) < kFoldAngle * std::sqrt(length2(n) * length2(m)) &&
               glm::dot(c - a, m) > 0;
    }

    // A crotch closes from its inside (section 4.3 says nothing of it) [E]: the edge at the bottom
    // of a fold turns, so that it joins the corners that face each other, and goes; both flanks
    // there go with it.
    void close_folds() {
        const std::vector<LongEdge> list =
            edges([&](std::uint32_t h, double) { return is_fold(h); });
        for (const LongEdge& edge : list) {
            const std::uint32_t h = edge.half_edge;
            if (mesh_.origin[h] == kNone || !is_fold(h) || !can_flip(mesh_, h)) continue;
            if (is_phloem(mesh_.origin[h], mesh_.target(h))) continue;
            flip(h);
            if (merge(h)) continue;
            for (int turn = 0; turn < 3; ++turn)  // four turns are none
                flip(h);
        }
    }

    // Whether the line from `low` comes to `high` soon: they are neighbours.
    bool runs_up(std::uint32_t low, std::uint32_t high) const {
        constexpr int kSoon = 8;
        for (int i = 0; i < kSoon && low != kNone; ++i) {
            low = mesh_.phloem_up[low];
            if (low == high) return true;
        }
        return false;
    }

    // What goes hands its lines on: those from below run to what stays, and so may join there; the
    // one above goes on from there, unless what stays has its own. None runs in a circle.
    void pass_links(std::uint32_t kept, std::uint32_t lost) {
        const std::uint32_t up = mesh_.phloem_up[lost], down = mesh_.phloem_down[lost];
        const bool above = runs_up(kept, lost), below = runs_up(lost, kept);
        if (above) {
            for (std::uint32_t v = mesh_.phloem_up[kept]; v != lost;) {
                const std::uint32_t after = mesh_.phloem_up[v];
                mesh_.phloem_up[v] = mesh_.phloem_down[v] = kNone;
                v = after;
            }
            mesh_.phloem_up[kept] = kNone;
        }
        mesh_.for_each_out(lost, [&](std::uint32_t h) {
            const std::uint32_t v = mesh_.target(h);
            if (v != kept && mesh_.phloem_up[v] == lost) mesh_.phloem_up[v] = kept;
            if (mesh_.phloem_down[v] == lost) mesh_.phloem_down[v] = kNone;
        });
        mesh_.phloem_up[lost] = mesh_.phloem_down[lost] = kNone;
        if (mesh_.tissue[kept] == Tissue::apex) return;
        if (!below && mesh_.phloem_up[kept] == kNone && up != kNone) {
            mesh_.phloem_up[kept] = up;
            if (mesh_.tissue[up] != Tissue::apex) mesh_.phloem_down[up] = kept;
        }
        if (mesh_.phloem_down[kept] == kNone && down != kept && !above)
            mesh_.phloem_down[kept] = down;
    }

    bool is_phloem(std::uint32_t a, std::uint32_t b) const {
        return mesh_.phloem_up[a] == b || mesh_.phloem_up[b] == a;
    }

    // Whether the angles that face the edge add up to more than two right ones, on a surface that
    // is about flat there. By their cotangents: without functions.
    bool should_flip(std::uint32_t h) const {
        const std::uint32_t t = mesh_.twin[h];
        const std::uint32_t a = mesh_.origin[h], b = mesh_.origin[t];
        if (mesh_.tissue[a] == Tissue::apex || mesh_.tissue[b] == Tissue::apex) return false;
        const std::uint32_t c = mesh_.origin[GrowingMesh::previous(h)];
        const std::uint32_t d = mesh_.origin[GrowingMesh::previous(t)];
        const Vec3 ca = at(a) - at(c), cb = at(b) - at(c), da = at(a) - at(d), db = at(b) - at(d);
        const Vec3 n = glm::cross(ca, cb), m = glm::cross(db, da);
        const double n_length = glm::length(n), m_length = glm::length(m);
        if (n_length == 0 || m_length == 0) return false;
        const double cotangents = glm::dot(ca, cb) / n_length + glm::dot(da, db) / m_length;
        if (cotangents > -kFlipGain || is_phloem(a, b)) return false;
        if (glm::dot(n, m) < kFlatEnough * n_length * m_length) return false;
        const Vec3 one = area_vector(at(a), at(d), at(c)), other = area_vector(at(d), at(b), at(c));
        const Vec3 up = n / n_length + m / m_length;
        const double least = kLeastTurn * glm::length(up);
        return glm::dot(one, up) > least * glm::length(one) &&
               glm::dot(other, up) > least * glm::length(other);
    }

    // Whether one of the faces that the edge would have after its flip may not lie there.
    bool is_barred(std::uint32_t h) const {
        const std::uint32_t t = mesh_.twin[h];
        const Vec3 &a = at(mesh_.origin[h]), &b = at(mesh_.origin[t]);
        const Vec3& c = at(mesh_.origin[GrowingMesh::previous(h)]);
        const Vec3& d = at(mesh_.origin[GrowingMesh::previous(t)]);
        if (params_.is_barred && (params_.is_barred(a, d, c) || params_.is_barred(d, b, c)))
            return true;
        const auto others = [&](std::uint32_t f) -> std::optional<Corners> {
            if (f == h / 3 || f == t / 3) return {};
            return place_of(f);
        };
        return (crosses({a, d, c}, others) || crosses({d, b, c}, others)) &&
               !crosses({a, b, c}, others) && !crosses({b, a, d}, others);
    }

    void flip(std::uint32_t h) {
        const std::uint32_t other = mesh_.twin[h] / 3;
        flip_edge(mesh_, h);
        changed(h / 3);
        changed(other);
    }

    void flip_all() {
        const std::vector<LongEdge> list =
            edges([&](std::uint32_t h, double) { return should_flip(h); });
        for (const LongEdge& edge : list) {
            const std::uint32_t h = edge.half_edge;
            if (should_flip(h) && can_flip(mesh_, h) && !is_barred(h)) flip(h);
        }
    }

    GrowingMesh& mesh_;
    std::span<const Apex> apices_;
    const RemeshParams& params_;
    std::optional<FaceGrid> own_grid_;
    FaceGrid& grid_;
};

}  // namespace

void remesh(GrowingMesh& mesh, std::span<const Apex> apices, const RemeshParams& params) {
    Remesher(mesh, apices, params).run();
}

}  // namespace edaha
