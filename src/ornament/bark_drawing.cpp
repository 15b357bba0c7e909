// SPDX-License-Identifier: MIT
#include "ornament/bark_drawing.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/syntax_error.h"
#include "geometry/walk_path.h"
#include "ornament/report.h"
#include "ornament/svg_document.h"
#include "ornament/svg_shapes.h"
#include "ornament/svg_values.h"

namespace edaha {
namespace {

constexpr double kTolerance = 0.02;  // of polylines, in parts of a hundredth of the tile: unseen
constexpr double kStep = 1.0 / 40;   // of the tile: closer, and lines cost more but bend no better
constexpr int kAcross = 24;          // places at which the width of a narrow shape is taken
constexpr double kMiddleGrey = 0.5;
constexpr double kCornerCos = 0.6;  // 53 degrees: tips of narrow shapes turn far more
constexpr std::size_t kMostEnds = 32;

svg::Spot spot_of_root(const svg::SvgDocument& document) {
    return {svg::offset_of(document.root()), {}, false, 0};
}

svg::ViewBox box_of_tile(const svg::SvgDocument& document, svg::Report& report) {
    const pugi::xml_node root = document.root();
    const char* attribute = "viewBox";
    try {
        if (const pugi::xml_attribute box = root.attribute(attribute))
            return svg::read_view_box(box.value());
        svg::ViewBox box;
        for (const int axis : {0, 1}) {
            attribute = axis == 0 ? "width" : "height";
            const svg::SvgLength length =
                svg::read_length(root.attribute(attribute).as_string("0"));
            if (length.percent || !(length.value > 0))
                report.fail(spot_of_root(document),
                            "a bark tile needs a size (expected viewBox=\"0 0 WIDTH HEIGHT\")");
            box.size[axis] = length.value;
        }
        return box;
    } catch (const SyntaxError& fault) {
        report.fail(svg::value_spot(svg::offset_of(root), attribute, fault.offset()),
                    std::string("svg ") + attribute + ": " + fault.what());
    }
}

bool is_light(const svg::SvgInk& ink) {
    if (ink.kind != svg::SvgInk::Kind::colour) return false;
    const Colour& c = ink.colour;
    return (0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b) / 255 > kMiddleGrey;
}

using Line = std::vector<Vec2>;

double length_of_line(const Line& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        sum += glm::distance(line[i - 1], line[i]);
    return sum;
}

// `count` + 1 places evenly along a line.
Line evened(const Line& line, int count) {
    const double total = length_of_line(line);
    Line result{line.front()};
    double passed = 0;
    std::size_t i = 1;
    for (int k = 1; k < count; ++k) {
        const double wanted = total * k / count;
        while (i + 1 < line.size() && passed + glm::distance(line[i - 1], line[i]) < wanted) {
            passed += glm::distance(line[i - 1], line[i]);
            ++i;
        }
        const double way = glm::distance(line[i - 1], line[i]);
        const double t = way > 0 ? std::min(1.0, (wanted - passed) / way) : 0;
        result.push_back(line[i - 1] + (line[i] - line[i - 1]) * t);
    }
    result.push_back(line.back());
    return result;
}

std::vector<Line> subpaths_of(const Path& path, double tolerance) {
    std::vector<Line> lines;
    walk_path(path, [&](const PathSegment& segment) {
        if (segment.verb == Verb::move) {
            lines.push_back({segment.curve.p0});
            return;
        }
        for (const Vec2 p : flatten(segment.curve, tolerance)) {
            if (p != lines.back().back()) lines.back().push_back(p);
        }
    });
    std::erase_if(lines, [](const Line& line) { return !(length_of_line(line) > 0); });
    return lines;
}

// From one place of a ring to another, forwards.
Line way_between(const Line& ring, std::size_t from, std::size_t to) {
    Line way{ring[from]};
    for (std::size_t i = from; i != to;) {
        i = (i + 1) % ring.size();
        way.push_back(ring[i]);
    }
    return way;
}

// Both ways from one of its ends to the other.
struct RingSides {
    Line left, right;

