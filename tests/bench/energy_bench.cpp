// SPDX-License-Identifier: MIT
// Growth, limbs and wood by size of tree. Counters: per branch, so that a flat cost shows as such.
#include <benchmark/benchmark.h>

#include "energy/grow.h"
#include "energy/wood.h"

namespace edaha {
namespace {

// Both types make about 3.4 branches per unit of energy (e_stop 1, the paper's ranges).
constexpr double kBranchesPerEnergy = 3.4;

EnergyParams params_of(TreeType type, std::int64_t branches,
                       GrowthOrder order = GrowthOrder::depth) {
    EnergyParams params;
    params.growth.type = type;
    params.growth.energy = static_cast<double>(branches) / kBranchesPerEnergy;
    params.growth.order = order;
    params.space.candidates = 8;
    return params;
}

void count(benchmark::State& state, std::size_t branches) {
    using Counter = benchmark::Counter;
    state.counters["branches"] = static_cast<double>(branches);
    state.counters["per_branch"] = Counter(static_cast<double>(branches),
                                           Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void grow_tree(benchmark::State& state, TreeType type, GrowthOrder order) {
    const EnergyParams params = params_of(type, state.range(0), order);
    std::size_t branches = 0;
    for (auto _ : state) {
        const Skeleton tree = grow(params);
        branches = tree.branches.size();
        benchmark::DoNotOptimize(tree.branches.data());
    }
    count(state, branches);
}

void limbs_of_tree(benchmark::State& state, TreeType type) {
    const EnergyParams params = params_of(type, state.range(0));
    const LookParams look;
    const Skeleton tree = grow(params);
    for (auto _ : state)
        benchmark::DoNotOptimize(make_limbs(tree, params, look).nodes.data());
    count(state, tree.branches.size());
}

void wood_of_tree(benchmark::State& state, TreeType type) {
    const EnergyParams params = params_of(type, state.range(0));
    const LookParams look;
    const Skeleton tree = grow(params);
    const Limbs limbs = make_limbs(tree, params, look);
    for (auto _ : state)
        benchmark::DoNotOptimize(draw_wood(limbs, look, Palette{}).front.data());
    count(state, tree.branches.size());
}

BENCHMARK_CAPTURE(grow_tree, a_depth, TreeType::a, GrowthOrder::depth)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(grow_tree, b_depth, TreeType::b, GrowthOrder::depth)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(grow_tree, a_energy, TreeType::a, GrowthOrder::energy)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(limbs_of_tree, a, TreeType::a)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wood_of_tree, a, TreeType::a)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(wood_of_tree, b, TreeType::b)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace edaha
