// SPDX-License-Identifier: MIT
#include "support/sample_drawing.h"

#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace edaha::test {
namespace {

constexpr Colour kBark{92, 68, 56}, kBarkLight{134, 104, 84}, kLeaf{96, 140, 62},
    kLeafLight{158, 184, 84}, kSand{222, 200, 160}, kSky{205, 226, 240};

Affine turned(double radians, double scale, Vec2 at) {
    const double c = scale * std::cos(radians), s = scale * std::sin(radians);
    return Affine(c, s, -s, c, at.x, at.y);
}

// Clockwise on the page for turn = 1: an outline; anticlockwise for -1: a hole.
void add_circle(Path& path, Vec2 centre, double radius, double turn) {
    const double arm = 0.5522847498 * radius;  // the usual cubic for a quarter circle
    const auto at = [&](double x, double y) { return centre + Vec2(x, turn * y); };
    path.move_to(at(radius, 0));
    path.cubic_to(at(radius, arm), at(arm, radius), at(0, radius));
    path.cubic_to(at(-arm, radius), at(-radius, arm), at(-radius, 0));
    path.cubic_to(at(-radius, -arm), at(-arm, -radius), at(0, -radius));
    path.cubic_to(at(arm, -radius), at(radius, -arm), at(radius, 0));
    path.close();
}

Paint filled(Ink ink, float opacity = 1) {
    Paint paint;
    paint.fill = ink;
    paint.fill_opacity = opacity;
    return paint;
}

Paint stroked(Ink ink, double width, float opacity = 1) {
    Paint paint;
    paint.stroke = ink;
    paint.stroke_width_mm = width;
    paint.stroke_opacity = opacity;
    return paint;
}

// Grows towards -y from the origin, 10 long: a blade in the instance's colour, a white vein.
Symbol leaf_symbol() {
    Path blade;
    blade.move_to({0, 0});
    blade.cubic_to({-4.2, -2.5}, {-3.6, -7}, {0, -10});
    blade.cubic_to({3.6, -7}, {4.2, -2.5}, {0, 0});
    blade.close();
    Path vein;
    vein.move_to({0, -0.5});
    vein.cubic_to({0.3, -3}, {-0.3, -6}, {0, -8.5});
    Paint white = stroked(Colour{255, 255, 255}, 0.5, 0.6f);
    white.fill = Ink::none();
    return {"leaf", {{"", blade, {}}, {"", vein, white}}};
}

Symbol berry_symbol() {
    Path ball, shine;
    add_circle(ball, {0, 0}, 2, 1);
    add_circle(shine, {-0.6, -0.6}, 0.6, 1);
    return {"berry",
            {{"ball", ball, filled(Colour{190, 50, 48})},
             {"shine", shine, filled(Colour{255, 255, 255}, 0.5f)}}};
}

Layer background_layer() {
    Layer layer{"Background", {}, {}};
    Path sky;
    sky.move_to({0, 0}), sky.line_to({120, 0}), sky.line_to({120, 100}), sky.line_to({0, 100});
    sky.close();
    layer.children.push_back(Shape{"sky", sky, filled(kSky)});
    Path sun;
    add_circle(sun, {95, 22}, 14, 1);
    add_circle(sun, {95, 22}, 9, -1);
    layer.children.push_back(Shape{"sun", sun, filled(Colour{245, 170, 60}, 0.7f)});
    Path hill;
    hill.move_to({0, 88});
    hill.cubic_to({30, 78}, {80, 80}, {120, 90});
    hill.line_to({120, 100}), hill.line_to({0, 100}), hill.close();
    layer.children.push_back(Shape{"hill", hill, filled(kSand)});
    return layer;
}

Path limb(Vec2 foot, Vec2 bend, Vec2 tip, double width) {
    Path path;
    const Vec2 along = glm::normalize(bend - foot);
    const Vec2 side(-along.y * width / 2, along.x * width / 2);
    path.move_to(foot - side);
    path.cubic_to(bend - side * 0.8, bend - side * 0.6, tip - side * 0.1);
    path.line_to(tip + side * 0.1);
    path.cubic_to(bend + side * 0.6, bend + side * 0.8, foot + side);
    path.close();
    return path;
}

Layer wood_layer() {
    Layer layer{"Wood & bark", filled(kBark), {}};
    layer.children.push_back(Shape{"trunk", limb({60, 90}, {57, 55}, {64, 25}, 7), {}});
    Group group{"limb-1", {}, {}};
    group.children.push_back(Shape{"limb-1.1", limb({59, 62}, {48, 50}, {30, 42}, 3.5), {}});
    group.children.push_back(
        Shape{"limb-1.2", limb({60, 56}, {72, 42}, {90, 40}, 3), filled(kBarkLight)});
    Path twig;
    twig.move_to({30, 42}), twig.cubic_to({26, 40}, {22, 40}, {18, 34});
    twig.move_to({90, 40}), twig.line_to({100, 38}), twig.line_to({104, 44});
    Paint pen = stroked(kBarkLight, 0.8, 0.8f);
    pen.fill = Ink::none();
    group.children.push_back(Shape{"", twig, pen});
    Path rope;
    rope.move_to({6, 70}), rope.cubic_to({20, 84}, {34, 84}, {50, 66});
    Paint dashed = stroked(kBark, 0.6);
    dashed.fill = Ink::none();
    dashed.dash_mm = 2;
    group.children.push_back(Shape{"rope", rope, dashed});
    layer.children.push_back(std::move(group));
    return layer;
}

Layer leaves_layer() {
    Layer layer{"Leaves", filled(kLeaf, 0.85f), {}};
    Group light{"light", filled(kLeafLight), {}};
    for (int i = 0; i < 24; ++i) {
        const double angle = 2.399963 * i;  // golden angle
        const Vec2 at = Vec2(62, 34) + (6 + 0.9 * i) * Vec2(std::cos(angle), 0.7 * std::sin(angle));
        const Use use{0, turned(angle + 1.5, 0.6 + 0.02 * i, at), {}};
        if (i % 3 == 0) {
            light.children.push_back(use);
        } else {
            layer.children.push_back(use);
        }
    }
    layer.children.push_back(std::move(light));
    layer.children.push_back(
        Use{0, Affine(-1.6, 0, 0.4, 0.7, 20, 34), filled(Colour{200, 90, 60})});
    layer.children.push_back(Use{0, Affine(1, 0, 0, 1, 104, 54), {}});
    layer.children.push_back(Use{1, Affine(1, 0, 0, 1, 44, 60), {}});
    layer.children.push_back(Use{1, Affine(0.7, 0, 0, 0.7, 80, 52), {}});
    return layer;
}

}  // namespace

