// SPDX-License-Identifier: MIT
#include "surface/spatial_order.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/parallel.h"

namespace edaha {
namespace {

struct Place {
    std::uint64_t key;
    std::uint32_t old;
    bool operator<(const Place& other) const {
        return std::tie(key, old) < std::tie(other.key, other.old);
    }
};

// The bits of a number below 2^21, each followed by two zeros.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 32U) & 0x001f00000000ffffULL;
    bits = (bits | bits << 16U) & 0x001f0000ff0000ffULL;
    bits = (bits | bits << 8U) & 0x100f00f00f00f00fULL;
    bits = (bits | bits << 4U) & 0x10c30c30c30c30c3ULL;
    return (bits | bits << 2U) & 0x1249249249249249ULL;
}

std::uint64_t morton_key(const Vec3& p, double cell_mm) {
    constexpr double kMiddle = 1 << 20;
    const auto whole = [&](double c) {
        return static_cast<std::uint64_t>(std::clamp(c / cell_mm + kMiddle, 0.0, 2 * kMiddle - 1));
    };
    return spread(whole(p.x)) | spread(whole(p.y)) << 1U | spread(whole(p.z)) << 2U;
}

std::vector<std::uint32_t> numbers_of(const std::vector<Place>& order, std::size_t count) {
    std::vector<std::uint32_t> number(count, kNone);
    for (std::uint32_t i = 0; i < order.size(); ++i)
        number[order[i].old] = i;
    return number;
}

std::uint32_t at(const std::vector<std::uint32_t>& number, std::uint32_t old) {
    return old == kNone ? kNone : number[old];
}

template <typename Value>
void reorder(std::vector<Value>& values, const std::vector<Place>& order) {
    std::vector<Value> sorted;
    sorted.reserve(order.size());
    for (const Place& place : order)
        sorted.push_back(values[place.old]);
    values = std::move(sorted);
}

std::vector<Place> vertex_order(const GrowingMesh& mesh, double cell_mm) {
    std::vector<Place> order =
        gather<Place>(mesh.out.size(), [&](std::size_t i, std::vector<Place>& found) {
            const auto v = static_cast<std::uint32_t>(i);
            if (mesh.is_vertex(v)) found.push_back({morton_key(mesh.position[v], cell_mm), v});
        });
    sort_all(order, std::less<>());
    return order;
}

std::vector<Place> face_order(const GrowingMesh& mesh, const std::vector<std::uint32_t>& vertex) {
    std::vector<Place> order =
        gather<Place>(mesh.origin.size() / 3, [&](std::size_t i, std::vector<Place>& found) {
            const auto f = static_cast<std::uint32_t>(i);
            if (!mesh.is_face(f)) return;
            found.push_back({std::min({vertex[mesh.origin[3 * f]], vertex[mesh.origin[3 * f + 1]],
                                       vertex[mesh.origin[3 * f + 2]]}),
                             f});
        });
    sort_all(order, std::less<>());
    return order;
}

void reorder_vertices(GrowingMesh& mesh, const std::vector<Place>& order,
                      const std::vector<std::uint32_t>& number) {
    const auto reorder_all = [&](auto&... values) { (reorder(values, order), ...); };
    reorder_all(mesh.position, mesh.last, mesh.tissue, mesh.branch, mesh.thickening, mesh.travel,
                mesh.phloem_up, mesh.phloem_down, mesh.name, mesh.is_bud, mesh.vertex_rest,
                mesh.out);
    for (std::uint32_t v = 0; v < order.size(); ++v) {
        mesh.phloem_up[v] = at(number, mesh.phloem_up[v]);
        mesh.phloem_down[v] = at(number, mesh.phloem_down[v]);
    }
}

}  // namespace

Renumbering sort_in_space(GrowingMesh& mesh, double cell_mm) {
    const std::vector<Place> vertices = vertex_order(mesh, cell_mm);
    Renumbering numbers{numbers_of(vertices, mesh.out.size()), {}};
    const std::vector<Place> faces = face_order(mesh, numbers.vertex);
    numbers.face = numbers_of(faces, mesh.origin.size() / 3);
    reorder_vertices(mesh, vertices, numbers.vertex);
    const auto half_edge = [&](std::uint32_t h) { return 3 * numbers.face[h / 3] + h % 3; };
    for (std::uint32_t& h : mesh.out)
        h = half_edge(h);
    std::vector<std::uint32_t> origin, twin;
    for (const Place& place : faces) {
        for (std::uint32_t h = 3 * place.old; h < 3 * place.old + 3; ++h) {
            origin.push_back(numbers.vertex[mesh.origin[h]]);
            twin.push_back(half_edge(mesh.twin[h]));
        }
    }
    mesh.origin = std::move(origin);
    mesh.twin = std::move(twin);
    reorder(mesh.face_rest, faces);
    mesh.free_vertices.clear();
    mesh.free_faces.clear();
    return numbers;
}

}  // namespace edaha
