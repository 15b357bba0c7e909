// SPDX-License-Identifier: MIT
#include "surface/collisions.h"

#include <algorithm>
#include <cmath>

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
// Faces at an edge that turns more sharply than that (cosines; a ridge of thin wood is no fold) may
// pass through what is near.
constexpr double kSharpFold = 0.5;
constexpr double kSharpRidge = -0.05;
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

// Where the normals of a bucket's faces end: on most of a tree they look one way, and no vertex
// there sees any of them from before.
struct NormalBox {
    Vec3 low{1}, high{-1};

    bool may_face(const Vec3& normal) const {
        const Vec3 against = glm::min(low * normal, high * normal);
        return against.x + against.y + against.z < 0;
    }
};

std::vector<NormalBox> normal_boxes(const FaceGrid& grid, std::span<const Vec3> of_faces) {
    std::vector<NormalBox> boxes(grid.buckets());
    for_each_index(boxes.size(), kWorthThreads, [&](std::size_t bucket) {
        for (const std::uint32_t f : grid.faces_in(bucket)) {
            boxes[bucket].low = glm::min(boxes[bucket].low, of_faces[f]);
            boxes[bucket].high = glm::max(boxes[bucket].high, of_faces[f]);
        }
    });
    return boxes;
}

class Lookout {
  public:
    Lookout(const GrowingMesh& mesh, std::span<const Vec3> of_faces, std::span<const Vec3> normals,
            std::span<const Vec3> moves, const FacingParams& params, const FaceGrid& grid)
        : mesh_(mesh),
          of_faces_(of_faces),
          normals_(normals),
          moves_(moves),
          params_(params),
          grid_(grid),
          boxes_(normal_boxes(grid, of_faces)) {}

    void look(std::uint32_t v, std::vector<FacingPair>& found) const {
        if (!mesh_.is_vertex(v) || mesh_.tissue[v] == Tissue::xylem || normals_[v] == Vec3(0))
            return;
        const double reach = params_.near_mm + 2 * glm::length(moves_[v]);
        const Vec3& p = mesh_.position[v];
        // Round all points within `reach` that lie ahead, within 72 degrees.
        const Vec3 middle = p + normals_[v] * (reach / 2);
        const Vec3 half = Vec3(reach / 2) + reach / 2 * (Vec3(1) - glm::abs(normals_[v]));
        const std::size_t first = found.size();
        grid_.visit_of(
            box_round(middle - half, middle + half),
            [&](std::uint32_t bucket) { return boxes_[bucket].may_face(normals_[v]); },
            [&](std::uint32_t f) {
                if (glm::dot(of_faces_[f], normals_[v]) < 0) try_pair(v, f, reach, found);
            });
        const auto begin = found.begin() + static_cast<std::ptrdiff_t>(first);
        std::sort(begin, found.end(),
                  [](const FacingPair& a, const FacingPair& b) { return a.face < b.face; });
        found.erase(
            std::unique(begin, found.end(),
                        [](const FacingPair& a, const FacingPair& b) { return a.face == b.face; }),
            found.end());
    }

  private:
    void try_pair(std::uint32_t v, std::uint32_t f, double reach,
                  std::vector<FacingPair>& found) const {
        const Vec3& p = mesh_.position[v];
        const Vec3 way = nearest_point(corners_of(mesh_, f), p) - p;
        const double distance = glm::length(way);
        if (distance >= reach || glm::dot(way, of_faces_[f]) >= 0) return;
        if (glm::dot(way, normals_[v]) <= kAhead * distance) return;
        const Vec3 unit = way / distance;
        const double approach =
            std::max(0.0, glm::dot(moves_[v], unit)) + approach_of(mesh_, moves_, f, -unit);
        const double left = distance - params_.near_mm;
        if (left > approach) return;
        for (std::uint32_t k = 0; k < 3; ++k)
            if (within_two_rings(mesh_, v, mesh_.origin[3 * f + k])) return;
        found.push_back({v, f, distance, left > 0 ? left / approach : 0});
    }

