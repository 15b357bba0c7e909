// SPDX-License-Identifier: MIT
// Surface growth: all of the paper's whole trees to their ends, beside its Table 3 (147,937, 40,568
// and 56,794 polygons in 48.4, 7.6 and 6.7 minutes), and what a step costs a vertex as the mesh
// grows. Its L-systems and edges are not in the paper, so finer edges bring ours to its sizes: T_s
// and T_m are a part of its values.
#include <algorithm>
#include <chrono>
#include <string>

#include <benchmark/benchmark.h>

#include "style/catalogue.h"
#include "style/style_xml.h"
#include "surface/crossings.h"
#include "surface/surface_growth.h"

namespace edaha {
namespace {

using Clock = std::chrono::steady_clock;

SurfaceParams params_of(const std::string& style, double edges) {
    const Catalogue catalogue;
    SurfaceParams params = read_style(catalogue.find_style(style), catalogue).surface;
    params.split_mm *= edges;
    params.merge_mm *= edges;
    return params;
}

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void report(benchmark::State& state, const SurfaceGrowth& growth) {
    const GrowingMesh& mesh = growth.mesh();
    state.counters["faces"] = double(mesh.faces());
    state.counters["vertices"] = double(mesh.vertices());
    state.counters["fusions"] = double(growth.report().fusions);
    state.counters["crossing"] = double(crossing_faces(mesh).size());
}

// Hundredths of the paper's edges, as benchmarks take whole numbers.
void grow(benchmark::State& state, const std::string& style) {
    const SurfaceParams params = params_of(style, double(state.range(0)) / 100);
    for (auto _ : state) {
        SurfaceGrowth growth(params, KeyedRandom(1, 1, 1));
        while (growth.steps() < params.steps)
            growth.step();
        state.PauseTiming();
        report(state, growth);
        state.ResumeTiming();
    }
}

// Up to a number of faces, and the ten steps after that.
void step(benchmark::State& state) {
    const SurfaceParams params = params_of("paper/surface-fig27a", 0.3);
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
        report(state, growth);
    }
    state.counters["us_step_vertex"] = 1e6 * seconds / vertices;
}

BENCHMARK_CAPTURE(grow, table_3_a, "paper/surface-fig27a")
    ->Arg(100)
    ->Arg(30)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(grow, table_3_b, "paper/surface-fig27b")
    ->Arg(100)
    ->Arg(60)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(grow, table_3_c, "paper/surface-fig27c")
    ->Arg(100)
    ->Arg(50)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(grow, old_oak, "old-oak")
    ->Arg(100)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK(step)
    ->Arg(5'000)
    ->Arg(15'000)
    ->Arg(50'000)
    ->Arg(150'000)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

}  // namespace
}  // namespace edaha
