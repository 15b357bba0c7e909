// SPDX-License-Identifier: MIT
// Trees of prisms by size, with and without the search for what stands in the way.
#include <benchmark/benchmark.h>

#include "prism/prism_tree.h"

namespace edaha {
namespace {

// Two-way trees have 2^depth - 1 prisms.
void grow_two_way(benchmark::State& state, bool interference) {
    PrismParams params;
    params.straight = params.mixed = 0;
    params.depth = state.range(0);
    params.radius_mm = 3;
    params.alpha = params.beta = {0.2, 0.6};
    params.interference = interference;
    std::size_t prisms = 0;
    for (auto _ : state) {
        const PrismTree tree = grow_prisms(params, KeyedRandom(1, 1, 1));
        prisms = tree.counts.prisms;
        benchmark::DoNotOptimize(tree.mesh.points.data());
    }
    using Counter = benchmark::Counter;
    state.counters["prisms"] = static_cast<double>(prisms);
    state.counters["per_prism"] =
        Counter(static_cast<double>(prisms), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

BENCHMARK_CAPTURE(grow_two_way, free, false)->DenseRange(8, 17, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(grow_two_way, interference, true)
    ->DenseRange(8, 17, 3)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace edaha
