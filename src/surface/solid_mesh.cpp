// SPDX-License-Identifier: MIT
#include "surface/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "mesh/facets.h"
#include "mesh/pieces.h"

namespace edaha {
namespace {

// With fewer, boxes are tested in vain; with more, faces.
constexpr std::size_t kFacesOfLeaf = 4;
constexpr std::size_t kDeepest = 64;  // a tree of halves, of 32-bit numbers, is no deeper
constexpr std::uint32_t kFirstCorner = 3, kWithin = 6;  // see Nearest

Vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : Vec3(0);
}

double angle_between(const Vec3& a, const Vec3& b) {
    return stable::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The triangles of each closed piece.
std::vector<std::vector<std::uint32_t>> closed_pieces(const Mesh& mesh,
                                                      std::span<const MeshEdge> edges) {
    const Pieces pieces = find_pieces(mesh, edges);
    std::map<std::uint32_t, std::vector<std::uint32_t>> by_root;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (pieces.is_closed[pieces.root[t]] != 0) by_root[pieces.root[t]].push_back(t);
    std::vector<std::vector<std::uint32_t>> all;
    for (auto& [root, triangles] : by_root)
        all.push_back(std::move(triangles));
    return all;
}

std::uint32_t side_from(const Triangle& triangle, std::uint32_t point) {
    return static_cast<std::uint32_t>(std::ranges::find(triangle, point) - triangle.begin());
}

}  // namespace

SolidMesh::SolidMesh(const Mesh& mesh) {
    const std::vector<MeshEdge> edges = mesh_edges(mesh);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        faces_.push_back(
            {{mesh.points[a], mesh.points[b], mesh.points[c]}, unit(facet_normal(mesh, t))});
    }
    pseudonormals_.resize(faces_.size());
    for (const MeshEdge& edge : edges) {
        if (edge.left == kNone || edge.right == kNone) continue;
        const Vec3 sum = faces_[edge.left].normal + faces_[edge.right].normal;
        pseudonormals_[edge.left].of_edges[side_from(mesh.triangles[edge.left], edge.a)] = sum;
        pseudonormals_[edge.right].of_edges[side_from(mesh.triangles[edge.right], edge.b)] = sum;
    }
    std::vector<std::uint32_t> order;
    for (std::vector<std::uint32_t>& piece : closed_pieces(mesh, edges)) {
        find_corner_normals(mesh, piece);
        const auto first = static_cast<std::uint32_t>(order.size());
        roots_.push_back(add_node(piece, first));
        order.insert(order.end(), piece.begin(), piece.end());
    }
    std::vector<Face> faces;
    std::vector<Pseudonormals> pseudonormals;
    for (const std::uint32_t t : order) {
        faces.push_back(faces_[t]);
        pseudonormals.push_back(pseudonormals_[t]);
    }
    faces_ = std::move(faces);
    pseudonormals_ = std::move(pseudonormals);
}

// Of one piece: others that touch it there have their own.
void SolidMesh::find_corner_normals(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    std::map<std::uint32_t, Vec3> at_point;
    for (const std::uint32_t t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& corners = faces_[t].corners;
            const double angle =
                angle_between(corners[(k + 1) % 3] - corners[k], corners[(k + 2) % 3] - corners[k]);
            at_point.try_emplace(mesh.triangles[t][k], 0).first->second += angle * faces_[t].normal;
        }
    }
    for (const std::uint32_t t : triangles)
        for (std::size_t k = 0; k < 3; ++k)
            pseudonormals_[t].of_corners[k] = at_point.at(mesh.triangles[t][k]);
}

SolidMesh::Box SolidMesh::box_of(std::span<const std::uint32_t> triangles) const {
    Box box;
    for (const std::uint32_t t : triangles) {
        for (const Vec3& corner : faces_[t].corners) {
            box.low = glm::min(box.low, corner);
            box.high = glm::max(box.high, corner);
        }
    }
    return box;
}

