// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/growth_watch.h"
#include "app/leaf_shelf.h"
#include "app/overlap.h"
#include "app/surface_report.h"
#include "app/tree_style.h"
#include "drawing/statistics.h"
#include "style/value.h"
#include "write/svg.h"

namespace edaha {
namespace {

using Json = nlohmann::ordered_json;

// Thousandths: more is noise in a report.
double rounded(double value) {
    return std::round(value * 1000) / 1000;
}

// How many limbs a limb bears, the geometric mean over the orders up to the one with most limbs
// (after Horton's law of stream numbers).
double bifurcation_ratio(const std::vector<std::size_t>& limbs_by_order) {
    const auto most = std::max_element(limbs_by_order.begin(), limbs_by_order.end());
    const auto steps = most - limbs_by_order.begin();
    if (steps == 0) return 0;
    return std::pow(static_cast<double>(*most) / static_cast<double>(limbs_by_order.front()),
                    1.0 / static_cast<double>(steps));
}

void add_model_counts(Json& json, const TreeCounts& counts) {
    json["triangles"] = counts.triangles;
    json["parts"] = counts.parts;
    if (counts.prisms) {
        json["prisms"] = counts.prisms->prisms;
        json["prisms_by_order"] = counts.prisms->by_order;
        json["prisms_turned"] = counts.prisms->turned;
        json["prisms_dropped"] = counts.prisms->dropped;
        json["foliage"] = counts.prisms->foliage;
    }
    if (counts.surface) {
        add_to_json(json, *counts.surface);
        json["sprigs"] = counts.sprigs;
    }
    if (counts.roots) {
        json["roots"] = counts.roots->roots;
        json["roots_by_order"] = counts.roots->by_order;
        json["roots_removed"] = counts.roots->removed;
    }
}

void add_energy_counts(Json& json, const TreeCounts& counts) {
    json["branches"] = counts.branches;
    json["dropped"] = counts.dropped;
    json["limbs"] = counts.limbs;
    json["limbs_by_order"] = counts.limbs_by_order;
    json["bifurcation_ratio"] = rounded(bifurcation_ratio(counts.limbs_by_order));
    json["mean_turn_deg"] = rounded(counts.mean_turn_rad * 180 / std::numbers::pi);
}

Json measurements(const Style& style, const Catalogue& catalogue, const SurfaceWatch& watch) {
    LeafShelf leaves(catalogue);
    const DrawingLoader load = leaves.loader();
    const Picture picture = draw_picture(style, load, watch);
    Style solid = style;
    solid.look.wood = Look::solid;
    const DrawingCounts counts = count(picture.drawing);
    const SvgReport svg = write_svg(picture.drawing, {}, [](std::string_view) {});
    Json json;
    json["style"] = style.name;
    json["seed"] = style.energy.variant.seed;
    json["width_mm"] = rounded(picture.drawing.width_mm);
    json["height_mm"] = rounded(picture.drawing.height_mm);
    if (makes_mesh(style)) add_model_counts(json, picture.counts);
    if (has_model(style.models, Model::energy)) add_energy_counts(json, picture.counts);
    json["leaves"] = picture.counts.ornaments;
    json["layers"] = counts.layers;
    json["shapes"] = counts.shapes;
    json["nodes"] = counts.nodes;
    json["bytes"] = svg.bytes;
    // Of areas that hide each other; a flat drawing has none.
    if (!makes_mesh(style))
        json["overlap_ratio"] = rounded(overlap_ratio(draw_picture(solid, load).drawing));
    return json;
}

}  // namespace

int measure(const Options& options, Console& console) {
    const Catalogue catalogue(console.user_folder);
    const Style style = read_tree_style(options.tree, catalogue, console).style;
    const Json json = [&] {
        GrowthWatch growth(style, console);
        return measurements(style, catalogue, growth.watch());
    }();
    if (options.json) {
        console.out << json.dump(2) << '\n';
        return 0;
    }
    for (const auto& [key, value] : json.items()) {
        console.out << fmt::format("{:<17} {}\n", key,
                                   value.is_string() ? value.get<std::string>() : value.dump());
    }
    return 0;
}

}  // namespace edaha
