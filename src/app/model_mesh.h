// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "base/keyed_random.h"
#include "mesh/mesh.h"
#include "prism/prism_tree.h"
#include "proproot/prop_root_mesh.h"
#include "style/style.h"
#include "surface/grow_surface.h"

namespace edaha {

struct RootCounts {
    std::size_t roots = 0;
    std::size_t removed = 0;            // left out because they would have passed through others
    std::vector<std::size_t> by_order;  // from order 1
};

// Where a root stands on the ground, in space.
struct RootFoot {
    Vec3 middle{0};
    double radius = 0;
};

// What the models of a style that make meshes make together. y up, the foot in the origin.
struct ModelMesh {
    Mesh mesh;
    std::optional<PrismCounts> prisms;
    std::optional<RootCounts> roots;
    std::vector<RootFoot> root_feet;
    std::optional<SurfaceReport> surface;
    std::optional<TrunkTop> top;  // of prop roots: where a crown goes on
};

KeyedRandom random_of(const Style& style);

bool makes_mesh(const Style& style);

// Empty if no model makes one. Prisms stand on the trunk of prop roots if there are any, as thick
// as that. A tree whose surface grows stands first, obstacles that are seen behind it. Errors:
// IoError, as the models' own. `watch` is told of surface growth.
ModelMesh make_model_mesh(const Style& style, const SurfaceWatch& watch = {});

// Of one step of a tree whose surface grows.
ModelMesh model_of(const Style& style, SurfaceTree tree, std::int64_t step);

}  // namespace edaha
