// SPDX-License-Identifier: MIT
#include "unit/flatten/painter_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "unit/geometry/shapes.h"

namespace edaha::scenes {
namespace {

constexpr double kSteps = 2048;

GridPoint on_grid(Vec2 p) {
    return {static_cast<std::int32_t>(std::lround(p.x * kSteps)),
            static_cast<std::int32_t>(std::lround(p.y * kSteps))};
}

bool is_inside(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if ((a.y < p.y) == (b.y < p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
    }
    return inside;
}

}  // namespace

FaceLabel seen_at(std::span<const Card> cards, Vec2 p) {
    for (std::size_t i = cards.size(); i-- > 0;) {
        if (is_inside(cards[i].corners, p)) return {cards[i].part, cards[i].tone};
    }
    return {};
}

LabelledMap map_of(std::span<const Card> cards) {
    std::vector<GridSegment> segments;
    for (const Card& card : cards) {
        for (std::size_t i = 0; i < card.corners.size(); ++i) {
            const GridSegment s{on_grid(card.corners[i]),
                                on_grid(card.corners[(i + 1) % card.corners.size()])};
            if (s.a != s.b) segments.push_back(s);
        }
    }
    Arrangement arrangement = snap_round(segments);
    LabelledMap result;
    result.steps_per_px = kSteps;
    result.map = build_planar_map(std::move(arrangement.nodes), std::move(arrangement.edges));
    result.labels.resize(result.map.faces());
    result.depth.resize(result.map.faces());
    for (std::uint32_t f = 1; f < result.map.faces(); ++f) {
        result.labels[f] = seen_at(cards, interior_point(result.map, f) / kSteps);
        if (result.labels[f].part != kNone)
            result.depth[f] = -static_cast<float>(result.labels[f].part);
    }
    for (std::uint32_t e = 0; e < result.map.edges.size(); ++e) {
        const FaceLabel a = result.labels[result.map.face_of(2 * e)];
        const FaceLabel b = result.labels[result.map.face_of(2 * e + 1)];
        LineKind kind = LineKind::contour;
        if (a == b)
            kind = LineKind::none;
        else if (a.part == kNone || b.part == kNone)
            kind = LineKind::silhouette;
        else if (a.part == b.part)
            kind = LineKind::tone;
        result.line.push_back(kind);
    }
    result.hidden.assign(result.map.edges.size(), LineKind::none);
    return result;
}

std::vector<MeshPart> parts_of(std::span<const Card> cards) {
    std::vector<MeshPart> parts;
    for (const Card& card : cards) {
        while (parts.size() <= card.part)
            parts.push_back({"part-" + std::to_string(parts.size()), 0, -1, 0, {}});
    }
    return parts;
}

std::vector<Vec2> rectangle(Vec2 min, Vec2 max) {
    return {min, {max.x, min.y}, max, {min.x, max.y}};
}

std::vector<Vec2> ellipse(Vec2 centre, Vec2 radii, int corners) {
    std::vector<Vec2> result;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        result.push_back(centre + radii * Vec2(std::cos(angle), std::sin(angle)));
    }
    return result;
}

std::vector<Vec2> bar(Vec2 from, Vec2 to, double width) {
    const Vec2 along = glm::normalize(to - from) * (width / 2);
    const Vec2 across(-along.y, along.x);
    return {from + across, from - across, to - across, to + across};
}

std::vector<Card> random_scene(int count, double side, std::uint64_t seed) {
    shapes::Random random{seed};
    const auto place = [&] {
        const double x = random() * side;
        return Vec2(x, random() * side);
    };
    std::vector<Card> cards;
    for (int i = 0; i < count; ++i) {
        const auto part = static_cast<std::uint32_t>(i);
        const double kind = random();
        if (kind < 0.5) {
            const Vec2 from = place();
            const Vec2 to = from + (place() - Vec2(side / 2)) * 0.8;
            const double width = 2 + random() * side / 12;
            cards.push_back({bar(from, to, width), part, 1});
            cards.push_back(
                {bar(from * 0.9 + to * 0.1, to * 0.9 + from * 0.1, width / 3), part, 0});
        } else if (kind < 0.8) {
            const Vec2 centre = place();
            const double across = 2 + random() * side / 8;
            const Vec2 radii(across, 2 + random() * side / 8);
            cards.push_back({ellipse(centre, radii, 48), part, 1});
            cards.push_back({ellipse(centre + radii * 0.2, radii * 0.6, 40), part, 2});
        } else {
            const Vec2 a = place(), b = place();
            cards.push_back({{a, b, (a + b) * 0.5 + (place() - Vec2(side / 2)) * 0.4}, part, 1});
        }
    }
    return cards;
}

}  // namespace edaha::scenes
