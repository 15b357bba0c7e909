// SPDX-License-Identifier: MIT
#include "support/flat_judge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <variant>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "drawing/check.h"
#include "geometry/walk_path.h"
#include "support/meshes.h"
#include "support/run.h"
#include "write/svg.h"

namespace edaha::test {
namespace {

Colour colour_of(std::uint32_t part) {
    return {0, static_cast<std::uint8_t>(part / 16 * 16),
            static_cast<std::uint8_t>(part % 16 * 16)};
}

void move(std::vector<Element>& elements, Vec2 by) {
    for (Element& element : elements) {
        if (auto* group = std::get_if<Group>(&element)) move(group->children, by);
        if (auto* shape = std::get_if<Shape>(&element)) {
            for (Vec2& point : shape->path.points)
                point += by;
        }
    }
}

IdBuffer ids_of(const Pixels& pixels, std::size_t parts) {
    IdBuffer ids{kSize, std::vector<std::uint32_t>(static_cast<std::size_t>(kSize * kSize), kNone)};
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            for (std::uint32_t part = 0; part < parts; ++part) {
                if (pixels.at(x, y) == colour_of(part))
                    ids.part[static_cast<std::size_t>(y * kSize + x)] = part;
            }
        }
    }
    return ids;
}

// Where another part is seen than to the right or below: the middle between both pixels.
std::vector<Vec2> part_edges(const IdBuffer& ids) {
    std::vector<Vec2> edges;
    for (int y = 0; y < ids.size; ++y) {
        for (int x = 0; x < ids.size; ++x) {
            if (ids.at(x, y) != ids.at(x + 1, y)) edges.emplace_back(x + 1, y + 0.5);
            if (ids.at(x, y) != ids.at(x, y + 1)) edges.emplace_back(x + 0.5, y + 1);
        }
    }
    return edges;
}

// Points along all strokes that part what is seen, a third of a pixel apart: no creases.
void append_points(const std::vector<Element>& elements, double px_per_mm,
                   std::vector<Vec2>& points) {
    for (const Element& element : elements) {
        if (const auto* group = std::get_if<Group>(&element)) {
            if (group->id != "Creases") append_points(group->children, px_per_mm, points);
            continue;
        }
        walk_path(std::get<Shape>(element).path, [&](const PathSegment& segment) {
            if (segment.verb == Verb::move) return;
            const double length = glm::distance(segment.curve.p0, segment.curve.p3) * px_per_mm;
            const int steps = 1 + static_cast<int>(3 * length);
            for (int i = 0; i <= steps; ++i)
                points.push_back(eval(segment.curve, double(i) / steps) * px_per_mm);
        });
    }
}

