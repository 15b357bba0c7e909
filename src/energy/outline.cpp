// SPDX-License-Identifier: MIT
#include "energy/outline.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "energy/flank.h"
#include "energy/joint.h"
#include "geometry/measure.h"

namespace edaha {
namespace {

// Room for two flanks, the tip, two fillets and two lines.
Path path_for(std::size_t flank_cubics) {
    Path path;
    path.verbs.reserve(flank_cubics + 8);
    path.points.reserve(3 * flank_cubics + 14);
    return path;
}

void add_cubics(Path& path, const std::vector<Cubic>& cubics) {
    for (const Cubic& c : cubics)
        path.cubic_to(c.p1, c.p2, c.p3);
}

// Half a turn from one flank's end to the other's: arms of 4/3 make the cubic that is nearest to a
// half circle.
void add_tip(Path& path, const LimbSlice& tip, Vec2 to) {
    const Vec2 arm = tip.tangent * (tip.half_width * 4 / 3);
    path.cubic_to(path.points.back() + arm, to + arm, to);
}

CurveSample reversed(CurveSample sample) {
    return {sample.position, -sample.tangent};
}

void add_fillet(Path& path, CurveSample from, CurveSample to, Vec2 corner) {
    // Arms of 0.6 of the way to the corner: rounder than a circle's 0.55, as grown wood is.
    const double a = 0.6 * glm::distance(from.position, corner);
    const double b = 0.6 * glm::distance(to.position, corner);
    path.cubic_to(from.position + glm::normalize(from.tangent) * a,
                  to.position - glm::normalize(to.tangent) * b, to.position);
}

std::vector<Cubic> backwards(std::vector<Cubic> cubics) {
    std::reverse(cubics.begin(), cubics.end());
    for (Cubic& cubic : cubics)
        cubic = reversed(cubic);
    return cubics;
}

// Both flanks and the tip, from where each leaves the base; `first` is the flank (+1, -1) that is
// drawn towards the tip.
struct Flanks {
    std::vector<Cubic> up, down;
};

Flanks fit_flanks(const LimbCurve& curve, int first, LimbPlace up, LimbPlace down) {
    return {fit_flank(curve, first, up), backwards(fit_flank(curve, -first, down))};
}

void add_flanks(Path& path, const LimbCurve& curve, const Flanks& flanks) {
    add_cubics(path, flanks.up);
    const LimbSlice tip = curve.slice_at_node(curve.spans());
    add_tip(path, tip, flanks.down.empty() ? tip.at(-1) : flanks.down.front().p0);
    add_cubics(path, flanks.down);
}

Path trunk_outline(const LimbCurve& curve) {
    const Flanks flanks = fit_flanks(curve, 1, {0, 0}, {0, 0});
    Path path;
    if (flanks.up.empty() || flanks.down.empty()) return path;
    path.move_to(flanks.up.front().p0);
    add_flanks(path, curve, flanks);
    // The foot sinks a little into the ground, with a round lower edge.
    const LimbSlice foot = curve.slice({0, 0});
    const Vec2 left = path.points.back(), right = flanks.up.front().p0;
    const Vec2 down = -foot.tangent * (foot.half_width * 0.22);
    path.cubic_to(left + (right - left) * 0.18 + down, right + (left - right) * 0.18 + down, right);
    path.close();
    return path;
}

Path child_outline(const LimbCurve& curve, const LimbCurve& parent, std::size_t parent_node,
                   const LookParams& look) {
    const LimbSlice base = curve.slice({0, 0});
    const Joint joint(curve, parent, parent_node, look.fillet * 2 * base.half_width);
    const int lower = joint.side();
    const auto below = look.fillet > 0 ? joint.fillet(lower, false) : std::nullopt;
    const auto crotch = look.fillet > 0 ? joint.fillet(-lower, true) : std::nullopt;
    const LimbPlace up = below ? below->place : LimbPlace{};
    const LimbPlace down = crotch ? crotch->place : LimbPlace{};
    const Flanks flanks = fit_flanks(curve, lower, up, down);
    Path path = path_for(flanks.up.size() + flanks.down.size());
    if (flanks.up.empty() || flanks.down.empty()) return path;
    // On the parent's centre line, between the fillets: a child may run within its parent at first.
    const double start = below && crotch ? (below->along_mm + crotch->along_mm) / 2 : 0;
    path.move_to(parent.slice(parent.walk(parent_node, start)).centre);
    if (below) {
        path.line_to(below->parent.position);
        add_fillet(path, below->parent, below->child, below->corner);
    } else {
        path.line_to(flanks.up.front().p0);
    }
    add_flanks(path, curve, flanks);
    if (crotch) {
        add_fillet(path, reversed(crotch->child), reversed(crotch->parent), crotch->corner);
    }
    path.close();
    return path;
}

Path straight_outline(std::span<const LimbNode> nodes) {
    Path path;
    const auto side = [&](std::size_t i, double across) {
        const Vec2 t = nodes[i].velocity;
        // At a bend of the chords the sides meet on the bisector: mitred, at most doubled.
        const Vec2 chord = i > 0 ? glm::normalize(nodes[i].position - nodes[i - 1].position) : t;
        const double mitre = 1 / std::max(glm::dot(chord, t), 0.5);
        return nodes[i].position + Vec2(-t.y, t.x) * (nodes[i].half_width * across * mitre);
    };
    path.move_to(side(0, 1));
    for (std::size_t i = 1; i < nodes.size(); ++i)
        path.line_to(side(i, 1));
    for (std::size_t i = nodes.size(); i-- > 0;)
        path.line_to(side(i, -1));
    path.close();
    return path;
}

}  // namespace

LimbCurve curve_of(const Limbs& limbs, const Limb& limb, const LookParams& look) {
    const auto nodes = limbs.nodes_of(limb);
    if (limb.parent >= 0 || look.straight) return LimbCurve(nodes);
    return LimbCurve(nodes, look.root_flare, look.root_height * 2 * nodes[0].half_width);
}

Path outline(const Limbs& limbs, const Limb& limb, const LookParams& look) {
    Path path;
    if (look.straight) {
        path = straight_outline(limbs.nodes_of(limb));
    } else if (limb.parent < 0) {
        path = trunk_outline(curve_of(limbs, limb, look));
    } else {
        const Limb& parent = limbs.limbs[static_cast<std::size_t>(limb.parent)];
        path = child_outline(curve_of(limbs, limb, look), LimbCurve(limbs.nodes_of(parent)),
                             limb.parent_node - parent.first_node, look);
    }
    if (signed_area(path) < 0) path = reversed(path);
    return path;
}

std::vector<Stroke> centre_strokes(const Limbs& limbs, const Limb& limb, const LookParams& look) {
    const auto nodes = limbs.nodes_of(limb);
    std::vector<Stroke> strokes;
    for (std::size_t first = 0; first + 1 < nodes.size();) {
        std::size_t last = first + 1;
        while (last + 1 < nodes.size() &&
               nodes[last + 1].half_width > 0.8 * nodes[first].half_width)
            ++last;
        Stroke stroke;
        stroke.width_mm = nodes[first].half_width + nodes[last].half_width;
        stroke.path.move_to(nodes[first].position);
        const auto part = nodes.subspan(first, last - first + 1);
        if (look.straight) {
            for (const LimbNode& node : part.subspan(1))
                stroke.path.line_to(node.position);
        } else {
            add_cubics(stroke.path, fit_flank(LimbCurve(part), 0, {0, 0}));
        }
        if (stroke.path.verbs.size() > 1) strokes.push_back(std::move(stroke));
        first = last;
    }
    return strokes;
}

}  // namespace edaha
