// SPDX-License-Identifier: MIT
#include "app/surface_report.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace edaha {
namespace {

double thousandths(double value) {
    return std::round(value * 1000) / 1000;
}

}  // namespace

void add_to_json(nlohmann::ordered_json& json, const SurfaceReport& report) {
    json["steps"] = report.steps;
    json["vertices"] = report.vertices;
    json["faces"] = report.faces;
    json["grown_branches"] = report.branches;
    json["fusions"] = report.fusions;
    json["pins"] = report.pins;
    json["contacts"] = report.contacts;
    json["crossing_pairs"] = report.crossing_pairs;
    json["edges_in_range"] = thousandths(report.edges.in_range);
    json["thick_edges_in_range"] = thousandths(report.edges.thick_in_range);
    json["longest_edge_mm"] = thousandths(report.edges.longest_mm);
    json["deepest_mm"] = thousandths(report.deepest_mm);
}

}  // namespace edaha
