// SPDX-License-Identifier: MIT
// From a style to its picture and its SVG, in one process: what `edaha draw` does without its
// start. The paper's sizes, the built-in kinds, and a million branches.
#include <benchmark/benchmark.h>

#include "app/pipeline.h"
#include "style/catalogue.h"
#include "style/style_xml.h"
#include "write/svg.h"

namespace edaha {
namespace {

LeafImport load(const std::string& name) {
    const Catalogue catalogue;
    return read_leaf(catalogue.find_leaf(name).text, name);
}

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
