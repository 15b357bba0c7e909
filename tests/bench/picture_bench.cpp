// SPDX-License-Identifier: MIT
// From a style to its picture and its SVG, in one process: what `edaha draw` does without its
// start. The paper's sizes, the built-in kinds, and a million branches.
#include <map>
#include <string>

#include <benchmark/benchmark.h>

#include "app/overlap.h"
#include "app/pipeline.h"
#include "style/catalogue.h"
#include "style/style_xml.h"
#include "write/svg.h"

namespace edaha {
namespace {

LeafImport load_leaf(const std::string& name) {
    const Catalogue catalogue;
    return read_leaf(catalogue.find_leaf(name).text, name);
}

const DrawingLoader load{load_leaf, {}};

Style style_of(const std::string& name) {
    const Catalogue catalogue;
    return read_style(catalogue.find_style(name), catalogue);
}

void draw_to_svg(benchmark::State& state, Style style) {
    std::size_t branches = 0, bytes = 0;
    for (auto _ : state) {
        style.energy.variant.seed += 1;
        const Picture picture = draw_picture(style, load);
        bytes = write_svg(picture.drawing, {}, [](std::string_view) {}).bytes;
        branches = picture.counts.branches;
    }
    state.counters["branches"] = static_cast<double>(branches);
    state.counters["bytes"] = static_cast<double>(bytes);
}

void draw_named(benchmark::State& state, const char* name) {
    draw_to_svg(state, style_of(name));
}

void draw_million(benchmark::State& state) {
    Style style = style_of("paper/energy-a-1000-space");
    style.energy.growth.energy = 290'000;
    style.look.straight = false;
    draw_to_svg(state, style);
}

// A variant of `edaha batch`: a cherry of some two thousand shapes, whose leaves are read already,
// step by step on one thread.
class Variant {
  public:
    Variant() : style_(style_of("cherry")) {
        style_.energy.growth.energy = 300;
        for (const OrnamentParams* ornament : {&style_.leaf, &style_.blossom})
            leaves_.emplace(ornament->shape, load_leaf(ornament->shape));
    }

    Picture draw() {
        style_.energy.variant.seed = style_.energy.variant.seed % 20 + 1;
        return draw_picture(style_,
                            {[&](const std::string& name) { return leaves_.at(name); }, {}});
    }

  private:
    Style style_;
    std::map<std::string, LeafImport> leaves_;
};

void count(benchmark::State& state, const char* name, std::size_t number) {
    const auto value = static_cast<double>(number);
    state.counters[name] = value;
    state.counters[std::string("per_") + name] = benchmark::Counter(
        value, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void draw_variant(benchmark::State& state) {
    Variant variant;
    std::size_t branches = 0;
    for (auto _ : state)
        branches = variant.draw().counts.branches;
    count(state, "branch", branches);
}

void write_variant(benchmark::State& state) {
    const Picture picture = Variant().draw();
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = write_svg(picture.drawing, {}, [](std::string_view) {}).bytes;
    count(state, "byte", bytes);
}

void overlap_of_variant(benchmark::State& state) {
    const Picture picture = Variant().draw();
    for (auto _ : state)
        benchmark::DoNotOptimize(overlap_ratio(picture.drawing));
    count(state, "ornament", picture.counts.ornaments);
}

BENCHMARK(draw_variant)->Unit(benchmark::kMicrosecond);
BENCHMARK(write_variant)->Unit(benchmark::kMicrosecond);
BENCHMARK(overlap_of_variant)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(draw_named, a_100, "paper/energy-a-100-space")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(draw_named, a_500, "paper/energy-a-500-space")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(draw_named, a_1000, "paper/energy-a-1000-space")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(draw_named, b_100, "paper/energy-b-100-space")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(draw_named, b_500, "paper/energy-b-500-space")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(draw_named, b_1000, "paper/energy-b-1000-space")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(draw_named, cherry, "cherry")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(draw_named, oak, "oak")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(draw_million)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace edaha
