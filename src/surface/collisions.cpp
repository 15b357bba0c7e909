// SPDX-License-Identifier: MIT
#include "surface/collisions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "surface/crossings.h"
#include "surface/face_grid.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 2000;
// What is met lies within 72 degrees of the normal (cosine): what slides past at the side is none
// of this vertex's business, but of one that looks there.
constexpr double kAhead = 0.3;
// Faces at an edge that turns more sharply than that (cosines) may pass through what is near.
// Ridges count from right angles on, and a little less: through the other side of a thin square
// twig a vertex comes by sliding along it.
constexpr double kSharpFold = 0.5;
constexpr double kSharpRidge = 0.15;
// After so many rounds all that could still pass through each other has been stopped, in practice.
constexpr int kRounds = 4;

// The fastest of the face's corners towards p.
double approach_of(const GrowingMesh& mesh, std::span<const Vec3> moves, std::uint32_t face,
                   const Vec3& way) {
    double most = 0;
    for (std::uint32_t k = 0; k < 3; ++k)
        most = std::max(most, glm::dot(moves[mesh.origin[3 * face + k]], way));
    return most;
}

class Lookout {
  public:
    Lookout(const GrowingMesh& mesh, const StepPlan& plan, const FaceGrid& grid,
            const FacingParams& params)
        : mesh_(mesh),
          of_faces_(plan.of_faces),
          normals_(plan.normals),
          moves_(plan.growth),
          grid_(grid),
          params_(params) {}

    // Returns for how many steps it may rest.
    std::uint8_t look(std::uint32_t v, std::vector<FacingPair>& found) const {
        if (!mesh_.is_vertex(v) || mesh_.tissue[v] == Tissue::xylem || normals_[v] == Vec3(0))
            return 0;
        const double speed = glm::length(moves_[v]);
        const bool is_fast = speed > params_.rest.fast_mm;
        double free_mm = is_fast ? 0 : params_.rest.horizon_mm;
        const double reach = params_.near_mm + 2 * speed + free_mm;
        const Vec3& p = mesh_.position[v];
        // Round all points within `reach` that lie ahead, within 72 degrees.
        const Vec3 middle = p + normals_[v] * (reach / 2);
        const Vec3 half = Vec3(reach / 2) + reach / 2 * (Vec3(1) - glm::abs(normals_[v]));
        const std::size_t first = found.size();
        grid_.visit(box_round(middle - half, middle + half), [&](std::uint32_t f) {
            if (glm::dot(of_faces_[f], normals_[v]) < 0)
                free_mm = std::min(free_mm, try_pair(v, f, params_.near_mm + free_mm, found));
        });
        std::sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
                  [](const FacingPair& a, const FacingPair& b) { return a.face < b.face; });
        return steps_of_rest(free_mm, speed, params_.rest);
    }

  private:
    // Returns how far they are from being near, if they face each other.
    double try_pair(std::uint32_t v, std::uint32_t f, double near,
                    std::vector<FacingPair>& found) const {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        const Vec3& p = mesh_.position[v];
        const Vec3 way = nearest_point(corners_of(mesh_, f), p) - p;
        const double distance = glm::length(way);
        if (glm::dot(way, of_faces_[f]) >= 0) return kFar;
        if (glm::dot(way, normals_[v]) <= kAhead * distance) return kFar;
        const Vec3 unit = way / distance;
        const double approach =
            std::max(0.0, glm::dot(moves_[v], unit)) + approach_of(mesh_, moves_, f, -unit);
        const double left = distance - params_.near_mm;
        if (left > approach && distance > near) return kFar;
        for (std::uint32_t k = 0; k < 3; ++k)
            if (within_two_rings(mesh_, v, mesh_.origin[3 * f + k])) return kFar;
        if (left <= approach) found.push_back({v, f, distance, left > 0 ? left / approach : 0});
        return left;
    }

    const GrowingMesh& mesh_;
    std::span<const Vec3> of_faces_, normals_, moves_;
    const FaceGrid& grid_;
    const FacingParams params_;
};

// How much of their moves the vertex and the face's corners may go.
double allowed_share(const GrowingMesh& mesh, const FacingPair& pair, double least_mm,
                     std::span<const Vec3> moves) {
    const Vec3& p = mesh.position[pair.vertex];
    const Vec3 way = nearest_point(corners_of(mesh, pair.face), p) - p;
    const double distance = glm::length(way);
    if (distance == 0) return 0;
    const Vec3 unit = way / distance;
    const double approach = std::max(0.0, glm::dot(moves[pair.vertex], unit)) +
                            approach_of(mesh, moves, pair.face, -unit);
    const double left = std::max(0.0, distance - least_mm);
    return approach <= left ? 1 : left / approach;
}