    double mean_square_width() const {
        double sum = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            const Vec2 across = left[i] - right[i];
            sum += glm::dot(across, across);
        }
        return sum;
    }
};

RingSides sides_between(const Line& ring, std::size_t from, std::size_t to) {
    RingSides sides{way_between(ring, from, to), way_between(ring, to, from)};
    std::reverse(sides.right.begin(), sides.right.end());
    sides.left = evened(sides.left, kAcross);
    sides.right = evened(sides.right, kAcross);
    return sides;
}

// Where a ring may end: its corners, or if it has not two, any place.
std::vector<std::size_t> possible_ends(const Line& ring) {
    std::vector<std::size_t> corners, all;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 before = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
        const Vec2 after = ring[(i + 1) % ring.size()] - ring[i];
        const double cosine = glm::dot(before, after) / (glm::length(before) * glm::length(after));
        if (cosine < kCornerCos) corners.push_back(i);
        if (i % (ring.size() / kMostEnds + 1) == 0) all.push_back(i);
    }
    return corners.size() >= 2 && corners.size() <= kMostEnds ? corners : all;
}

// The middle between the two ways from one end of a ring to the other: of all pairs of ends those
// between which it is narrowest.
BarkLine middle_line(Line ring) {
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    BarkLine line;
    if (ring.size() < 3) return line;
    const std::vector<std::size_t> ends = possible_ends(ring);
    RingSides best;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t k = i + 1; k < ends.size(); ++k) {
            RingSides sides = sides_between(ring, ends[i], ends[k]);
            if (best.left.empty() || sides.mean_square_width() < best.mean_square_width())
                best = std::move(sides);
        }
    }
    for (std::size_t i = 0; i < best.left.size(); ++i) {
        line.points.push_back((best.left[i] + best.right[i]) * 0.5);
        line.widths_mm.push_back(glm::distance(best.left[i], best.right[i]));
    }
    return line;
}

class BarkReader {
  public:
    explicit BarkReader(const svg::ViewBox& box) : box_(box) {
        tile.width_mm = box.size.x;
        tile.height_mm = box.size.y;
    }

    void add(const svg::SvgShape& shape) {
        using Kind = svg::SvgInk::Kind;
        const double small = std::min(box_.size.x, box_.size.y);
        const bool filled = shape.style.fill.kind != Kind::none;
        const bool stroked = shape.style.stroke.kind != Kind::none && shape.style.stroke_width > 0;
        if (!filled && !stroked) return;
        for (const Line& sub : subpaths_of(shape.path, kTolerance * small / 100)) {
            BarkLine line;
            if (filled) {
                line = middle_line(sub);
                line.light = is_light(shape.style.fill);
            } else {
                const double steps = std::ceil(length_of_line(sub) / (kStep * small));
                line.points = evened(sub, static_cast<int>(std::clamp(steps, 4.0, 1000.0)));
                line.widths_mm.assign(line.points.size(), shape.style.stroke_width);
                line.light = is_light(shape.style.stroke);
            }
            if (line.points.size() < 2) continue;
            for (Vec2& p : line.points)
                p = {p.x - box_.origin.x, box_.origin.y + box_.size.y - p.y};
            tile.lines.push_back(std::move(line));
        }
    }

    BarkTile tile;

  private:
    svg::ViewBox box_;
};

}  // namespace

BarkImport read_bark(std::string_view svg_text, const std::string& file) {
    const std::string text = svg::utf8_text(svg_text);
    svg::Report report(text, file);
    const svg::SvgDocument document(text, report);
    const svg::SvgPicture picture = svg::collect_shapes(document, report);
    report.throw_if_failed();
    BarkReader reader(box_of_tile(document, report));
    for (const svg::SvgShape& shape : picture.shapes)
        reader.add(shape);
    if (reader.tile.empty()) {
        report.fail(spot_of_root(document),
                    "nothing is drawn (expected strokes or narrow filled shapes)");
    }
    return {std::move(reader.tile), report.warnings()};
}

}  // namespace edaha
