// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/model_mesh.h"
#include "base/error.h"
#include "drawing/drawing.h"
#include "energy/ground.h"
#include "flatten/flatten.h"
#include "ornament/bark_drawing.h"
#include "ornament/leaf.h"
#include "style/style.h"

namespace edaha {

// What growth made, for reports.
struct TreeCounts {
    std::size_t branches = 0;
    std::size_t dropped = 0;
    std::size_t limbs = 0;
    std::size_t ornaments = 0;                // leaves, blossoms and fruit
    std::vector<std::size_t> limbs_by_order;  // the trunk has order 0
    double mean_turn_rad = 0;                 // of a branch from its parent, either way
    std::size_t triangles = 0;                // of the models that make meshes
    std::size_t parts = 0;
    std::optional<PrismCounts> prisms;
    std::optional<RootCounts> roots;
    std::optional<SurfaceReport> surface;
    std::size_t sprigs = 0;
};

struct Picture {
    Drawing drawing;  // without metadata
    TreeCounts counts;
    std::vector<Problem> warnings;  // of the leaf and bark drawings
    std::vector<StepReport> steps;  // of growing and flattening meshes
};

// Give the drawing of a leaf or a bark tile by its name or path; throw InputError or IoError.
struct DrawingLoader {
    std::function<LeafImport(const std::string& name)> leaf;
    std::function<BarkImport(const std::string& name)> bark;
};

// The whole way from a style to its picture, in order.
// `watch` is told of surface growth.
Picture draw_picture(const Style& style, const DrawingLoader& load, const SurfaceWatch& watch = {});

// What pictures of one growth share: each takes what is set, and sets the rest.
struct FixedView {
    double mm_per_unit = 0;
    std::optional<Stand> stand;  // of water and mound, which don't grow
};

// From a model that is there to its picture, on no page yet.
Picture draw_model_picture(const Style& style, const DrawingLoader& load, ModelMesh model,
                           FixedView& view);

}  // namespace edaha
