// SPDX-License-Identifier: MIT
#include "ornament/svg_geometry.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "ornament/arc.h"
#include "ornament/path_data.h"
#include "ornament/scan.h"
#include "ornament/svg_document.h"
#include "ornament/svg_values.h"

namespace edaha::svg {
namespace {

Path lone_point(Vec2 p) {
    Path path;
    path.move_to(p);
    return path;
}

Path ellipse_path(Vec2 centre, Vec2 radii) {
    if (radii.x == 0 || radii.y == 0) return lone_point(centre);
    const Vec2 east = centre + Vec2(radii.x, 0), west = centre - Vec2(radii.x, 0);
    Path path;
    path.move_to(east);
    add_arc(path, {east, west, radii, 0, false, true});
    add_arc(path, {west, east, radii, 0, false, true});
    path.close();
    return path;
}

Path rect_path(Vec2 low, Vec2 size, Vec2 radii) {
    if (size.x == 0 || size.y == 0) return lone_point(low + size * 0.5);
    const Vec2 high = low + size, r(std::min(radii.x, size.x / 2), std::min(radii.y, size.y / 2));
    const bool is_round = r.x > 0 && r.y > 0;
    // The corners clockwise from the top left: where the edge before it ends and the next begins.
    const Vec2 ends[4] = {
        {low.x, low.y + r.y}, {high.x - r.x, low.y}, {high.x, high.y - r.y}, {low.x + r.x, high.y}};
    const Vec2 begins[4] = {
        {low.x + r.x, low.y}, {high.x, low.y + r.y}, {high.x - r.x, high.y}, {low.x, high.y - r.y}};
    const Vec2 corners[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
    Path path;
    path.move_to(is_round ? begins[0] : low);
    for (int i = 1; i <= 4; ++i) {
        const int corner = i % 4;
        if (is_round) {
            const Vec2 from = ends[corner];
            if (from != path.points.back()) path.line_to(from);
            add_arc(path, {from, begins[corner], r, 0, false, true});
        } else if (corner != 0) {
            path.line_to(corners[corner]);
        }
    }
    path.close();
    return path;
}

Path read_rect(pugi::xml_node node, const LengthReader& lengths) {
    const Vec2 low(lengths.read(node, "x", Axis::x), lengths.read(node, "y", Axis::y));
    const Vec2 size(lengths.read_size(node, "width", Axis::x),
                    lengths.read_size(node, "height", Axis::y));
    const double rx = lengths.read_size(node, "rx", Axis::x, -1);
    const double ry = lengths.read_size(node, "ry", Axis::y, -1);
    // One radius stands for both.
    const Vec2 radii(rx < 0 ? std::max(ry, 0.0) : rx, ry < 0 ? std::max(rx, 0.0) : ry);
    return rect_path(low, size, radii);
}

Path read_ellipse(pugi::xml_node node, const LengthReader& lengths, bool is_circle) {
    const Vec2 centre(lengths.read(node, "cx", Axis::x), lengths.read(node, "cy", Axis::y));
    const double rx = is_circle ? lengths.read_size(node, "r", Axis::other)
                                : lengths.read_size(node, "rx", Axis::x);
    return ellipse_path(centre, {rx, is_circle ? rx : lengths.read_size(node, "ry", Axis::y)});
}

Path read_line(pugi::xml_node node, const LengthReader& lengths) {
    Path path = lone_point({lengths.read(node, "x1", Axis::x), lengths.read(node, "y1", Axis::y)});
    path.line_to({lengths.read(node, "x2", Axis::x), lengths.read(node, "y2", Axis::y)});
    return path;
}

Path polygon_path(const std::vector<Vec2>& points, bool is_closed) {
    Path path;
    for (const Vec2 p : points)
        path.empty() ? path.move_to(p) : path.line_to(p);
    if (is_closed && !path.empty()) path.close();
    return path;
}

// Reads an attribute's text by `read`; a fault becomes an error at its place.
template <typename Read>
Path read_text(pugi::xml_node node, const char* attribute, Report& report, Read&& read) {
    try {
        return read(node.attribute(attribute).value());
    } catch (const SyntaxError& fault) {
        report.error(value_spot(offset_of(node), attribute, fault.offset()),
                     fmt::format("{} {}: {}", node.name(), attribute, fault.what()));
        return {};
    }
}

}  // namespace

double LengthReader::read(pugi::xml_node node, const char* attribute, Axis axis,
                          double otherwise) const {
    const pugi::xml_attribute found = node.attribute(attribute);
    if (!found || trimmed(found.value()) == "auto") return otherwise;
    SvgLength length;
    try {
        length = read_length(found.value());
    } catch (const SyntaxError& fault) {
        report_.error(value_spot(offset_of(node), attribute, fault.offset()),
                      fmt::format("{} {}: {}", node.name(), attribute, fault.what()));
        return otherwise;
    }
    if (!length.percent) return length.value;
    report_.warn(value_spot(offset_of(node), attribute),
                 fmt::format("{} {}: {} is taken of the view box (leaves have no page)",
                             node.name(), attribute, quoted(found.value())));
    const Vec2 s = viewport_.size;
    const double whole = axis == Axis::x   ? s.x
                         : axis == Axis::y ? s.y
                                           : std::sqrt((s.x * s.x + s.y * s.y) / 2);
    return length.value / 100 * whole;
}

double LengthReader::read_size(pugi::xml_node node, const char* attribute, Axis axis,
                               double otherwise) const {
    const double size = read(node, attribute, axis, otherwise);
    if (size >= 0 || size == otherwise) return size;
    report_.error(value_spot(offset_of(node), attribute),
                  fmt::format("{} {}: {} is negative (expected 0 or more)", node.name(), attribute,
                              quoted(node.attribute(attribute).value())));
    return otherwise;
}

Path read_geometry(pugi::xml_node node, std::string_view element, const LengthReader& lengths) {
    if (element == "path") return read_text(node, "d", lengths.report(), read_path_data);
    if (element == "rect") return read_rect(node, lengths);
    if (element == "circle") return read_ellipse(node, lengths, true);
    if (element == "ellipse") return read_ellipse(node, lengths, false);
    if (element == "line") return read_line(node, lengths);
    return read_text(node, "points", lengths.report(), [&](std::string_view text) {
        return polygon_path(read_points(text), element == "polygon");
    });
}

}  // namespace edaha::svg
