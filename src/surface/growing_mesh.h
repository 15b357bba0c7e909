// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/none.h"
#include "mesh/mesh.h"

namespace edaha {

// What a vertex does (Mizoguchi & Miyata 2014, section 4): an apical meristem lengthens, cambium
// thickens, decaying xylem hollows out.
enum class Tissue : std::uint8_t { apex, cambium, xylem };

// A closed, oriented triangle mesh that changes: what it is, by vertex and by half-edge, with lists
// of what is free. Half-edge 3 f + k is the k-th of face f. Always a 2-manifold without boundary;
// the operations keep it so, and refuse what would not. Lengths in mm, y up.
struct GrowingMesh {
    // A vertex.
    std::vector<Vec3> position;
    std::vector<Vec3> last;  // where it was a step ago (eq. 2)
    std::vector<Tissue> tissue;
    std::vector<std::uint32_t> branch;     // the apex it came from
    std::vector<double> thickening;        // S_c, mm a step
    std::vector<double> travel;            // how far its apex had come when it was made, mm
    std::vector<std::uint32_t> phloem_up;  // the next vertex of its phloem line, or kNone
    std::vector<std::uint32_t> phloem_down;
    std::vector<std::uint32_t> name;        // its own, whatever its number becomes: by its making
    std::vector<std::uint8_t> is_bud;       // waits to become an apex: never merged away
    std::vector<std::uint8_t> vertex_rest;  // for so many steps nothing comes near; 0 if it is new
    std::vector<std::uint32_t> out;         // a half-edge that leaves it; kNone: free
    // A half-edge.
    std::vector<std::uint32_t> origin;  // kNone: its face is free
    std::vector<std::uint32_t> twin;
    std::vector<std::uint8_t> face_rest;  // a face: for so many steps it stays clear of all others
    // Free places, the last freed first.
    std::vector<std::uint32_t> free_vertices, free_faces;
    std::uint32_t names = 0;  // given so far

    static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    std::uint32_t target(std::uint32_t h) const { return origin[next(h)]; }
    bool is_vertex(std::uint32_t v) const { return out[v] != kNone; }
    bool is_face(std::uint32_t f) const { return origin[3 * f] != kNone; }
    bool has_corner(std::uint32_t f, std::uint32_t v) const {
        return origin[3 * f] == v || origin[3 * f + 1] == v || origin[3 * f + 2] == v;
    }

    std::size_t vertices() const { return position.size() - free_vertices.size(); }
    std::size_t faces() const { return origin.size() / 3 - free_faces.size(); }

    // Calls body(h) for each half-edge that leaves v, in clockwise order round it.
    template <typename Body>
    void for_each_out(std::uint32_t v, const Body& body) const {
        const std::uint32_t first = out[v];
        std::uint32_t h = first;
        do {
            body(h);
            h = next(twin[h]);
        } while (h != first);
    }
};

// Of a closed mesh whose points are all used; all of it cambium of branch 0. Throws IoError if it
// is no closed, oriented 2-manifold.
GrowingMesh growing_mesh(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

// Splits the edge of h in its middle. The new vertex is all of it the mean of both ends, cambium of
// the origin's branch, without phloem; who calls says more. Returns it.
std::uint32_t split_edge(GrowingMesh& mesh, std::uint32_t h);

// Whether the edge of h can go with its two faces and the mesh stay a manifold (the link
// condition): its ends have just two neighbours in common, and the mesh is no tetrahedron.
bool can_collapse(const GrowingMesh& mesh, std::uint32_t h);

// Moves the target of h into its origin, which stays as it is. can_collapse(h).
void collapse_edge(GrowingMesh& mesh, std::uint32_t h);

// Whether the edge of h can turn: no edge runs between the opposite corners yet, and both ends keep
// three edges.
bool can_flip(const GrowingMesh& mesh, std::uint32_t h);
void flip_edge(GrowingMesh& mesh, std::uint32_t h);

// The faces that meet at any of these vertices, sorted, each once.
std::vector<std::uint32_t> faces_round(const GrowingMesh& mesh,
                                       std::span<const std::uint32_t> vertices);
void sort_once(std::vector<std::uint32_t>& numbers);

// New places, the last freed first; without any half-edge, with no links.
std::uint32_t new_vertex(GrowingMesh& mesh);
std::uint32_t new_face(GrowingMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);
void free_vertex(GrowingMesh& mesh, std::uint32_t v);
void free_face(GrowingMesh& mesh, std::uint32_t f);
void join_twins(GrowingMesh& mesh, std::uint32_t h, std::uint32_t g);

// What is wrong with its structure, a line a fault: open or doubled edges, vertices with two fans,
// links to nothing. Empty if it is sound. Linear; for tests.
std::vector<std::string> faults(const GrowingMesh& mesh);

}  // namespace edaha
