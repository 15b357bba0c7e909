// SPDX-License-Identifier: MIT
#include "ornament/leaf.h"

#include <fmt/format.h>

#include "geometry/measure.h"
#include "ornament/report.h"
#include "ornament/rings.h"
#include "ornament/svg_document.h"
#include "ornament/svg_shapes.h"

namespace edaha {
namespace {

// In leaf units: above check()'s limit of 1e-6, and far below what can be seen.
constexpr double kShortest = 1e-5;

// A flatter leaf would be blown up a thousand times to be as long as the others.
constexpr double kFlattest = 1e-3;

std::string name_of(const std::string& file) {
    const std::string base = file.substr(file.find_last_of("/\\") + 1);
    return base.substr(0, base.rfind('.'));
}

Ink to_ink(const svg::SvgInk& ink) {
    switch (ink.kind) {
        case svg::SvgInk::Kind::none:
            return Ink::none();
        case svg::SvgInk::Kind::leaf:
            return {};
        case svg::SvgInk::Kind::colour:
            break;
    }
    return ink.colour;
}

Paint to_paint(const svg::SvgStyle& style, double scale) {
    const bool has_fill = style.fill.kind != svg::SvgInk::Kind::none;
    const bool has_stroke = style.stroke.kind != svg::SvgInk::Kind::none && style.stroke_width > 0;
    Paint paint;
    paint.fill_opacity =
        static_cast<float>(style.opacity * style.fill_opacity * style.fill.opacity);
    paint.stroke_opacity =
        static_cast<float>(style.opacity * style.stroke_opacity * style.stroke.opacity);
    paint.fill = to_ink(style.fill);
    paint.stroke = has_stroke ? to_ink(style.stroke) : Ink::none();
    if (style.takes_leaf_colour) {
        if (has_fill) paint.fill = {};
        if (!has_fill && has_stroke) paint.stroke = {};
    }
    paint.stroke_width_mm = has_stroke ? style.stroke_width * scale : 0;
    // What is quite transparent isn't drawn.
    if (paint.fill_opacity == 0) paint.fill = Ink::none();
    if (paint.stroke_opacity == 0) paint.stroke = Ink::none();
    if (paint.fill == Ink::none()) paint.fill_opacity = 1;
    if (paint.stroke == Ink::none()) paint.stroke_opacity = 1, paint.stroke_width_mm = 0;
    return paint;
}

Paint only_fill(Paint paint) {
    paint.stroke = Ink::none();
    paint.stroke_width_mm = 0;
    paint.stroke_opacity = 1;
    return paint;
}

Paint only_stroke(Paint paint) {
    paint.fill = Ink::none();
    paint.fill_opacity = 1;
    return paint;
}

// The outlines' box: what would be drawn at all.
Bounds outline_box(const std::vector<svg::SvgShape>& shapes) {
    Bounds box;
    for (const svg::SvgShape& shape : shapes) {
        const Paint paint = to_paint(shape.style, 1);
        if (paint.fill == Ink::none() && paint.stroke == Ink::none()) continue;
        if (shape.path.points.size() > 1) box.include(bounds(shape.path));
    }
    return box;
}

// Collects the leaf's shapes. One class, since what a drawn shape becomes depends on all three.
class LeafMaker {
  public:
    LeafMaker(const Affine& leaf_from_root, double scale, svg::Report& report)
        : leaf_from_root_(leaf_from_root), scale_(scale), report_(report) {}

    void add(const svg::SvgShape& drawn) {
        const Paint paint = to_paint(drawn.style, scale_);
        const Path path =
            without_short_segments(transformed(leaf_from_root_, drawn.path), kShortest);
        const bool has_fill = paint.fill != Ink::none();
        const bool has_stroke = paint.stroke != Ink::none();
        if (path.empty() && has_stroke) {
            report_.warn(drawn.spot, "a stroke without length is not kept");
        }
        const FillRings rings = has_fill ? fill_rings(path, drawn.style.even_odd) : FillRings{};
        if (!rings.is_exact) {
            const bool even_odd = drawn.style.even_odd;
            report_.warn(even_odd ? drawn.style.fill_rule_spot : drawn.spot,
                         even_odd ? "fill-rule: 'evenodd' is not kept where rings cross"
                                  : "the fill is not kept where a hole sticks out of its outline");
        }
        const bool is_one = !drawn.style.stroke_below && is_closed(path) &&
                            rings.path.verbs.size() == path.verbs.size();
        if (has_fill && has_stroke && is_one) return add(rings.path, paint);
        if (has_stroke && drawn.style.stroke_below) add(path, only_stroke(paint));
        if (has_fill) add(rings.path, only_fill(paint));
        if (has_stroke && !drawn.style.stroke_below) add(path, only_stroke(paint));
    }

    std::vector<Shape> shapes;
    Bounds box;

  private:
    void add(const Path& path, const Paint& paint) {
        if (path.empty()) return;
        shapes.push_back({"", path, paint});
        Bounds drawn = bounds(path);
        drawn.min -= paint.stroke_width_mm / 2;
        drawn.max += paint.stroke_width_mm / 2;
        box.include(drawn);
    }

    Affine leaf_from_root_;
    double scale_;
    svg::Report& report_;
};

svg::Spot root_spot(const svg::SvgDocument& document) {
    return {svg::offset_of(document.root()), {}, false, 0};
}

void refuse_degenerate(const Bounds& box, const svg::SvgDocument& document, svg::Report& report) {
    if (box.empty()) {
        report.error(root_spot(document), "nothing is drawn (expected a filled or stroked shape)");
    } else if (!(box.height() > box.width() * kFlattest)) {
        report.error(
            root_spot(document),
            fmt::format("the drawing is {:.6g} wide and {:.6g} tall (expected taller than a "
                        "thousandth of the width)",
                        box.width(), box.height()));
    }
    report.throw_if_failed();
}

}  // namespace

LeafImport read_leaf(std::string_view svg_text, const std::string& file) {
    const std::string text = svg::utf8_text(svg_text);
    svg::Report report(text, file);
    const svg::SvgDocument document(text, report);
    const svg::SvgPicture picture = svg::collect_shapes(document, report);
    report.throw_if_failed();
    const Bounds box = outline_box(picture.shapes);
    refuse_degenerate(box, document, report);
    const Vec2 stem = picture.stem.value_or(Vec2(box.centre().x, box.max.y));
    const double scale = kLeafLength / box.height();
    const double turn = stem.y < box.centre().y ? -scale : scale;
    LeafMaker maker(Affine(turn, 0, 0, turn, -turn * stem.x, -turn * stem.y), scale, report);
    for (const svg::SvgShape& shape : picture.shapes)
        maker.add(shape);
    if (maker.shapes.empty()) refuse_degenerate({}, document, report);
    return {{name_of(file), std::move(maker.shapes), maker.box}, report.warnings()};
}

}  // namespace edaha
