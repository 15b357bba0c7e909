// SPDX-License-Identifier: MIT
// From mesh to flat layers by size of the mesh: trees of prisms that pass through each other at
// their joints, and smooth surfaces. Counters: per triangle, so that a linear cost shows as such,
// and the seconds of each step.
#include <algorithm>
#include <cmath>
#include <queue>

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>

#include "base/keyed_random.h"
#include "flatten/flatten.h"
#include "flatten/make_map.h"
#include "style/catalogue.h"
#include "style/style_xml.h"
#include "support/flat_judge.h"
#include "support/id_buffer.h"
#include "support/meshes.h"
#include "surface/grow_surface.h"

namespace edaha {
namespace {

struct Bud {
    Vec3 place, along;  // along: the next prism, from foot to top
    double radius = 1;
    Key key = 0;
    std::uint32_t order = 0;
};

// A tree of eight-sided prisms, 28 triangles each, in the order of their distance from the root.
Mesh tree_of(std::size_t triangles) {
    const KeyedRandom random(0, 1, 1);
    Mesh mesh;
    mesh.materials.push_back({"wood", std::nullopt});
    std::queue<Bud> buds;
    buds.push({{0, 0, 0}, {0, 60, 0}, 8, 1, 0});
    while (mesh.triangles.size() < triangles) {
        const Bud bud = buds.front();
        buds.pop();
        const Mesh prism = test::prism(bud.place, bud.place + bud.along, bud.radius, 8);
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.insert(mesh.points.end(), prism.points.begin(), prism.points.end());
        while (mesh.parts.size() <= bud.order) {
            MeshPart part;
            part.name = "order-" + std::to_string(mesh.parts.size());
            mesh.parts.push_back(std::move(part));
        }
        for (const Triangle& t : prism.triangles) {
            mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
            mesh.part_of.push_back(bud.order);
        }
        for (std::uint32_t child = 0; child < 2; ++child) {
            const auto number = [&](std::uint32_t purpose) {
                return 2 * random.uniform(step(bud.key, child), purpose) - 1;
            };
            const double length = glm::length(bud.along);
            const Vec3 turn = Vec3(number(0), 0.3 + 0.3 * number(1), number(2)) * (0.9 * length);
            const Vec3 along =
                glm::normalize(bud.along + turn) * (length * (0.87 + 0.05 * number(3)));
            buds.push({bud.place + bud.along * 0.98, along, bud.radius * (0.77 + 0.05 * number(4)),
                       step(bud.key, child), bud.order + 1});
        }
    }
    return mesh;
}

void flatten_mesh(benchmark::State& state, const Mesh& mesh, FlatLook look) {
    FlattenParams params;
    params.look = look;
    params.camera.azimuth_rad = 0.3;
    params.camera.elevation_rad = 0.2;
    const FlattenInks inks{{{{0x57, 0x40, 0x38}, {0x6b, 0x4f, 0x43}, {0x82, 0x63, 0x54}}}};
    Flattened flat;
    for (auto _ : state) {
        flat = flatten(mesh, params, inks);
        benchmark::DoNotOptimize(flat.layers.data());
    }
    for (const StepReport& step : flat.steps)
        state.counters[step.name] = step.seconds;
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
    state.counters["per_triangle"] = benchmark::Counter(
        static_cast<double>(mesh.triangles.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void tree(benchmark::State& state, FlatLook look) {
    flatten_mesh(state, tree_of(static_cast<std::size_t>(state.range(0))), look);
}

void sphere(benchmark::State& state, FlatLook look) {
    const double rings = std::sqrt(static_cast<double>(state.range(0)) / 4);
    flatten_mesh(state, test::sphere({0, 0, 0}, 1, static_cast<int>(rings)), look);
}

void torus(benchmark::State& state, FlatLook look) {
    const int across = static_cast<int>(std::sqrt(static_cast<double>(state.range(0)) / 8));
    flatten_mesh(state, test::torus(3, 1, 4 * across, across), look);
}

// The map of a large tree against a depth buffer of our own: how many of 1,000 covered pixels show
// another part, and how many of them none that is seen within a pixel.
void labels_of(benchmark::State& state, const Mesh& mesh) {
    constexpr int kSize = 1000;
    FlattenParams params;
    params.resolution = kSize - 20;
    params.camera.azimuth_rad = 0.3;
    params.camera.elevation_rad = 0.2;
    test::Disagreement labels;
    for (auto _ : state) {
        StepClock clock;
        const SeenMesh seen = see_mesh(mesh, params, clock);
        const View fine = project(mesh, params.camera, test::kFine * params.resolution);
        labels = test::compare(test::paint_depth(mesh, seen.view, kSize),
                               test::paint_depth(mesh, fine, test::kFine * kSize),
                               test::paint_map(seen.map, kSize));
    }
    state.counters["covered"] = static_cast<double>(labels.covered);
    state.counters["differ_in_1000"] =
        1000 * static_cast<double>(labels.differ) / static_cast<double>(labels.covered);
    state.counters["further_than_1_px"] = static_cast<double>(labels.far);
}

// The picture of a large tree, as librsvg draws it, against that depth buffer: pixels that show
// another part, by how much; paper that shines through a wall behind the tree; how far the depth
// buffer's edges are from strokes, in pixels (not the other way: within a part it has none);
// breaches of the drawing's contract. With the smallest area as it is, and 0.
void oracles_of(benchmark::State& state, const Mesh& mesh, double min_area_px2) {
    FlattenParams params;
    params.look = FlatLook::fills_lines;
    params.resolution = test::kSize - 20;
    params.smoothing_px = 0;
    params.min_area_px2 = min_area_px2;
    params.camera.azimuth_rad = 0.3;
    params.camera.elevation_rad = 0.2;
    FlattenParams lines = params;
    lines.look = FlatLook::lines;
    lines.min_line_mm = 0;
    test::Judgement seen;
    test::StrokeDistances strokes;
    std::size_t leaks = 0;
    for (auto _ : state) {
        seen = test::judge(mesh, params);
        FlattenParams fills = params;
        fills.look = FlatLook::fills;
        leaks = test::judge(test::before_a_wall(mesh, params.camera), fills).red;
        strokes = test::stroke_distances(mesh, lines, "");
    }
    const auto percentile = [](const std::vector<double>& ascending) {
        return ascending.at(static_cast<std::size_t>(0.95 * double(ascending.size() - 1)));
    };
    state.counters["differ_in_1000"] =
        1000 * static_cast<double>(seen.labels.differ) / static_cast<double>(seen.labels.covered);
    state.counters["further_than_1_px"] = static_cast<double>(seen.labels.far);
    state.counters["further_than_2_px"] = static_cast<double>(seen.labels.very_far);
    state.counters["leaks"] = static_cast<double>(leaks);
    state.counters["breaches"] = static_cast<double>(seen.breaches.size());
    state.counters["edges_95"] = percentile(strokes.of_edges);
    state.counters["edges_most"] = strokes.of_edges.back();
}

// The largest tree whose surface grows. Its branches share 250 parts, as the oracles have colours
// for no more.
Mesh surface_tree() {
    const Catalogue catalogue;
    const Style style = read_style(catalogue.find_style("paper/surface-fig27a"), catalogue);
    Mesh mesh = grow_surface(style.surface, KeyedRandom(1, 1, 1)).mesh;
    constexpr std::uint32_t kMostParts = 250;
    for (std::uint32_t& part : mesh.part_of)
        part %= kMostParts;
    mesh.parts.resize(std::min<std::size_t>(mesh.parts.size(), kMostParts));
    return mesh;
}

void tree_labels(benchmark::State& state) {
    labels_of(state, tree_of(static_cast<std::size_t>(state.range(0))));
}
void tree_oracles(benchmark::State& state) {
    oracles_of(state, tree_of(static_cast<std::size_t>(state.range(0))), double(state.range(1)));
}
void surface_labels(benchmark::State& state) {
    labels_of(state, surface_tree());
}
void surface_oracles(benchmark::State& state) {
    oracles_of(state, surface_tree(), 2);
}

BENCHMARK(surface_labels)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(surface_oracles)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(tree_oracles)
    ->ArgsProduct({{10'000, 150'000}, {2, 0}})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK(tree_labels)->Arg(10'000)->Arg(150'000)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(tree, fills_and_lines, FlatLook::fills_lines)
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Arg(150'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(tree, facets, FlatLook::facets)
    ->Arg(150'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(sphere, lines, FlatLook::lines)
    ->Arg(150'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(sphere, tones, FlatLook::tones)
    ->Arg(150'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(torus, lines, FlatLook::lines)
    ->Arg(150'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace edaha
