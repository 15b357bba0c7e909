// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/none.h"
#include "mesh/mesh.h"

namespace edaha {

// A mesh as a body: all that its closed pieces enclose together; open ones count for nothing. The
// distance is that to the nearest triangle of a piece, its sign that of the pseudonormal there:
// of a corner the sum of its faces' normals by their angles, of an edge the sum of its two
// (Baerentzen & Aanaes 2005). All pieces run counter-clockwise seen from outside, as mend() leaves
// them; one that passes through itself has its sign wrong in places. Boxes in a tree: O(log n) near
// the surface. The same on every machine, on any number of threads.
class SolidMesh {
  public:
    explicit SolidMesh(const Mesh& mesh);

    // Signed, below 0 inside; exact where it is below `enough`, elsewhere at least that.
    double distance(const Vec3& p, double enough) const;

  private:
    struct Face {
        std::array<Vec3, 3> corners;
        Vec3 normal;  // of length 1; 0 without area
    };
    struct Pseudonormals {
        std::array<Vec3, 3> of_edges, of_corners;  // edge k leads from corner k
    };
    struct Box {
        Vec3 low{std::numeric_limits<double>::infinity()};
        Vec3 high{-std::numeric_limits<double>::infinity()};
        double squared_gap(const Vec3& p) const {
            const Vec3 off = glm::max(glm::max(low - p, p - high), Vec3(0));
            return glm::dot(off, off);
        }
    };
    struct Node {
        Box box;
        std::uint32_t first = 0, count = 0;  // faces of a leaf; other nodes have none
        std::uint32_t other = 0;             // the second child; the first comes next
    };
    // On a face: 0 to 2 an edge, 3 to 5 a corner, 6 within.
    struct Nearest {
        double squared;
        std::uint32_t face = kNone;
        std::uint32_t feature = 6;
        Vec3 place{0};
    };
    void find_corner_normals(const Mesh& mesh, std::span<const std::uint32_t> triangles);
    std::uint32_t add_node(std::span<std::uint32_t> triangles, std::uint32_t first);
    Box box_of(std::span<const std::uint32_t> triangles) const;
    Nearest nearest(std::uint32_t root, const Vec3& p, double within) const;
    void look_at_face(std::uint32_t face, const Vec3& p, Nearest& best) const;
    double signed_distance(const Nearest& nearest, const Vec3& p) const;

    std::vector<Face> faces_;
    std::vector<Pseudonormals> pseudonormals_;  // a face
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> roots_;  // a piece
};

}  // namespace edaha