Corners moved_corners(const GrowingMesh& mesh, std::uint32_t f, std::span<const Vec3> moves) {
    Corners corners = corners_of(mesh, f);
    for (std::uint32_t k = 0; k < 3; ++k)
        corners[k] += moves[mesh.origin[3 * f + k]];
    return corners;
}

// Corners of two faces that pass through each other once they have moved.
struct Passing {
    std::array<std::uint32_t, 6> corners{};
    bool already = false;  // before, too
};

bool overlap(const Corners& a, const Corners& b) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto [a_low, a_high] = std::minmax({a[0][axis], a[1][axis], a[2][axis]});
        const auto [b_low, b_high] = std::minmax({b[0][axis], b[1][axis], b[2][axis]});
        if (a_low > b_high || b_low > a_high) return false;
    }
    return true;
}

// What happens to two faces when they move.
std::optional<Passing> passing(const GrowingMesh& mesh, std::span<const Vec3> moves,
                               const FacePair& pair) {
    const Corners one = moved_corners(mesh, pair[0], moves),
                  other = moved_corners(mesh, pair[1], moves);
    if (!overlap(one, other) || !triangles_cross(one, other)) return std::nullopt;
    Passing found;
    found.already = triangles_cross(corners_of(mesh, pair[0]), corners_of(mesh, pair[1]));
    for (std::uint32_t k = 0; k < 3; ++k) {
        found.corners[k] = mesh.origin[3 * pair[0] + k];
        found.corners[3 + k] = mesh.origin[3 * pair[1] + k];
    }
    return found;
}

std::vector<Passing> passing_pairs(const GrowingMesh& mesh, std::span<const Vec3> moves,
                                   std::span<const FacePair> pairs) {
    constexpr std::size_t kChunk = 512;
    return gather<Passing>(
        pairs.size(),
        [&](std::size_t i, std::vector<Passing>& found) {
            if (const auto pair = passing(mesh, moves, pairs[i])) found.push_back(*pair);
        },
        kChunk);
}

// Of faces that have left their ways with any others.
std::vector<Passing> passing_faces(const GrowingMesh& mesh, std::span<const Vec3> moves,
                                   const FaceGrid& grid, std::span<const std::uint32_t> faces) {
    constexpr std::size_t kChunk = 64;  // faces look at dozens of others each
    return gather<Passing>(
        faces.size(),
        [&](std::size_t i, std::vector<Passing>& found) {
            const Corners moved = moved_corners(mesh, faces[i], moves);
            grid.visit(box_round(moved[0], moved[1], moved[2]), [&](std::uint32_t g) {
                if (g == faces[i]) return;
                if (const auto pair = passing(mesh, moves, {faces[i], g})) found.push_back(*pair);
            });
        },
        kChunk);
}

// Of what a vertex may go only a part.
struct Allowed {
    std::uint32_t vertex;
    double share;
    bool operator<(const Allowed& other) const {
        return std::tie(vertex, share) < std::tie(other.vertex, other.share);
    }
};

void shorten_approaches(const GrowingMesh& mesh, std::span<const FacingPair> pairs, double least_mm,
                        std::vector<Vec3>& moves) {
    std::vector<Allowed> all;
    for (const FacingPair& pair : pairs) {
        const double share = allowed_share(mesh, pair, least_mm, moves);
        if (share >= 1) continue;
        all.push_back({pair.vertex, share});
        for (std::uint32_t k = 0; k < 3; ++k)
            all.push_back({mesh.origin[3 * pair.face + k], share});
    }
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size(); ++i)  // the least of a vertex comes first
        if (i == 0 || all[i].vertex != all[i - 1].vertex) moves[all[i].vertex] *= all[i].share;
}

}  // namespace

bool within_two_rings(const GrowingMesh& mesh, std::uint32_t from, std::uint32_t v) {
    bool found = from == v;
    mesh.for_each_out(from, [&](std::uint32_t h) {
        const std::uint32_t near = mesh.target(h);
        found = found || near == v;
        if (found) return;
        mesh.for_each_out(near, [&](std::uint32_t g) { found = found || mesh.target(g) == v; });
    });
    return found;
}

