// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "mesh/edges.h"
#include "mesh/mesh_check.h"
#include "mesh/obj.h"
#include "mesh/ply.h"

namespace edaha {
namespace {

// A closed surface of 2 n^2 triangles, like a torus; its points are numbered in rows.
Mesh torus(std::uint32_t n) {
    Mesh mesh;
    mesh.points.resize(std::size_t{n} * n);
    for (std::uint32_t y = 0; y < n; ++y) {
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t right = (x + 1) % n, up = (y + 1) % n;
            mesh.points[y * n + x] = {x, y, x * y % 7};
            mesh.triangles.push_back({y * n + x, y * n + right, up * n + right});
            mesh.triangles.push_back({y * n + x, up * n + right, up * n + x});
        }
    }
    mesh.part_of.resize(mesh.triangles.size());
    mesh.parts.resize(1);
    mesh.materials.resize(1);
    return mesh;
}

void count_per_triangle(benchmark::State& state, const Mesh& mesh) {
    const double total =
        static_cast<double>(state.iterations()) * static_cast<double>(mesh.triangles.size());
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
    state.counters["time/triangle"] =
        benchmark::Counter(total, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Argument: points round the torus.
void edges_of_torus(benchmark::State& state) {
    const Mesh mesh = torus(static_cast<std::uint32_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(mesh_edges(mesh).data());
    count_per_triangle(state, mesh);
}
BENCHMARK(edges_of_torus)->Arg(274)->Arg(1000)->Unit(benchmark::kMillisecond);

void count_bytes(benchmark::State& state, const Mesh& mesh, std::size_t bytes) {
    count_per_triangle(state, mesh);
    state.counters["bytes"] = static_cast<double>(bytes);
}

void read_obj_of_torus(benchmark::State& state) {
    const Mesh mesh = torus(static_cast<std::uint32_t>(state.range(0)));
    const std::string text = write_obj(mesh, "").obj;
    for (auto _ : state)
        benchmark::DoNotOptimize(read_obj(text, "").mesh.points.data());
    count_bytes(state, mesh, text.size());
}
BENCHMARK(read_obj_of_torus)->Arg(707)->Unit(benchmark::kMillisecond);

void read_ply_of_torus(benchmark::State& state) {
    const Mesh mesh = torus(static_cast<std::uint32_t>(state.range(0)));
    const std::string bytes = write_ply(mesh);
    for (auto _ : state)
        benchmark::DoNotOptimize(read_ply(bytes, "").mesh.points.data());
    count_bytes(state, mesh, bytes.size());
}
BENCHMARK(read_ply_of_torus)->Arg(707)->Unit(benchmark::kMillisecond);

void write_obj_of_torus(benchmark::State& state) {
    const Mesh mesh = torus(static_cast<std::uint32_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(write_obj(mesh, "").obj.data());
    count_per_triangle(state, mesh);
}
BENCHMARK(write_obj_of_torus)->Arg(707)->Unit(benchmark::kMillisecond);

void validate_torus(benchmark::State& state) {
    const Mesh mesh = torus(static_cast<std::uint32_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(validate(mesh));
    count_per_triangle(state, mesh);
}
BENCHMARK(validate_torus)->Arg(707)->Unit(benchmark::kMillisecond);

void mend_torus(benchmark::State& state) {
    const Mesh mesh = torus(static_cast<std::uint32_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(mend(mesh).points.data());
    count_per_triangle(state, mesh);
}
BENCHMARK(mend_torus)->Arg(707)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace edaha
