// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>

#include "base/keyed_random.h"
#include "mesh/mesh.h"
#include "surface/surface_params.h"

namespace edaha {

class SurfaceGrowth;

// The edges of a mesh. Round wood that is thinner than T_m run edges that are shorter, and stay:
// they do not shrink (eq. 2).
struct EdgeReport {
    double in_range = 0;        // share of edges between T_m and T_s
    double thick_in_range = 0;  // the same of those at least T_m from their branch's way
    std::size_t thick = 0;      // how many those are
    double longest_mm = 0;
};
EdgeReport edge_report(const SurfaceGrowth& growth, const SurfaceParams& params);

// The report of a run (spec of the system: section 8).
struct SurfaceReport {
    std::int64_t steps = 0;
    std::size_t vertices = 0, faces = 0;
    std::size_t branches = 0;        // apices that grew
    std::size_t fusions = 0;         // sheets sewn together
    std::size_t pins = 0;            // met, but could not be sewn
    std::size_t contacts = 0;        // vertices that an obstacle stopped
    std::size_t crossing_pairs = 0;  // of faces, at the end
    EdgeReport edges;
    double deepest_mm = 0;  // of a face inside an obstacle
    double seconds = 0;
};

struct SurfaceTree {
    Mesh mesh;  // one closed surface; parts are branches, materials "wood" and "xylem"; with (u,v)
    SurfaceReport report;
};

// Called after each step with the mesh as it is then, if `wants(step)`.
struct SurfaceWatch {
    std::function<void(std::int64_t step, std::size_t faces)> progress;
    std::function<bool(std::int64_t step)> wants;
    std::function<void(std::int64_t step, SurfaceTree tree)> frame;
};

// A tree whose surface grows, after Mizoguchi & Miyata, "Modeling Trees Using Surface Growth
// Simulation" (2014): each step moves every vertex by its growth vector (eq. 1) and re-meshes. In
// mm, y up, the foot in the origin. The same bytes with any number of threads. O(vertices) a step.
// IoError where a limit would be passed or a file can't be read; InputError for the rules.
SurfaceTree grow_surface(const SurfaceParams& params, const KeyedRandom& random,
                         const SurfaceWatch& watch = {});

}  // namespace edaha
