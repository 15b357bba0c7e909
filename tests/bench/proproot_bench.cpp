// SPDX-License-Identifier: MIT
// Prop roots by age: time to grow them and to make their mesh, and their build beside what was
// measured on Rhizophora stylosa in the field. Yoshikai et al. 2021: 71 roots at a stem of 10 cm
// and 268 at 20 cm (ours: 10 + x / 5 cm); roots incline 34 to 44 degrees on average; counts by
// layer fall to a third over some 34 cm. Bands to look at, not to tune by.
#include <cmath>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "proproot/prop_root_mesh.h"

namespace edaha {
namespace {

constexpr int kSeeds = 10;

PropRootParams params_of(const benchmark::State& state) {
    PropRootParams params;
    params.primaries = static_cast<int>(state.range(0));
    params.heights = state.range(1) == 0 ? RootHeights::uniform : RootHeights::geometric;
    return params;
}

PropRoots plant(const PropRootParams& params, int seed) {
    return grow_prop_roots(params, KeyedRandom(1, static_cast<std::uint64_t>(seed), 1));
}

// Roots that pass each layer of 5 cm.
std::vector<double> count_layers(const PropRoots& roots) {
    std::vector<double> layers(40, 0);
    for (const PropRoot& root : roots.roots) {
        const double top = root.curve.height(root.curve.apex);
        for (std::size_t i = 0; i < layers.size() && 5 * double(i) < top; ++i)
            layers[i] += 1;
    }
    return layers;
}

void report_build(benchmark::State& state, const PropRootParams& params) {
    double roots = 0, removed = 0, incline = 0, fall_cm = 0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        const PropRoots it = plant(params, seed);
        roots += double(it.roots.size());
        removed += double(it.removed);
        double angles = 0;
        for (const PropRoot& root : it.roots)
            angles += std::atan2(root.base.y, root.curve.at_height(0));
        incline += angles / double(it.roots.size());
        const std::vector<double> layers = count_layers(it);
        std::size_t layer = 0;
        while (layers[layer] * std::numbers::e > layers[0])
            ++layer;
        fall_cm += 5 * double(layer);
    }
    state.counters["roots"] = roots / kSeeds;
    state.counters["removed"] = removed / kSeeds;
    state.counters["incline_deg"] = incline / kSeeds * 180 / std::numbers::pi;
    state.counters["fall_cm"] = fall_cm / kSeeds;
}

void grow(benchmark::State& state) {
    const PropRootParams params = params_of(state);
    int seed = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(plant(params, ++seed % kSeeds).roots.data());
    report_build(state, params);
}

void make_mesh(benchmark::State& state) {
    const PropRootParams params = params_of(state);
    const PropRoots roots = plant(params, 1);
    std::size_t triangles = 0;
    for (auto _ : state) {
        const Mesh mesh = mesh_of(roots, params);
        triangles = mesh.triangles.size();
        benchmark::DoNotOptimize(mesh.points.data());
    }
    state.counters["triangles"] = double(triangles);
}

BENCHMARK(grow)->ArgsProduct({{7, 20, 49, 100}, {0, 1}})->Unit(benchmark::kMillisecond);
BENCHMARK(make_mesh)->ArgsProduct({{7, 20, 49, 100}, {0}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace edaha
