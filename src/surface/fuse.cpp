// SPDX-License-Identifier: MIT
#include "surface/fuse.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "surface/crossings.h"
#include "surface/face_grid.h"
#include "surface/move.h"

namespace edaha {
namespace {

// Faces of a tube side by side turn by less than this (cosine of 143 degrees).
constexpr double kSharpest = -0.8;

// The loop of half-edges that is left when the fan of a vertex goes: those of other faces, and the
// vertices they end at, so that new faces run from at[i] to at[i + 1] along outside[i].
struct OpenLoop {
    std::vector<std::uint32_t> at, outside;
    std::size_t size() const { return at.size(); }
};

OpenLoop loop_round(const GrowingMesh& mesh, std::uint32_t v) {
    OpenLoop loop;
    mesh.for_each_out(v, [&](std::uint32_t h) {
        loop.at.push_back(mesh.target(h));
        loop.outside.push_back(mesh.twin[GrowingMesh::next(h)]);
    });
    // Out of clockwise order: counter-clockwise, as the fan's faces had them.
    std::reverse(loop.at.begin(), loop.at.end());
    std::reverse(loop.outside.begin(), loop.outside.end());
    return loop;
}

bool holds(const std::vector<std::uint32_t>& list, std::uint32_t item) {
    return std::find(list.begin(), list.end(), item) != list.end();
}

// Whether no vertex is in both stars, and no edge runs from one loop to the other.
bool are_apart(const GrowingMesh& mesh, std::uint32_t a, const OpenLoop& one, std::uint32_t b,
               const OpenLoop& other) {
    if (a == b || holds(one.at, b) || holds(other.at, a)) return false;
    return std::none_of(one.at.begin(), one.at.end(), [&](std::uint32_t v) {
        bool joined = holds(other.at, v);
        mesh.for_each_out(
            v, [&](std::uint32_t h) { joined = joined || holds(other.at, mesh.target(h)); });
        return joined;
    });
}

// The tube between two loops as a walk: at each step either the first loop goes on (true) or the
// second, which runs backwards from `start`.
struct Seam {
    std::size_t start = 0;
    std::vector<bool> first_goes;
    double length = std::numeric_limits<double>::infinity();
};

class SeamFinder {
  public:
    SeamFinder(const GrowingMesh& mesh, const OpenLoop& one, const OpenLoop& other)
        : mesh_(mesh), one_(one), other_(other) {}

    // The least sum of the diagonals' lengths over all starts; none if an edge would be doubled.
    std::optional<Seam> shortest() const {
        Seam best;
        for (std::size_t start = 0; start < other_.size(); ++start) {
            Seam seam = shortest_from(start);
            if (seam.length < best.length && !doubles(seam)) best = std::move(seam);
        }
        if (best.first_goes.empty()) return std::nullopt;
        return best;
    }

    std::uint32_t first(std::size_t i) const { return one_.at[i % one_.size()]; }
    std::size_t second_place(const Seam& seam, std::size_t j) const {
        return (seam.start + 2 * other_.size() - j) % other_.size();
    }
    std::uint32_t second(const Seam& seam, std::size_t j) const {
        return other_.at[second_place(seam, j)];
    }

  private:
    // Dynamic programming over how far each loop has gone.
    Seam shortest_from(std::size_t start) const {
        const std::size_t n = one_.size(), m = other_.size(), width = m + 1;
        Seam seam{start, {}, 0};
        std::vector<double> least((n + 1) * width, 0);
        std::vector<std::uint8_t> by_first((n + 1) * width, 0);
        for (std::size_t i = 0; i <= n; ++i) {
            for (std::size_t j = 0; j <= m; ++j) {
                if (i == 0 && j == 0) continue;
                const double by_one = i > 0 ? least[(i - 1) * width + j] : kFar;
                const double by_other = j > 0 ? least[i * width + j - 1] : kFar;
                by_first[i * width + j] = by_one <= by_other;
                least[i * width + j] =
                    std::min(by_one, by_other) +
                    glm::distance(mesh_.position[first(i)], mesh_.position[second(seam, j)]);
            }
        }
        seam.length = least.back();
        for (std::size_t i = n, j = m; i > 0 || j > 0;) {
            const bool goes = by_first[i * width + j] != 0;
            seam.first_goes.push_back(goes);
            --(goes ? i : j);
        }
        std::reverse(seam.first_goes.begin(), seam.first_goes.end());
        return seam;
    }

