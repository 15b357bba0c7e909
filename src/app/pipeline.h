// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/model_mesh.h"
#include "base/error.h"
#include "drawing/drawing.h"
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
};

struct Picture {
    Drawing drawing;  // without metadata
    TreeCounts counts;
    std::vector<Problem> warnings;  // of the leaf drawings
};

// Gives the drawing of a leaf by its name or path; throws InputError or IoError.
using LeafLoader = std::function<LeafImport(const std::string& name)>;

// The whole way from a style to its picture, in order.
Picture draw_picture(const Style& style, const LeafLoader& load_leaf);

}  // namespace edaha
