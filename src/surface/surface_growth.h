// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/keyed_random.h"
#include "surface/apex.h"
#include "surface/collisions.h"
#include "surface/grow_surface.h"
#include "surface/growing_mesh.h"
#include "surface/growth_fields.h"
#include "surface/surface_params.h"

namespace edaha {

// A tree in the middle of its growth: what grow_surface() runs, and what tests look into after each
// step. Deterministic with any number of threads. Apices that met nothing have moved by the sum of
// s_a d (eq. 3); edges are in range but for what only shrinking may mend (eq. 2).
class SurfaceGrowth {
  public:
    // The seed (section 4.1). Throws InputError for the rules.
    SurfaceGrowth(const SurfaceParams& params, const KeyedRandom& random);

    // One step of the paper's Fig. 3: apices take their orders, all vertices move (eq. 1), the mesh
    // is made even. O(vertices). Throws IoError where there would be more faces than the limit.
    void step();

    const GrowingMesh& mesh() const { return mesh_; }
    const std::vector<Apex>& apices() const { return apices_; }
    std::int64_t steps() const { return steps_; }
    const GrowthFields& fields() const { return fields_; }
    const SurfaceReport& report() const { return report_; }

  private:
    void find_normals();
    void order_apices();
    void place_buds(std::uint32_t branch, std::vector<Bud> buds);
    std::vector<Vec3> growth_vectors() const;
    std::vector<std::uint32_t> growing_apices() const;
    void plan_moves();
    void fuse();
    void watch(std::span<const FaceBox> boxes, const RestParams& rest);
    void move_all();
    void stay_apart(std::vector<Vec3>& moves);
    void slide_all();
    void remesh_all();
    void follow_apices();
    void renumber();

    SurfaceParams params_;
    KeyedRandom random_;
    std::shared_ptr<const Rules> rules_;
    GrowingMesh mesh_;
    std::vector<Apex> apices_;
    GrowthFields fields_;
    std::vector<Vec3> of_faces_, normals_;
    std::vector<Vec3> moves_, slides_;     // of this step, a vertex
    FaceGrid grid_;                        // of the faces on their ways
    int parts_ = 1;                        // that they go in
    Facing facing_;                        // what may meet in this step
    std::vector<ClosePair> close_;         // and what may pass through each other, soon
    std::vector<FacePair> closest_;        // or in this step
    std::vector<std::uint32_t> suspects_;  // passed through something in this step or at last
    std::int64_t steps_ = 0;
    SurfaceReport report_;
};

}  // namespace edaha
