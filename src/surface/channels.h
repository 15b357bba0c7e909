// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "surface/face_grid.h"
#include "surface/growing_mesh.h"

namespace edaha {

// Cuts the surface along three edges that bound no face, a -> b -> c (h is a -> b, then b -> c, c
// -> a), and closes both sides with a triangle each. What lies right of the edges gets corners of
// its own. A handle goes, or what hung together there falls in two. Returns the first corner's
// twin.
std::uint32_t cut_cycle(GrowingMesh& mesh, std::uint32_t h, std::uint32_t g, std::uint32_t i);

struct ChannelParams {
    double narrow_mm = 70;          // T_m: of the shortest of the three edges
    std::size_t most_faces = 2000;  // of a bubble
    // Of the mesh, and goes on being so: nothing is cut where a lid would pass through a face.
    FaceGrid* grid = nullptr;
};

struct Channels {
    std::size_t cut = 0, bubbles = 0;
};

// Ends channels of air through the wood, as they are left where sheets were sewn in several places
// and grew on [E]: where one is so narrow that three edges run round it, it is cut there. Wood that
// narrow, a thin twig, is left alone. What closes up as a bubble inside the wood is taken out: it
// can't be seen; an apex in it goes too. Shortest edges first; deterministic. O(edges) and
// O(most_faces) a cut.
Channels close_channels(GrowingMesh& mesh, const ChannelParams& params);

}  // namespace edaha
