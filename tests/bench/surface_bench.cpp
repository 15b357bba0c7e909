// SPDX-License-Identifier: MIT
// Surface growth: the paper's whole trees to their ends, beside its Table 3 (147,937, 40,568 and
// 56,794 polygons in 48.4, 7.6 and 6.7 minutes), and what a step costs a vertex as the mesh grows.
// Its L-systems are not in the paper: ours grow to its sizes with its T_s and T_m.
#include <algorithm>
#include <chrono>
#include <string>

#include <benchmark/benchmark.h>

#include "style/catalogue.h"
#include "style/style_xml.h"
#include "surface/crossings.h"
#include "surface/grow_surface.h"
#include "surface/surface_growth.h"

namespace edaha {
namespace {

using Clock = std::chrono::steady_clock;

SurfaceParams params_of(const std::string& style) {
    const Catalogue catalogue;
    return read_style(catalogue.find_style(style), catalogue).surface;
}

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void report(benchmark::State& state, const SurfaceGrowth& growth, const SurfaceParams& params) {
    const GrowingMesh& mesh = growth.mesh();
    state.counters["faces"] = double(mesh.faces());
    state.counters["vertices"] = double(mesh.vertices());
    state.counters["fusions"] = double(growth.report().fusions);
    state.counters["crossing"] = double(crossing_faces(mesh).size());
    state.counters["thick_in_range"] = edge_report(growth, params).thick_in_range;
}

void grow(benchmark::State& state, const std::string& style) {
    const SurfaceParams params = params_of(style);
    for (auto _ : state) {
        SurfaceGrowth growth(params, KeyedRandom(1, 1, 1));
        while (growth.steps() < params.steps)
            growth.step();
        state.PauseTiming();
        report(state, growth, params);
        state.ResumeTiming();
    }
}

// Up to a number of faces, and the ten steps after that.
void step(benchmark::State& state) {
    const SurfaceParams params = params_of("paper/surface-fig27a");
    double seconds = 0, vertices = 0;
    for (auto _ : state) {
        SurfaceGrowth growth(params, KeyedRandom(1, 1, 1));
        while (growth.mesh().faces() < static_cast<std::size_t>(state.range(0)) &&
               growth.steps() < params.steps)
            growth.step();
        for (int i = 0; i < 10; ++i) {
            const auto start = Clock::now();
            growth.step();
            seconds += seconds_since(start);
            vertices += double(growth.mesh().vertices());
        }
        report(state, growth, params);
    }
    state.counters["us_step_vertex"] = 1e6 * seconds / vertices;
}

#define EDAHA_GROW(name, style)          \
    BENCHMARK_CAPTURE(grow, name, style) \
        ->Repetitions(3)                 \
        ->ReportAggregatesOnly(true)     \
        ->Iterations(1)                  \
        ->Unit(benchmark::kSecond)       \
        ->UseRealTime()
EDAHA_GROW(table_3_a, "paper/surface-fig27a");
EDAHA_GROW(table_3_b, "paper/surface-fig27b");
EDAHA_GROW(table_3_c, "paper/surface-fig27c");
EDAHA_GROW(old_oak, "old-oak");
BENCHMARK(step)
    ->Arg(5'000)
    ->Arg(15'000)
    ->Arg(50'000)
    ->Arg(130'000)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

}  // namespace
}  // namespace edaha