    const GrowingMesh& mesh_;
    std::span<const Vec3> of_faces_, normals_, moves_;
    const FacingParams params_;
    const FaceGrid& grid_;
    const std::vector<NormalBox> boxes_;
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

void sort_once(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

std::vector<std::uint32_t> faces_round(const GrowingMesh& mesh,
                                       std::vector<std::uint32_t> vertices) {
    sort_once(vertices);
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t v : vertices)
        mesh.for_each_out(v, [&](std::uint32_t h) { faces.push_back(h / 3); });
    sort_once(faces);
    return faces;
}

std::vector<std::uint32_t> watched_faces(const GrowingMesh& mesh, std::span<const Vec3> of_faces,
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
    std::vector<std::uint32_t> middles =
        gather<std::uint32_t>(mesh.origin.size(), [&](std::size_t i, auto& found) {
            const auto h = static_cast<std::uint32_t>(i);
            if (mesh.origin[h] == kNone) return;
            if (mesh.tissue[mesh.origin[h]] != Tissue::cambium || is_sharp(h))
                found.push_back(mesh.origin[h]);
        });
    for (const std::uint32_t v : suspects)
        if (v < mesh.out.size() && mesh.is_vertex(v)) middles.push_back(v);
    for (const FacingPair& pair : pairs) {
        middles.push_back(pair.vertex);
        for (std::uint32_t k = 0; k < 3; ++k)
            middles.push_back(mesh.origin[3 * pair.face + k]);
    }
    return faces_round(mesh, std::move(middles));
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

// The boxes of all that faces pass on their way, whether they go it whole, in part, not at all or
// draw back.
std::vector<FaceBox> boxes_of_ways(const GrowingMesh& mesh, std::span<const Vec3> moves,
                                   double retreat_mm) {
    std::vector<FaceBox> boxes(mesh.origin.size() / 3);
    for_each_index(boxes.size(), kWorthThreads, [&](std::size_t i) {
        const auto f = static_cast<std::uint32_t>(i);
        if (!mesh.is_face(f)) return;
        const Corners here = corners_of(mesh, f), there = moved_corners(mesh, f, moves);
        Vec3 low = here[0], high = here[0];
        for (std::size_t k = 0; k < 3; ++k) {
            low = glm::min(low, glm::min(here[k], there[k]));
            high = glm::max(high, glm::max(here[k], there[k]));
        }
        boxes[i] = box_round(low - retreat_mm, high + retreat_mm);
    });
    return boxes;
}

// `grid` is of boxes_of_ways().
std::vector<Passing> passing(const GrowingMesh& mesh, std::span<const std::uint32_t> watched,
                             const FaceGrid& grid, std::span<const Vec3> moves) {
    constexpr std::size_t kChunk = 64;  // faces look at dozens of others each
    const auto look = [&](std::uint32_t f, std::vector<Passing>& found) {
        const Corners moved = moved_corners(mesh, f, moves);
        grid.visit(box_round(moved[0], moved[1], moved[2]), [&](std::uint32_t g) {
            if (g == f) return;
            const Corners other = moved_corners(mesh, g, moves);
            if (!overlap(moved, other) || !triangles_cross(moved, other)) return;
            Passing pair;
            pair.already = triangles_cross(corners_of(mesh, f), corners_of(mesh, g));
            for (std::uint32_t k = 0; k < 3; ++k) {
                pair.corners[k] = mesh.origin[3 * f + k];
                pair.corners[3 + k] = mesh.origin[3 * g + k];
            }
            found.push_back(pair);
        });
    };
    const std::size_t count = watched.size();
    return gather_chunks<Passing>(
        (count + kChunk - 1) / kChunk, 4, [&](std::size_t i, std::vector<Passing>& found) {
            for (std::size_t k = i * kChunk; k < std::min(count, (i + 1) * kChunk); ++k)
                look(watched[k], found);
        });
}

void shorten_approaches(const GrowingMesh& mesh, std::span<const FacingPair> pairs, double least_mm,
                        std::vector<Vec3>& moves) {
    std::vector<double> share(moves.size(), 1);
    for (const FacingPair& pair : pairs) {
        const double allowed = allowed_share(mesh, pair, least_mm, moves);
        share[pair.vertex] = std::min(share[pair.vertex], allowed);
        for (std::uint32_t k = 0; k < 3; ++k) {
            double& corner = share[mesh.origin[3 * pair.face + k]];
            corner = std::min(corner, allowed);
        }
    }
    for (std::size_t v = 0; v < moves.size(); ++v)
        moves[v] *= share[v];
}

}  // namespace

// By the region of the plane that p lies in: beside which corner or edge, or over the inside.
Vec3 nearest_point(const std::array<Vec3, 3>& triangle, const Vec3& p) {
    const auto& [a, b, c] = triangle;
    const Vec3 square = glm::cross(b - a, c - a);
    const double area = glm::dot(square, square);
    const auto inside = [&](const Vec3& from, const Vec3& to) {
        return glm::dot(glm::cross(to - from, p - from), square) >= 0;
    };
    if (area > 0 && inside(a, b) && inside(b, c) && inside(c, a))
        return p - square * (glm::dot(p - a, square) / area);
    Vec3 best = a;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &from = triangle[i], along = triangle[(i + 1) % 3] - from;
        const double length2 = glm::dot(along, along);
        const double t = length2 > 0 ? glm::dot(p - from, along) / length2 : 0;
        const Vec3 near = from + along * std::clamp(t, 0.0, 1.0);
        if (glm::dot(near - p, near - p) < glm::dot(best - p, best - p)) best = near;
    }
    return best;
}

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

Facing facing_pairs(const GrowingMesh& mesh, std::span<const Vec3> of_faces,
                    std::span<const Vec3> normals, std::span<const Vec3> moves,
                    const FacingParams& params) {
    Facing facing{{}, {}, FaceGrid(mesh, params.cell_mm)};
    const Lookout lookout(mesh, of_faces, normals, moves, params, *facing.grid);
    facing.pairs = gather<FacingPair>(mesh.position.size(), [&](std::size_t v, auto& found) {
        lookout.look(static_cast<std::uint32_t>(v), found);
    });
    facing.watched = watched_faces(mesh, of_faces, facing.pairs, params.suspects);
    return facing;
}

std::vector<std::uint32_t> keep_apart(const GrowingMesh& mesh, const Facing& facing,
                                      std::span<const Vec3> normals, const ApartParams& params,
                                      std::vector<Vec3>& moves) {
    shorten_approaches(mesh, facing.pairs, params.least_mm, moves);
    const FaceGrid grid(boxes_of_ways(mesh, moves, params.retreat_mm), params.cell_mm);
    std::vector<std::uint32_t> back, watched = facing.watched;
    for (int round = 0; round < kRounds && !watched.empty(); ++round) {
        std::vector<std::uint32_t> changed;
        for (const Passing& pair : passing(mesh, watched, grid, moves)) {
            if (pair.already) back.insert(back.end(), pair.corners.begin(), pair.corners.end());
            for (const std::uint32_t v : pair.corners) {
                const Vec3 move = pair.already ? -params.retreat_mm * normals[v] : Vec3(0);
                if (move != moves[v]) changed.push_back(v);
                moves[v] = move;
            }
        }
        watched = faces_round(mesh, std::move(changed));  // all others move as they did
    }
    sort_once(back);
    return back;
}

}  // namespace edaha
