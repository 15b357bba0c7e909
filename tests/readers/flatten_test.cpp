// SPDX-License-Identifier: MIT
// Flat drawings from mesh to pixels: our SVG, drawn by librsvg, against a depth buffer.
#include "flatten/flatten.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "drawing/check.h"
#include "geometry/walk_path.h"
#include "support/id_buffer.h"
#include "support/meshes.h"
#include "support/run.h"
#include "write/svg.h"

namespace edaha {
namespace {

using namespace test;

constexpr int kSize = 800;  // pixels a side

FlattenParams params_of(FlatLook look) {
    FlattenParams params;
    params.look = look;
    params.resolution = kSize - 20;
    params.size_mm = 200;
    params.camera = {Projection::orthographic, 0.4, 0.3, 0.6};
    return params;
}

// A material a part, of a colour without red: its number as green and blue.
Mesh with_materials(Mesh mesh) {
    mesh.materials.clear();
    for (std::uint32_t i = 0; i < mesh.parts.size(); ++i) {
        mesh.materials.push_back({mesh.parts[i].name, std::nullopt});
        mesh.parts[i].material = i;
    }
    return mesh;
}

Colour colour_of(std::uint32_t part) {
    return {0, static_cast<std::uint8_t>(part / 16 * 16),
            static_cast<std::uint8_t>(part % 16 * 16)};
}

FlattenInks inks_of(const Mesh& mesh) {
    FlattenInks inks;
    for (std::uint32_t i = 0; i < mesh.materials.size(); ++i)
        inks.tones.push_back({colour_of(i)});
    return inks;
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

// The fills on a page whose pixels are those of the depth buffer.
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

struct Pixels {
    std::string rgb;

    Colour at(int x, int y) const {
        const auto i = static_cast<std::size_t>(3 * (y * kSize + x));
        const auto channel = [&](std::size_t k) { return static_cast<std::uint8_t>(rgb[i + k]); };
        return {channel(0), channel(1), channel(2)};
    }
};

// Over magenta, with or without antialiasing.
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
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return {read_whole(folder / "a.rgb")};
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

// Pixels with any red, away from the border.
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

struct Judgement {
    Disagreement labels;
    std::size_t red = 0;
};

Judgement judge(const Mesh& plain, const FlattenParams& params) {
    const Mesh mesh = with_materials(plain);
    const View view = project(mesh, params.camera, params.resolution);
    const Drawing drawing = on_square_page(flatten(mesh, params, inks_of(mesh)), view, params);
    EXPECT_EQ(check(drawing), std::vector<std::string>{});
    const IdBuffer drawn = ids_of(rendered(drawing, false), mesh.parts.size());
    return {compare(paint_depth(mesh, view, kSize), fine_truth(mesh, params), drawn),
            count_red(rendered(drawing, true))};
}

// A wall behind all that is seen, a little larger: what is red within it is magenta that leaks.
Mesh before_a_wall(const Mesh& mesh, const CameraParams& camera) {
    const View view = project(mesh, camera, 100);
    Mesh result;
    const Vec3 right = view.right * 12.0, up = view.up * 12.0;
    const Vec3 corner = Vec3(5) - view.to_eye * 20.0 - right - up;
    add(result, sheet(corner, right * 2.0, up * 2.0));
    add(result, mesh);
    return result;
}

Mesh smooth_scene() {
    Mesh mesh = torus(3, 1, 64, 32);
    add(mesh, sphere({1, 1.5, 0}, 2, 24));
    add(mesh, sphere({-1, 0.5, 1}, 2, 24));
    add(mesh, prism({-4, -3, -1}, {4, 4, 2}, 0.4, 24));
    return mesh;
}

// Facets keep their edges, so all that may differ is what is below the smallest area.
TEST(Flatten, FacetsAreWhatADepthBufferSees) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        FlattenParams params = params_of(FlatLook::fills_lines);
        params.smoothing_px = 0;
        const Disagreement d = judge(random_prisms(seed, 60), params).labels;
        EXPECT_LE(double(d.differ), 0.002 * double(d.covered)) << seed;
        EXPECT_EQ(d.very_far, 0U) << seed;
    }
}

TEST(Flatten, CurvesStayWithinTheirTolerance) {
    const FlattenParams params = params_of(FlatLook::fills_lines);
    const Disagreement d = judge(smooth_scene(), params).labels;
    EXPECT_LE(double(d.differ), 0.005 * double(d.covered));
    EXPECT_EQ(d.far, 0U);
}

// No seam of antialiasing shows the paper, between facets or between curves.
TEST(Flatten, NothingLeaks) {
    for (const double smoothing_px : {0.0, 0.5}) {
        FlattenParams params = params_of(FlatLook::fills);
        params.smoothing_px = smoothing_px;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Mesh mesh = before_a_wall(random_prisms(seed, 60), params.camera);
            EXPECT_EQ(judge(mesh, params).red, 0U) << seed << ", " << smoothing_px;
        }
    }
}

// Without traps it would: the oracle sees that.
TEST(Flatten, SeamsWouldBeNoticed) {
    FlattenParams params = params_of(FlatLook::fills);
    params.trap_mm = 0;
    const Mesh mesh = with_materials(before_a_wall(random_prisms(1, 60), params.camera));
    const View view = project(mesh, params.camera, params.resolution);
    Flattened flat = flatten(mesh, params, inks_of(mesh));
    EXPECT_GT(count_red(rendered(on_square_page(std::move(flat), view, params), true)), 1000U);
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

struct StrokeDistances {
    std::vector<double> of_strokes, of_edges;
};

// Both ways: of strokes from the depth buffer's edges, of these from strokes.
StrokeDistances stroke_distances(const Mesh& mesh, const std::string& left_out) {
    FlattenParams params = params_of(FlatLook::lines);
    params.smoothing_px = 0;
    params.min_line_mm = 0;
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

double percentile(const std::vector<double>& ascending, double share) {
    return ascending.at(static_cast<std::size_t>(share * double(ascending.size() - 1)));
}

// Edges of pixels are half of one off; what is smaller than two square pixels joins a neighbour.
TEST(Flatten, StrokesLieWhereADepthBufferHasEdgesAndNowhereElse) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const StrokeDistances d = stroke_distances(random_prisms(seed, 60), "");
        EXPECT_LT(percentile(d.of_strokes, 0.95), 0.75) << seed;
        EXPECT_LT(d.of_strokes.back(), 3) << seed;
        EXPECT_LT(percentile(d.of_edges, 0.95), 0.75) << seed;
        EXPECT_LT(d.of_edges.back(), 3) << seed;
    }
}

TEST(Flatten, MissingStrokesAreNoticed) {
    const StrokeDistances d = stroke_distances(random_prisms(1, 60), "Contours");
    EXPECT_EQ(d.of_edges.back(), 8);
}

// The oracle sees a fault: a picture without one of its parts.
TEST(Flatten, AMissingPartIsNoticed) {
    const Mesh mesh = with_materials(smooth_scene());
    const FlattenParams params = params_of(FlatLook::fills);
    const View view = project(mesh, params.camera, params.resolution);
    Mesh less = mesh;
    for (std::size_t i = 0; i < less.part_of.size(); ++i) {
        if (less.part_of[i] == 1) less.triangles[i] = {0, 0, 0};
    }
    const Disagreement d = compare(paint_depth(mesh, view, kSize), fine_truth(mesh, params),
                                   paint_depth(less, view, kSize));
    EXPECT_GT(d.far, 1000U);
}

}  // namespace
}  // namespace edaha
