// SPDX-License-Identifier: MIT
#include "surface/growing_mesh.h"

#include <algorithm>
#include <array>

#include "base/error.h"

namespace edaha {

namespace {

// Every half-edge from one vertex to another, sorted: those that run both ways lie together.
struct KeyedHalfEdge {
    std::uint32_t low, high, h;
    bool operator<(const KeyedHalfEdge& b) const {
        return std::array{low, high, h} < std::array{b.low, b.high, b.h};
    }
};

void join_all(GrowingMesh& mesh) {
    std::vector<KeyedHalfEdge> edges;
    edges.reserve(mesh.origin.size());
    for (std::uint32_t h = 0; h < mesh.origin.size(); ++h) {
        const std::uint32_t a = mesh.origin[h];
        const std::uint32_t b = mesh.target(h);
        edges.push_back({std::min(a, b), std::max(a, b), h});
    }
    std::sort(edges.begin(), edges.end());
    if (edges.size() % 2 != 0) throw IoError("the mesh is not closed");
    for (std::size_t i = 0; i < edges.size(); i += 2) {
        const KeyedHalfEdge& a = edges[i];
        const KeyedHalfEdge& b = edges[i + 1];
        if (a.low != b.low || a.high != b.high)
            throw IoError("the mesh is not closed, or an edge has more than two triangles");
        if (mesh.origin[a.h] == mesh.origin[b.h])
            throw IoError("two triangles at an edge face opposite ways");
        join_twins(mesh, a.h, b.h);
    }
}

std::size_t degree(const GrowingMesh& mesh, std::uint32_t v) {
    std::size_t count = 0;
    mesh.for_each_out(v, [&](std::uint32_t) { ++count; });
    return count;
}

bool has_edge(const GrowingMesh& mesh, std::uint32_t a, std::uint32_t b) {
    bool found = false;
    mesh.for_each_out(a, [&](std::uint32_t h) { found = found || mesh.target(h) == b; });
    return found;
}

void set_face(GrowingMesh& mesh, std::uint32_t f, const Triangle& corners) {
    for (std::uint32_t k = 0; k < 3; ++k) {
        mesh.origin[3 * f + k] = corners[k];
        mesh.out[corners[k]] = 3 * f + k;
    }
    mesh.face_rest[f] = 0;
}

// Takes v out of its phloem line, whose neighbours then hang together.
void unlink(GrowingMesh& mesh, std::uint32_t v) {
    const std::uint32_t up = mesh.phloem_up[v];
    const std::uint32_t down = mesh.phloem_down[v];
    if (up != kNone && mesh.phloem_down[up] == v) mesh.phloem_down[up] = down;
    if (down != kNone && mesh.phloem_up[down] == v) mesh.phloem_up[down] = up;
    mesh.phloem_up[v] = kNone;
    mesh.phloem_down[v] = kNone;
}

void check_half_edge(const GrowingMesh& mesh, std::uint32_t h, std::vector<std::string>& found) {
    const std::string name = "half-edge " + std::to_string(h);
    const std::uint32_t twin = mesh.twin[h];
    if (!mesh.is_vertex(mesh.origin[h])) found.push_back(name + " leaves a free vertex");
    if (mesh.origin[h] == mesh.target(h)) found.push_back(name + " is a loop");
    if (twin == kNone || twin >= mesh.origin.size()) {
        found.push_back(name + " is open");
    } else if (mesh.twin[twin] != h || mesh.origin[twin] != mesh.target(h) ||
               mesh.target(twin) != mesh.origin[h]) {
        found.push_back(name + " disagrees with its twin");
    }
}

// Two half-edges from one vertex to another; `leaving` counts those of each vertex.
void check_doubles(const GrowingMesh& mesh, std::vector<std::uint32_t>& leaving,
                   std::vector<std::string>& found) {
    std::vector<std::array<std::uint32_t, 2>> ends;
    for (std::uint32_t h = 0; h < mesh.origin.size(); ++h) {
        if (mesh.origin[h] == kNone) continue;
        ends.push_back({mesh.origin[h], mesh.target(h)});
        ++leaving[mesh.origin[h]];
    }
    std::sort(ends.begin(), ends.end());
    for (auto at = std::adjacent_find(ends.begin(), ends.end()); at != ends.end();
         at = std::adjacent_find(at + 1, ends.end())) {
        found.push_back("two half-edges from " + std::to_string((*at)[0]) + " to " +
                        std::to_string((*at)[1]));
    }
}

void check_fan(const GrowingMesh& mesh, std::uint32_t v, std::uint32_t leaving,
               std::vector<std::string>& found) {
    const std::string name = "vertex " + std::to_string(v);
    if (mesh.out[v] >= mesh.origin.size() || mesh.origin[mesh.out[v]] != v) {
        found.push_back(name + " is left by a half-edge of another");
        return;
    }
    const std::size_t fan = degree(mesh, v);
    if (fan != leaving) found.push_back(name + " has two fans");
    if (fan < 3) found.push_back(name + " has fewer than three edges");
}

void check_links(const GrowingMesh& mesh, std::uint32_t v, std::vector<std::string>& found) {
    for (const std::uint32_t other : {mesh.phloem_up[v], mesh.phloem_down[v]}) {
        if (other == kNone) continue;
        if (other >= mesh.out.size() || !mesh.is_vertex(other))
            found.push_back("vertex " + std::to_string(v) + " has a link to nothing");
    }
}

}  // namespace

void sort_once(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

GrowingMesh growing_mesh(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
    GrowingMesh mesh;
    for (const Vec3& point : points) {
        const std::uint32_t v = new_vertex(mesh);
        mesh.position[v] = point;
        mesh.last[v] = point;
    }
    for (const auto& [a, b, c] : triangles) {
        if (std::max({a, b, c}) >= points.size()) throw IoError("a triangle has no such point");
        if (a == b || b == c || c == a) throw IoError("a triangle has a corner twice");
        new_face(mesh, a, b, c);
    }
    join_all(mesh);
    for (std::uint32_t v = 0; v < points.size(); ++v)
        if (!mesh.is_vertex(v)) throw IoError("a point has no triangle");
    if (!faults(mesh).empty()) throw IoError("the mesh is not a manifold: " + faults(mesh).front());
    return mesh;
}

//      c              c           h = a b becomes a m; the face left of it is a m c, the new
//    / | \          / | \         one m b c; on the other side m a d stays, and b m d is new.
//   a--+--b   ->   a--m--b
//    \ | /          \ | /
//      d              d
std::uint32_t split_edge(GrowingMesh& mesh, std::uint32_t h) {
    const std::uint32_t g = mesh.twin[h];
    const std::uint32_t a = mesh.origin[h], b = mesh.origin[g];
    const std::uint32_t right = GrowingMesh::next(h), left = GrowingMesh::previous(g);
    const std::uint32_t c = mesh.target(right), d = mesh.origin[left];
    const std::uint32_t beyond_right = mesh.twin[right], beyond_left = mesh.twin[left];
    const std::uint32_t m = new_vertex(mesh);
    mesh.position[m] = (mesh.position[a] + mesh.position[b]) / 2.0;
    mesh.last[m] = (mesh.last[a] + mesh.last[b]) / 2.0;
    mesh.branch[m] = mesh.branch[a];
    mesh.thickening[m] = (mesh.thickening[a] + mesh.thickening[b]) / 2;
    mesh.travel[m] = (mesh.travel[a] + mesh.travel[b]) / 2;

    mesh.origin[right] = m;
    mesh.origin[g] = m;
    mesh.out[m] = right;
    mesh.out[a] = h;
    const std::uint32_t upper = 3 * new_face(mesh, m, b, c);
    const std::uint32_t lower = 3 * new_face(mesh, b, m, d);
    // g's face was b a d and is m a d now: its edge d b has become d m.
    join_twins(mesh, upper, lower);
    join_twins(mesh, upper + 1, beyond_right);
    join_twins(mesh, upper + 2, right);
    join_twins(mesh, lower + 1, left);
    join_twins(mesh, lower + 2, beyond_left);
    return m;
}

bool can_collapse(const GrowingMesh& mesh, std::uint32_t h) {
    const std::uint32_t a = mesh.origin[h], b = mesh.target(h);
    std::size_t common = 0;
    mesh.for_each_out(a, [&](std::uint32_t i) {
        const std::uint32_t c = mesh.target(i);
        if (c != b && has_edge(mesh, b, c)) ++common;
    });
    if (common != 2) return false;
    // The opposite corners lose an edge each, and the merged vertex keeps all but four.
    const std::uint32_t c = mesh.origin[GrowingMesh::previous(h)];
    const std::uint32_t d = mesh.origin[GrowingMesh::previous(mesh.twin[h])];
    return degree(mesh, c) > 3 && degree(mesh, d) > 3 && degree(mesh, a) + degree(mesh, b) >= 7;
}

void collapse_edge(GrowingMesh& mesh, std::uint32_t h) {
    const std::uint32_t g = mesh.twin[h];
    const std::uint32_t a = mesh.origin[h], b = mesh.origin[g];
    const std::uint32_t b_to_c = GrowingMesh::next(h), c_to_a = GrowingMesh::previous(h);
    const std::uint32_t a_to_d = GrowingMesh::next(g), d_to_b = GrowingMesh::previous(g);
    const std::uint32_t c = mesh.origin[c_to_a], d = mesh.origin[d_to_b];
    const std::uint32_t a_c = mesh.twin[c_to_a], c_b = mesh.twin[b_to_c];
    const std::uint32_t b_d = mesh.twin[d_to_b], d_a = mesh.twin[a_to_d];
    unlink(mesh, b);
    std::uint32_t at = mesh.out[b];
    do {
        mesh.origin[at] = a;
        at = GrowingMesh::next(mesh.twin[at]);
    } while (at != mesh.out[b]);
    join_twins(mesh, a_c, c_b);
    join_twins(mesh, b_d, d_a);
    mesh.out[a] = a_c;
    mesh.out[c] = c_b;
    mesh.out[d] = d_a;
    free_face(mesh, h / 3);
    free_face(mesh, g / 3);
    free_vertex(mesh, b);
}

bool can_flip(const GrowingMesh& mesh, std::uint32_t h) {
    const std::uint32_t g = mesh.twin[h];
    const std::uint32_t c = mesh.origin[GrowingMesh::previous(h)];
    const std::uint32_t d = mesh.origin[GrowingMesh::previous(g)];
    return c != d && degree(mesh, mesh.origin[h]) > 3 && degree(mesh, mesh.origin[g]) > 3 &&
           !has_edge(mesh, c, d);
}

// Faces a b c and b a d become d c a and c d b; h runs from d to c then.
void flip_edge(GrowingMesh& mesh, std::uint32_t h) {
    const std::uint32_t g = mesh.twin[h];
    const std::uint32_t a = mesh.origin[h], b = mesh.origin[g];
    const std::uint32_t h1 = GrowingMesh::next(h), h2 = GrowingMesh::previous(h);
    const std::uint32_t g1 = GrowingMesh::next(g), g2 = GrowingMesh::previous(g);
    const std::uint32_t c = mesh.origin[h2], d = mesh.origin[g2];
    const std::uint32_t b_c = mesh.twin[h1], c_a = mesh.twin[h2];
    const std::uint32_t a_d = mesh.twin[g1], d_b = mesh.twin[g2];
    const std::array<std::uint32_t, 6> places{h, h1, h2, g, g1, g2};
    const std::array<std::uint32_t, 6> origins{d, c, a, c, d, b};
    for (std::size_t i = 0; i < places.size(); ++i) {
        mesh.origin[places[i]] = origins[i];
        mesh.out[origins[i]] = places[i];
    }
    join_twins(mesh, h1, c_a);
    join_twins(mesh, h2, a_d);
    join_twins(mesh, g1, d_b);
    join_twins(mesh, g2, b_c);
}

std::vector<std::uint32_t> faces_round(const GrowingMesh& mesh,
                                       std::span<const std::uint32_t> vertices) {
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t v : vertices)
        mesh.for_each_out(v, [&](std::uint32_t h) { faces.push_back(h / 3); });
    sort_once(faces);
    return faces;
}

std::uint32_t new_vertex(GrowingMesh& mesh) {
    if (!mesh.free_vertices.empty()) {
        const std::uint32_t v = mesh.free_vertices.back();
        mesh.free_vertices.pop_back();
        mesh.name[v] = mesh.names++;
        return v;
    }
    const auto v = static_cast<std::uint32_t>(mesh.position.size());
    mesh.position.emplace_back(0);
    mesh.last.emplace_back(0);
    mesh.tissue.push_back(Tissue::cambium);
    mesh.branch.push_back(0);
    mesh.thickening.push_back(0);
    mesh.travel.push_back(0);
    mesh.phloem_up.push_back(kNone);
    mesh.phloem_down.push_back(kNone);
    mesh.name.push_back(mesh.names++);
    mesh.is_bud.push_back(0);
    mesh.vertex_rest.push_back(0);
    mesh.out.push_back(kNone);
    return v;
}

std::uint32_t new_face(GrowingMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint32_t f = 0;
    if (mesh.free_faces.empty()) {
        f = static_cast<std::uint32_t>(mesh.origin.size() / 3);
        mesh.origin.resize(mesh.origin.size() + 3, kNone);
        mesh.twin.resize(mesh.twin.size() + 3, kNone);
        mesh.face_rest.push_back(0);
    } else {
        f = mesh.free_faces.back();
        mesh.free_faces.pop_back();
    }
    set_face(mesh, f, {a, b, c});
    return f;
}

void free_vertex(GrowingMesh& mesh, std::uint32_t v) {
    unlink(mesh, v);
    mesh.position[v] = mesh.last[v] = Vec3(0);
    mesh.tissue[v] = Tissue::cambium;
    mesh.branch[v] = 0;
    mesh.thickening[v] = mesh.travel[v] = 0;
    mesh.is_bud[v] = mesh.vertex_rest[v] = 0;
    mesh.out[v] = kNone;
    mesh.free_vertices.push_back(v);
}

void free_face(GrowingMesh& mesh, std::uint32_t f) {
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        mesh.origin[h] = kNone;
        mesh.twin[h] = kNone;
    }
    mesh.face_rest[f] = 0;
    mesh.free_faces.push_back(f);
}

void join_twins(GrowingMesh& mesh, std::uint32_t h, std::uint32_t g) {
    mesh.twin[h] = g;
    mesh.twin[g] = h;
}

std::vector<std::string> faults(const GrowingMesh& mesh) {
    std::vector<std::string> found;
    for (std::uint32_t h = 0; h < mesh.origin.size(); ++h)
        if (mesh.origin[h] != kNone) check_half_edge(mesh, h, found);
    // Walks round a vertex would not end on what is open.
    if (!found.empty()) return found;
    std::vector<std::uint32_t> leaving(mesh.out.size(), 0);
    check_doubles(mesh, leaving, found);
    for (std::uint32_t v = 0; v < mesh.out.size(); ++v) {
        if (!mesh.is_vertex(v)) continue;
        check_fan(mesh, v, leaving[v], found);
        check_links(mesh, v, found);
    }
    return found;
}

}  // namespace edaha