// Sorts the triangles on the way. Halves by their middles along the box's longest side.
std::uint32_t SolidMesh::add_node(std::span<std::uint32_t> triangles, std::uint32_t first) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    const Box box = box_of(triangles);
    nodes_.push_back({box, first, static_cast<std::uint32_t>(triangles.size()), 0});
    if (triangles.size() <= kFacesOfLeaf) return at;
    const Vec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto key = [&](std::uint32_t t) {
        const auto& [a, b, c] = faces_[t].corners;
        return std::pair(a[axis] + b[axis] + c[axis], t);
    };
    const std::size_t half = triangles.size() / 2;
    std::ranges::nth_element(triangles, triangles.begin() + static_cast<std::ptrdiff_t>(half), {},
                             key);
    nodes_[at].count = 0;
    add_node(triangles.first(half), first);
    const std::uint32_t other =
        add_node(triangles.subspan(half), first + static_cast<std::uint32_t>(half));
    nodes_[at].other = other;
    return at;
}

// On each edge, or within where the face lies right below the point.
void SolidMesh::look_at_face(std::uint32_t face, const Vec3& p, Nearest& best) const {
    const auto& [corners, normal] = faces_[face];
    const double height = glm::dot(p - corners[0], normal);
    if (height * height >= best.squared) return;
    const auto take = [&](const Vec3& place, std::uint32_t feature) {
        const Vec3 off = p - place;
        const double squared = glm::dot(off, off);
        if (squared < best.squared) best = {squared, face, feature, place};
    };
    bool is_within = normal != Vec3(0);
    for (std::uint32_t k = 0; k < 3; ++k) {
        const Vec3 &a = corners[k], &b = corners[(k + 1) % 3], way = b - a;
        if (is_within && glm::dot(glm::cross(normal, way), p - a) >= 0) continue;
        is_within = false;
        const double along = glm::dot(p - a, way), length2 = glm::dot(way, way);
        if (along <= 0) {
            take(a, kFirstCorner + k);
        } else if (along >= length2) {
            take(b, kFirstCorner + (k + 1) % 3);
        } else {
            take(a + way * (along / length2), k);
        }
    }
    if (is_within) take(p - normal * height, kWithin);
}

// The nearer child first, so that most others turn out to be too far.
SolidMesh::Nearest SolidMesh::nearest(std::uint32_t root, const Vec3& p, double within) const {
    struct Open {
        double gap;
        std::uint32_t node;
    };
    Nearest best{within};
    std::array<Open, kDeepest> open;
    std::size_t count = 0;
    open[count++] = {nodes_[root].box.squared_gap(p), root};
    while (count > 0) {
        const Open next = open[--count];
        if (next.gap >= best.squared) continue;
        const Node& node = nodes_[next.node];
        for (std::uint32_t i = 0; i < node.count; ++i)
            look_at_face(node.first + i, p, best);
        if (node.count > 0) continue;
        Open near{nodes_[next.node + 1].box.squared_gap(p), next.node + 1};
        Open far{nodes_[node.other].box.squared_gap(p), node.other};
        if (far.gap < near.gap) std::swap(near, far);
        open[count++] = far;
        open[count++] = near;
    }
    return best;
}

double SolidMesh::signed_distance(const Nearest& nearest, const Vec3& p) const {
    const Pseudonormals& at = pseudonormals_[nearest.face];
    const Vec3& outwards = nearest.feature == kWithin       ? faces_[nearest.face].normal
                           : nearest.feature < kFirstCorner ? at.of_edges[nearest.feature]
                                                            : at.of_corners[nearest.feature - 3];
    const double distance = std::sqrt(nearest.squared);
    return glm::dot(p - nearest.place, outwards) < 0 ? -distance : distance;
}

double SolidMesh::distance(const Vec3& p, double enough) const {
    double least = enough;
    for (const std::uint32_t root : roots_) {
        double within = std::numeric_limits<double>::infinity();
        const double gap = nodes_[root].box.squared_gap(p);
        if (gap > 0) {  // outside, so only what is nearer than the least counts
            if (least <= 0 || gap >= least * least) continue;
            within = least * least;
        }
        const Nearest found = nearest(root, p, within);
        if (found.face != kNone) least = std::min(least, signed_distance(found, p));
    }
    return least;
}

}  // namespace edaha