    bool doubles(const Seam& seam) const {
        std::vector<std::array<std::size_t, 2>> edges;
        std::size_t i = 0, j = 0;
        for (const bool goes : seam.first_goes) {
            ++(goes ? i : j);
            edges.push_back({i % one_.size(), j % other_.size()});
        }
        std::sort(edges.begin(), edges.end());
        return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
    }

    static constexpr double kFar = std::numeric_limits<double>::infinity();
    const GrowingMesh& mesh_;
    const OpenLoop &one_, &other_;
};

// A face of the tube, and which half-edge outside lies along its first edge.
struct TubeFace {
    Triangle corners;
    std::uint32_t outside = kNone;
    bool of_first = true;
};

std::vector<TubeFace> tube_faces(const SeamFinder& finder, const Seam& seam, const OpenLoop& one,
                                 const OpenLoop& other) {
    std::vector<TubeFace> faces;
    std::size_t i = 0, j = 0;
    for (const bool goes : seam.first_goes) {
        if (goes) {
            faces.push_back({{finder.first(i), finder.first(i + 1), finder.second(seam, j)},
                             one.outside[i],
                             true});
            ++i;
        } else {
            const std::size_t from = finder.second_place(seam, j + 1);
            faces.push_back({{other.at[from], finder.second(seam, j), finder.first(i)},
                             other.outside[from],
                             false});
            ++j;
        }
    }
    return faces;
}

Vec3 middle_of(const GrowingMesh& mesh, const OpenLoop& loop) {
    Vec3 sum(0);
    for (const std::uint32_t v : loop.at)
        sum += mesh.position[v];
    return sum / static_cast<double>(loop.size());
}

// Whether the tube as a whole looks outwards, and no two of its faces that meet at an edge lie on
// each other.
bool is_smooth_tube(const std::vector<Corners>& faces, const Vec3& middle) {
    double volume = 0;
    std::vector<Vec3> normals;
    for (const Corners& face : faces) {
        const Vec3 normal = glm::cross(face[1] - face[0], face[2] - face[0]);
        volume += glm::dot(normal, face[0] - middle);
        const double length = glm::length(normal);
        if (length == 0) return false;
        normals.push_back(normal / length);
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (glm::dot(normals[i], normals[(i + 1) % normals.size()]) < kSharpest) return false;
    return volume > 0;
}

// Whether a face passes through one that stays: all but those round a and b.
bool passes_through(const GrowingMesh& mesh, const FaceGrid& grid, const Corners& face,
                    std::uint32_t a, std::uint32_t b) {
    return crosses_any(grid, face, [&](std::uint32_t f) -> std::optional<Corners> {
        if (!mesh.is_face(f) || mesh.has_corner(f, a) || mesh.has_corner(f, b)) return {};
        return corners_of(mesh, f);
    });
}

bool stands_well(const GrowingMesh& mesh, const std::vector<TubeFace>& tube, const Vec3& middle,
                 std::uint32_t a, std::uint32_t b, const SewLimits& limits) {
    std::vector<Corners> faces;
    for (const TubeFace& face : tube)
        faces.push_back({mesh.position[face.corners[0]], mesh.position[face.corners[1]],
                         mesh.position[face.corners[2]]});
    if (!is_smooth_tube(faces, middle)) return false;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Corners& face = faces[i];
        if (limits.is_barred && limits.is_barred(face[0], face[1], face[2])) return false;
        if (limits.grid && passes_through(mesh, *limits.grid, face, a, b)) return false;
        for (std::size_t j = i + 1; j < faces.size(); ++j)
            if (triangles_cross(face, faces[j])) return false;
    }
    return true;
}

void cut_links(GrowingMesh& mesh, std::uint32_t v) {
    for (std::uint32_t i = 0; i < 2; ++i) {
        auto& to = i == 0 ? mesh.phloem_up : mesh.phloem_down;
        auto& back = i == 0 ? mesh.phloem_down : mesh.phloem_up;
        if (to[v] != kNone && back[to[v]] == v) back[to[v]] = kNone;
        to[v] = kNone;
    }
    mesh.for_each_out(v, [&](std::uint32_t h) {
        const std::uint32_t near = mesh.target(h);
        if (mesh.phloem_up[near] == v) mesh.phloem_up[near] = kNone;
        if (mesh.phloem_down[near] == v) mesh.phloem_down[near] = kNone;
    });
}

void remove_fan(GrowingMesh& mesh, std::uint32_t v) {
    cut_links(mesh, v);
    std::vector<std::uint32_t> faces;
    mesh.for_each_out(v, [&](std::uint32_t h) { faces.push_back(h / 3); });
    for (const std::uint32_t f : faces)
        free_face(mesh, f);
    free_vertex(mesh, v);
}

// Each face is left by the edge across the tube by which the next one is entered.
void add_tube(GrowingMesh& mesh, const std::vector<TubeFace>& faces) {
    std::vector<std::uint32_t> entered, left;
    for (const TubeFace& face : faces) {
        const auto& [a, b, c] = face.corners;
        mesh.vertex_rest[a] = mesh.vertex_rest[b] = mesh.vertex_rest[c] = 0;
        const std::uint32_t h = 3 * new_face(mesh, a, b, c);
        join_twins(mesh, h, face.outside);
        entered.push_back(face.of_first ? h + 2 : h + 1);
        left.push_back(face.of_first ? h + 1 : h + 2);
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
        join_twins(mesh, left[i], entered[(i + 1) % faces.size()]);
}

// What might be sewn: a vertex that meets a face, and the corner of it that it merges with.
struct Meeting {
    double distance2;
    std::uint32_t a, b;
    bool operator<(const Meeting& other) const {
        return std::tie(distance2, a, b) < std::tie(other.distance2, other.a, other.b);
    }
};

bool may_go(const GrowingMesh& mesh, std::uint32_t v) {
    return mesh.is_vertex(v) && mesh.is_bud[v] == 0 && mesh.tissue[v] != Tissue::xylem &&
           mesh.position[v].y > kGround_mm;
}

std::vector<Meeting> meetings(const GrowingMesh& mesh, std::span<const FacingPair> pairs,
                              std::span<const Vec3> normals) {
    std::vector<Meeting> found;
    for (const FacingPair& pair : pairs) {
        const std::uint32_t a = pair.vertex;
        if (!may_go(mesh, a)) continue;
        Meeting nearest{std::numeric_limits<double>::infinity(), a, kNone};
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t b = mesh.origin[3 * pair.face + k];
            const Vec3 way = mesh.position[b] - mesh.position[a];
            if (!may_go(mesh, b) || glm::dot(normals[a], normals[b]) >= 0) continue;
            nearest = std::min(nearest, Meeting{glm::dot(way, way), a, b});
        }
        if (nearest.b != kNone) found.push_back(nearest);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

bool sew(GrowingMesh& mesh, std::uint32_t a, std::uint32_t b, const SewLimits& limits) {
    const OpenLoop one = loop_round(mesh, a), other = loop_round(mesh, b);
    if (!are_apart(mesh, a, one, b, other)) return false;
    const SeamFinder finder(mesh, one, other);
    const std::optional<Seam> seam = finder.shortest();
    if (!seam) return false;
    const std::vector<TubeFace> faces = tube_faces(finder, *seam, one, other);
    const Vec3 middle = (middle_of(mesh, one) + middle_of(mesh, other)) / 2.0;
    if (!stands_well(mesh, faces, middle, a, b, limits)) return false;
    remove_fan(mesh, a);
    remove_fan(mesh, b);
    add_tube(mesh, faces);
    return true;
}

Fusions fuse_facing(GrowingMesh& mesh, std::vector<Apex>& apices, std::span<const FacingPair> pairs,
                    std::span<const Vec3> normals, const SewLimits& limits) {
    Fusions fusions;
    for (const Meeting& meeting : meetings(mesh, pairs, normals)) {
        if (!mesh.is_vertex(meeting.a) || !mesh.is_vertex(meeting.b)) continue;
        std::vector<std::uint32_t> ended;
        for (const std::uint32_t v : {meeting.a, meeting.b})
            if (mesh.tissue[v] == Tissue::apex) ended.push_back(mesh.branch[v]);
        if (!sew(mesh, meeting.a, meeting.b, limits)) continue;
        for (const std::uint32_t branch : ended)
            apices[branch].grows = false;
        ++fusions.sewn;
    }
    std::uint32_t last = kNone;
    for (const FacingPair& pair : pairs) {
        if (pair.vertex != last && mesh.is_vertex(pair.vertex)) ++fusions.pinned;
        last = pair.vertex;
    }
    return fusions;
}

}  // namespace edaha