std::vector<std::uint8_t> watched_faces(const GrowingMesh& mesh, std::span<const Vec3> of_faces,
                                        std::span<const FacingPair> pairs,
                                        std::span<const std::uint32_t> suspects) {
    const auto is_sharp = [&](std::uint32_t h) {
        const std::uint32_t t = mesh.twin[h];
        const double cosine = glm::dot(of_faces[h / 3], of_faces[t / 3]);
        if (cosine >= kSharpFold) return false;
        const Vec3& beyond = mesh.position[mesh.origin[GrowingMesh::previous(t)]];
        return cosine < kSharpRidge ||
               glm::dot(beyond - mesh.position[mesh.origin[h]], of_faces[h / 3]) > 0;
    };
    std::vector<std::uint8_t> marks(mesh.out.size(), 0);
    for_each_index(marks.size(), kWorthThreads, [&](std::size_t i) {
        const auto v = static_cast<std::uint32_t>(i);
        if (!mesh.is_vertex(v)) return;
        bool marked = mesh.tissue[v] != Tissue::cambium;
        if (!marked) mesh.for_each_out(v, [&](std::uint32_t h) { marked = marked || is_sharp(h); });
        marks[v] = marked;
    });
    for (const std::uint32_t v : suspects)
        marks[v] = 1;
    for (const FacingPair& pair : pairs) {
        marks[pair.vertex] = 1;
        for (std::uint32_t k = 0; k < 3; ++k)
            marks[mesh.origin[3 * pair.face + k]] = 1;
    }
    std::vector<std::uint8_t> is_watched(mesh.origin.size() / 3, 0);
    for_each_index(is_watched.size(), kWorthThreads, [&](std::size_t f) {
        const std::uint32_t* v = &mesh.origin[3 * f];
        if (v[0] != kNone) is_watched[f] = marks[v[0]] | marks[v[1]] | marks[v[2]];
    });
    return is_watched;
}

void wake_before(GrowingMesh& mesh, const StepPlan& plan, const FaceGrid& grid,
                 const FacingParams& params) {
    constexpr std::size_t kChunk = 32;  // each looks at dozens of faces
    const auto is_before = [&](std::uint32_t v, const Vec3& p) {
        const Vec3 way = p - mesh.position[v];
        return glm::dot(way, plan.normals[v]) > kAhead * glm::length(way);
    };
    const auto woken = gather<std::uint32_t>(
        params.apices.size(),
        [&](std::size_t i, std::vector<std::uint32_t>& found) {
            const Vec3 &from = mesh.position[params.apices[i]],
                       to = from + plan.growth[params.apices[i]];
            grid.visit(
                box_round(glm::min(from, to) - params.near_mm, glm::max(from, to) + params.near_mm),
                [&](std::uint32_t f) {
                    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
                        const std::uint32_t v = mesh.origin[h];
                        if (mesh.vertex_rest[v] > 0 && (is_before(v, from) || is_before(v, to)))
                            found.push_back(v);
                    }
                });
        },
        kChunk);
    for (const std::uint32_t v : woken)
        mesh.vertex_rest[v] = 0;
}

Facing facing_pairs(const GrowingMesh& mesh, const StepPlan& plan, const FaceGrid& grid,
                    const FacingParams& params) {
    Facing facing;
    facing.rest.assign(mesh.position.size(), 0);
    const Lookout lookout(mesh, plan, grid, params);
    facing.pairs = gather<FacingPair>(mesh.position.size(), [&](std::size_t i, auto& found) {
        const auto v = static_cast<std::uint32_t>(i);
        const std::uint8_t rest = mesh.vertex_rest[v];
        facing.rest[v] = rest > 0 ? rest - 1 : lookout.look(v, found);
    });
    return facing;
}

std::vector<std::uint32_t> keep_apart(const GrowingMesh& mesh, std::span<const Vec3> normals,
                                      const FaceGrid& grid, const ApartParams& params,
                                      std::vector<Vec3>& moves) {
    shorten_approaches(mesh, params.pairs, params.least_mm, moves);
    std::vector<Passing> now = passing_pairs(mesh, moves, params.closest);
    const std::vector<Passing> more =
        passing_faces(mesh, moves, grid, faces_round(mesh, params.off_their_ways));
    now.insert(now.end(), more.begin(), more.end());
    std::vector<std::uint32_t> back;
    for (int round = 1; !now.empty(); ++round) {
        std::vector<std::uint32_t> changed;
        for (const Passing& pair : now) {
            if (pair.already) back.insert(back.end(), pair.corners.begin(), pair.corners.end());
            for (const std::uint32_t v : pair.corners) {
                const Vec3 move = pair.already ? -params.retreat_mm * normals[v] : Vec3(0);
                if (move != moves[v]) changed.push_back(v);
                moves[v] = move;
            }
        }
        if (round == kRounds) break;
        // All others move as they did.
        now = passing_faces(mesh, moves, grid, faces_round(mesh, changed));
    }
    sort_once(back);
    return back;
}

}  // namespace edaha
