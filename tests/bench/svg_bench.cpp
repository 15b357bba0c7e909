// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "base/number_text.h"
#include "drawing/check.h"
#include "support/sample_drawing.h"
#include "write/path_text.h"
#include "write/svg.h"

namespace edaha {
namespace {

void write_numbers(benchmark::State& state) {
    std::string text;
    for (auto _ : state) {
        text.clear();
        for (int i = 0; i < 10000; ++i)
            append_number(text, 0.37 * i - 1800, 2);
        benchmark::DoNotOptimize(text.data());
    }
    const auto chars = state.iterations() * static_cast<std::int64_t>(text.size());
    state.counters["chars/s"] =
        benchmark::Counter(static_cast<double>(chars), benchmark::Counter::kIsRate);
}
BENCHMARK(write_numbers);

// Arguments: thousands of paths and, as many, of instances.
void write_svg_of_field(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0)) * 1000;
    const Drawing drawing = test::field_drawing(count, count);
    std::size_t bytes = 0;
    for (auto _ : state) {
        bytes = write_svg(drawing, {}, [](std::string_view text) {
                    benchmark::DoNotOptimize(text.data());
                }).bytes;
    }
    const auto total = static_cast<double>(state.iterations()) * static_cast<double>(bytes);
    state.counters["bytes/s"] = benchmark::Counter(total, benchmark::Counter::kIsRate);
    state.counters["bytes"] = static_cast<double>(bytes);
    const auto nodes = static_cast<double>(state.iterations()) * 2 * static_cast<double>(count);
    state.counters["time/element"] =
        benchmark::Counter(nodes, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(write_svg_of_field)->Arg(10)->Arg(500)->Unit(benchmark::kMillisecond);

void check_field(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0)) * 1000;
    const Drawing drawing = test::field_drawing(count, count);
    for (auto _ : state)
        benchmark::DoNotOptimize(check(drawing).size());
}
BENCHMARK(check_field)->Arg(10)->Arg(500)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace edaha
