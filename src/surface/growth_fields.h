// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/keyed_random.h"
#include "surface/apex.h"
#include "surface/burls.h"
#include "surface/growing_mesh.h"
#include "surface/solids.h"
#include "surface/surface_params.h"

namespace edaha {

// What changes how cambium grows from place to place: burls (section 6), the rims and lips of
// hollows (7), obstacles (8).
class GrowthFields {
  public:
    GrowthFields(const SurfaceParams& params, const KeyedRandom& random);

    // What begins at this step: burls get their centres, hollows their xylem.
    void begin(std::int64_t step, GrowingMesh& mesh, std::span<const Apex> apices,
               std::span<const Vec3> normals);

    // The growth vectors of cambium and xylem (eqs. 4, 6, 8, 9, 10), a vertex. Cambium goes by
    // T_m / 2 at most: where many burls meet they would else tear the mesh [E]. Xylem goes as far
    // as T_m from the way of its branch's apex: a hollow leaves the other side standing [E].
    std::vector<Vec3> moves(const GrowingMesh& mesh, std::span<const Apex> apices,
                            std::span<const Vec3> normals) const;

    // Obstacles: what would enter one stops at its surface, and so do the corners of faces that
    // would reach deeper in than T_m / 10. Tells who touches: those make burl spheres (section 8).
    // Of these the largest K counts, not the sum of eq. 6: many vertices touch at one contact, and
    // it is one burl. And they last as long as the contact presses, which the paper has them for:
    // what lies all round an obstacle pushes it nowhere [E].
    void stop_at_obstacles(const GrowingMesh& mesh, std::vector<Vec3>& moves);

    // Whether a face may not lie there.
    bool is_barred(const Vec3& a, const Vec3& b, const Vec3& c) const;

    // Vertices have new numbers.
    void renumber(std::span<const std::uint32_t> vertex);

    // A vertex: 1 if it is so near to an obstacle that nothing but growth may move it.
    std::span<const std::uint8_t> near_obstacle() const { return near_; }
    std::size_t contacts() const;
    // Of all faces, how deep the deepest reaches into an obstacle; 0 if none does.
    double deepest_mm(const GrowingMesh& mesh) const;

  private:
    struct Centre {
        std::uint32_t vertex;
        double radius, core, strength;
    };
    void put_centre(GrowingMesh& mesh, std::uint32_t vertex, const BurlPlace& burl);
    void string_burls(GrowingMesh& mesh, std::span<const Apex> apices);
    void rot(std::int64_t step, GrowingMesh& mesh) const;
    std::vector<BurlSphere> spheres(const GrowingMesh& mesh) const;
    bool stop_entering(const GrowingMesh& mesh, std::vector<Vec3>& moves);
    Vec3 outward(const Vec3& p) const;
    void find_contacts(const GrowingMesh& mesh);
    bool is_at_pith(const GrowingMesh& mesh, std::span<const Apex> apices, std::uint32_t v) const;
    bool is_alone(std::span<const Vec3> centres, const Vec3& p) const;

    const SurfaceParams params_;
    std::vector<BurlPlace> places_;  // the user's and the random ones
    std::vector<Centre> centres_;
    std::vector<BurlSphere> contacts_;  // that press
    std::int64_t strung_ = 0;           // so far
    std::uint32_t foot_ = 0;            // of the line they lie on: the seed's first corner
    std::int64_t step_ = 0;
    std::vector<Solid> hollows_, obstacles_;
    std::vector<std::uint8_t> touches_, near_;
};

}  // namespace edaha
