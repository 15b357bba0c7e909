// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "flatten/labelled_map.h"
#include "flatten/rays.h"
#include "flatten/tones.h"
#include "geometry/snap_round.h"

namespace edaha {

// All that stands behind a labelled map.
struct Scene {
    const Mesh& mesh;
    const View& view;
    const ToneField& tones;
    const RayScene& rays;
};

// What is seen in each face, by one ray from an interior point; a surface seen from behind has the
// darkest tone.
void label_faces(LabelledMap& map, const Scene& scene);

// What kind of line each edge is. Where labels of parts differ it is the strongest kind that lies
// on one of the two; within one part the strongest that nothing hides, by a ray from the middle of
// the edge to the eye. Contours that turn to both sides in one place, as where a facet is seen edge
// on, are none. `segments` are what the arrangement was made of. Fills LabelledMap::hidden too if
// asked.
void label_edges(LabelledMap& map, const Scene& scene, const Arrangement& arrangement,
                 std::span<const ViewSegment> segments, bool with_hidden);

}  // namespace edaha