// Distances from each point to the nearest of the others, ascending; by cells of a pixel, up to 8.
std::vector<double> distances(const std::vector<Vec2>& points, const std::vector<Vec2>& others) {
    constexpr int kReach = 8;
    std::map<std::pair<int, int>, std::vector<Vec2>> cells;
    const auto cell = [](Vec2 p) { return std::pair(int(std::floor(p.x)), int(std::floor(p.y))); };
    for (const Vec2 p : others)
        cells[cell(p)].push_back(p);
    std::vector<double> result;
    for (const Vec2 p : points) {
        double least = kReach;
        const auto [x, y] = cell(p);
        for (int ring = 0; ring <= kReach && least > ring - 1; ++ring) {
            for (int i = -ring; i <= ring; ++i) {
                for (int j = -ring; j <= ring; ++j) {
                    if (std::max(std::abs(i), std::abs(j)) != ring) continue;
                    const auto found = cells.find({x + i, y + j});
                    if (found == cells.end()) continue;
                    for (const Vec2 q : found->second)
                        least = std::min(least, glm::distance(p, q));
                }
            }
        }
        result.push_back(least);
    }
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace

Mesh with_materials(Mesh mesh) {
    mesh.materials.clear();
    for (std::uint32_t i = 0; i < mesh.parts.size(); ++i) {
        mesh.materials.push_back({mesh.parts[i].name, std::nullopt});
        mesh.parts[i].material = i;
    }
    return mesh;
}

FlattenInks inks_of(const Mesh& mesh) {
    FlattenInks inks;
    for (std::uint32_t i = 0; i < mesh.materials.size(); ++i)
        inks.tones.push_back({colour_of(i)});
    return inks;
}

Drawing on_square_page(Flattened flat, const View& view, const FlattenParams& params) {
    const double mm_per_px = params.size_mm / params.resolution;
    Drawing drawing;
    drawing.width_mm = drawing.height_mm = kSize * mm_per_px;
    drawing.layers = std::move(flat.layers);
    std::erase_if(drawing.layers, [](const Layer& layer) { return layer.label != "Fills"; });
    const Vec2 middle(drawing.width_mm / 2, drawing.height_mm / 2);
    for (Layer& layer : drawing.layers)
        move(layer.children, middle + view.origin * (mm_per_px / kStepsPerPx));
    return drawing;
}

Pixels rendered(const Drawing& drawing, bool antialiased) {
    const TemporaryFolder folder;
    std::string svg;
    write_svg(drawing, {}, [&](std::string_view piece) { svg += piece; });
    if (!antialiased) svg.insert(svg.find("<svg ") + 5, "shape-rendering=\"crispEdges\" ");
    write_whole(folder / "a.svg", svg);
    const RunResult result =
        run("cd " + quoted(folder.path()) + " && rsvg-convert -b '#ff00ff' -w " +
            std::to_string(kSize) + " -h " + std::to_string(kSize) +
            " a.svg -o a.png && convert a.png -depth 8 rgb:a.rgb");
    if (result.exit_code != 0) throw std::runtime_error(result.err);
    return {read_whole(folder / "a.rgb")};
}

std::size_t count_red(const Pixels& pixels) {
    std::size_t count = 0;
    for (int y = 14; y < kSize - 14; ++y) {
        for (int x = 14; x < kSize - 14; ++x)
            count += pixels.at(x, y).r > 0 ? 1 : 0;
    }
    return count;
}

IdBuffer fine_truth(const Mesh& mesh, const FlattenParams& params) {
    return paint_depth(mesh, project(mesh, params.camera, kFine * params.resolution),
                       kFine * kSize);
}

Judgement judge(const Mesh& plain, const FlattenParams& params) {
    const Mesh mesh = with_materials(plain);
    const View view = project(mesh, params.camera, params.resolution);
    const Drawing drawing = on_square_page(flatten(mesh, params, inks_of(mesh)), view, params);
    const IdBuffer drawn = ids_of(rendered(drawing, false), mesh.parts.size());
    return {check(drawing),
            compare(paint_depth(mesh, view, kSize), fine_truth(mesh, params), drawn),
            count_red(rendered(drawing, true))};
}

StrokeDistances stroke_distances(const Mesh& mesh, const FlattenParams& params,
                                 const std::string& left_out) {
    const View view = project(mesh, params.camera, params.resolution);
    const double mm_per_px = params.size_mm / params.resolution;
    Flattened flat = flatten(mesh, params, inks_of(mesh));
    std::vector<Vec2> strokes;
    const Vec2 middle = Vec2(kSize / 2.0) + view.origin / double(kStepsPerPx);
    for (Layer& layer : flat.layers) {
        std::erase_if(layer.children, [&](const Element& element) {
            const auto* group = std::get_if<Group>(&element);
            return group != nullptr && group->id == left_out;
        });
        append_points(layer.children, 1 / mm_per_px, strokes);
    }
    for (Vec2& point : strokes)
        point += middle;
    const std::vector<Vec2> edges = part_edges(paint_depth(mesh, view, kSize));
    return {distances(strokes, edges), distances(edges, strokes)};
}

Mesh before_a_wall(const Mesh& mesh, const CameraParams& camera) {
    const View view = project(mesh, camera, 100);
    Vec3 low = mesh.points.front(), high = low;
    for (const Vec3& point : mesh.points)
        low = glm::min(low, point), high = glm::max(high, point);
    const double half = 0.55 * glm::length(high - low);
    const Vec3 right = view.right * half, up = view.up * half;
    const Vec3 corner = (low + high) / 2.0 - view.to_eye * half - right - up;
    Mesh result;
    add(result, sheet(corner, right * 2.0, up * 2.0));
    add(result, mesh);
    return result;
}

}  // namespace edaha::test