Drawing sample_drawing() {
    Drawing drawing;
    drawing.width_mm = 120;
    drawing.height_mm = 100;
    drawing.symbols = {leaf_symbol(), berry_symbol()};
    drawing.layers = {background_layer(), wood_layer(), leaves_layer()};
    drawing.swatches = {{"Bark", kBark}, {"Bark, light", kBarkLight}, {"Leaf", kLeaf}};
    drawing.metadata = {"Sample <tree> & \"co\"",
                        "One of everything",
                        "edaha draw sample --set 'title=<枝>'",
                        "<style name=\"sample\">\n  <!-- a & b -->\n\t<leaf/>\n</style>\n",
                        "0.1.0",
                        "0123456789abcdef",
                        18446744073709551615u};
    return drawing;
}

Drawing field_drawing(std::size_t shapes, std::size_t uses) {
    Drawing drawing;
    drawing.width_mm = drawing.height_mm = 300;
    drawing.symbols = {leaf_symbol()};
    Layer wood{"Wood", filled(kBark), {}};
    Layer leaves{"Leaves", filled(kLeaf), {}};
    const auto place = [](std::size_t i, double step) {  // an even, aperiodic spread over the page
        const double x = std::fmod(static_cast<double>(i) * step, 1.0);
        return 20 + 260 * x;
    };
    for (std::size_t i = 0; i < shapes; ++i) {
        const Vec2 foot(place(i, 0.618033988749895), place(i, 0.754877666246693));
        const double angle = 0.37 * static_cast<double>(i);
        const Vec2 bend = foot + 3.1 * Vec2(std::cos(angle), std::sin(angle));
        const Vec2 tip = bend + 4.3 * Vec2(std::cos(angle + 0.3), std::sin(angle + 0.3));
        wood.children.push_back(Shape{"limb-" + std::to_string(i), limb(foot, bend, tip, 1), {}});
    }
    for (std::size_t i = 0; i < uses; ++i) {
        const Vec2 at(place(i, 0.569840290998053), place(i, 0.819172513396164));
        leaves.children.push_back(Use{0, turned(0.71 * static_cast<double>(i), 0.5, at), {}});
    }
    drawing.layers = {std::move(wood), std::move(leaves)};
    return drawing;
}

}  // namespace edaha::test
