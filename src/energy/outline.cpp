// SPDX-License-Identifier: MIT
#include "energy/outline.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "geometry/measure.h"

namespace edaha {
namespace {

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

// A flank may be off by a thirtieth of the limb's half width: less than the eye sees on a fat limb,
// while a twig has its two nodes a flank. Never more than 0.05 mm.
double flank_tolerance_mm(double half_width) {
    return std::clamp(half_width / 30, 0.004, 0.05);
}

// Enough samples that the fit sees each S of a span: a flank may turn sharply on the inner side of
// a bend. A twig's four are hardly wider apart than it is thick.
int samples_of_span(double chord_mm, double half_width, bool flared) {
    if (flared) return 16;
    if (half_width > 0.4) return 12;
    return chord_mm < 1.5 ? 4 : 7;
}

void add_cubics(Path& path, const std::vector<Cubic>& cubics) {
    for (const Cubic& c : cubics)
        path.cubic_to(c.p1, c.p2, c.p3);
}

// Where a child's flank comes out of its parent: the fillet from the parent's flank to the child's.
struct Fillet {
    CurveSample parent;  // on the parent's flank; the tangent runs with the fillet
    CurveSample child;
    Vec2 corner;          // where the flanks cross
    LimbPlace place;      // of `child` on the child
    double along_mm = 0;  // of `parent`, from the joint along the parent
};

class Joint {
  public:
    Joint(const LimbCurve& child, const LimbCurve& parent, std::size_t parent_node,
          double radius_mm)
        : child_(child), parent_(parent), node_(parent_node), radius_mm_(radius_mm) {
        const double child_length = child.length_mm(0, child.spans());
        // A child that stays inside its parent for two thirds of its way has no joint to show.
        limit_ = child_length * 0.66;
        const double reach = parent.section_at_node(parent_node).half_width;
        stride_ = std::max(std::min(limit_ / 24, reach / 3), limit_ / 400);
        // The side on which the centre line comes out; it may weave within a thick parent.
        double across = 0;
        for (double s = stride_; s <= limit_; s += stride_) {
            const Vec2 point = flank_point(0, s);
            const LimbSection section = parent_section(point);
            across = cross(section.tangent, point - section.centre);
            if (std::abs(across) > section.half_width) break;
        }
        side_ = across >= 0 ? 1 : -1;
    }

    int side() const { return side_; }

    // `flank` is the child's side (+1, -1); `ahead` says whether the fillet lies on the parent's
    // far side of the joint (the crotch).
    std::optional<Fillet> fillet(int flank, bool ahead) const {
        // Where it comes out: steps along the child, then halving.
        double inside = 0, outside = -1;
        for (double s = stride_; s <= limit_; s += stride_) {
            if (!within_parent(flank, s)) {
                outside = s;
                break;
            }
            inside = s;
        }
        if (outside < 0) return std::nullopt;
        for (int i = 0; i < 12; ++i) {
            const double middle = (inside + outside) / 2;
            (within_parent(flank, middle) ? inside : outside) = middle;
        }
        Fillet result;
        result.corner = flank_point(flank, outside);
        const double reach = std::min(radius_mm_, (limit_ / 0.66 - outside) * 0.4);
        result.place = child_.walk(0, outside + reach);
        const LimbSection section = child_.section(result.place);
        result.child = section.sample(flank);
        const double along = parent_distance(result.corner) + (ahead ? reach : -reach);
        result.along_mm = along;
        const LimbSection base = parent_.section(parent_.walk(node_, along));
        // A hair inside the parent, by what its own flank may be off.
        const double inset = 1.5 * flank_tolerance_mm(base.half_width) / base.half_width;
        result.parent = base.sample(side_ * (1 - std::min(inset, 0.2)));
        if (ahead) result.parent.tangent = -result.parent.tangent;
        if (glm::length(result.parent.tangent) == 0 || glm::length(result.child.tangent) == 0) {
            return std::nullopt;
        }
        return result;
    }

  private:
    Vec2 flank_point(int flank, double s) const {
        return child_.section(child_.walk(0, s)).at(flank);
    }

    // Chord length along the parent, from the joint, of the section through a point.
    double parent_distance(Vec2 point) const {
        double s = 0;
        for (int step = 0; step < 2; ++step) {
            const LimbSection section = parent_.section(parent_.walk(node_, s));
            s += glm::dot(point - section.centre, section.tangent);
        }
        return s;
    }

    LimbSection parent_section(Vec2 point) const {
        return parent_.section(parent_.walk(node_, parent_distance(point)));
    }

    bool within_parent(int flank, double s) const {
        const Vec2 point = flank_point(flank, s);
        const LimbSection section = parent_section(point);
        return side_ * cross(section.tangent, point - section.centre) < section.half_width;
    }

    const LimbCurve& child_;
    const LimbCurve& parent_;
    std::size_t node_;
    double radius_mm_;
    double limit_ = 0;  // how far along the child a joint is looked for
    double stride_ = 0;
    int side_ = 1;
};

// Samples of one flank from a place to the tip.
std::vector<CurveSample> flank_samples(const LimbCurve& curve, double across, LimbPlace from,
                                       bool flared) {
    std::vector<CurveSample> samples;
    const auto add = [&](LimbPlace place) {
        const CurveSample sample = curve.section(place).sample(across);
        if (glm::length(sample.tangent) > 0) samples.push_back(sample);
    };
    add(from);
    for (std::size_t span = from.span; span < curve.spans(); ++span) {
        const double start = span == from.span ? from.t : 0;
        const double half_width = curve.section({span, 0}).half_width;
        const int count = samples_of_span(curve.chord_mm(span), half_width, flared && span <= 1);
        const double left = 1 - start;
        if (left < 0.02) continue;
        for (int i = 1; i <= count; ++i)
            add({span, start + left * i / count});
    }
    return samples;
}

std::vector<Cubic> fit_flank(const LimbCurve& curve, double across, LimbPlace from, bool flared) {
    const double half_width = curve.section(from).half_width;
    return fit_cubics(flank_samples(curve, across, from, flared), flank_tolerance_mm(half_width));
}

// Half a turn from one flank's end to the other's: arms of 4/3 make the cubic that is nearest to a
// half circle.
void add_tip(Path& path, const LimbSection& tip, Vec2 to) {
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

std::vector<Cubic> backwards(const std::vector<Cubic>& cubics) {
    std::vector<Cubic> result;
    for (auto it = cubics.rbegin(); it != cubics.rend(); ++it)
        result.push_back(reversed(*it));
    return result;
}

// Both flanks and the tip, from where each leaves the base; `first` is the flank (+1, -1) that is
// drawn towards the tip.
struct Flanks {
    std::vector<Cubic> up, down;
};

Flanks fit_flanks(const LimbCurve& curve, int first, LimbPlace up, LimbPlace down, bool flared) {
    return {fit_flank(curve, first, up, flared), backwards(fit_flank(curve, -first, down, flared))};
}

void add_flanks(Path& path, const LimbCurve& curve, const Flanks& flanks) {
    add_cubics(path, flanks.up);
    const LimbSection tip = curve.section_at_node(curve.spans());
    add_tip(path, tip, flanks.down.empty() ? tip.at(-1) : flanks.down.front().p0);
    add_cubics(path, flanks.down);
}

Path trunk_outline(const LimbCurve& curve) {
    const Flanks flanks = fit_flanks(curve, 1, {0, 0}, {0, 0}, true);
    Path path;
    if (flanks.up.empty() || flanks.down.empty()) return path;
    path.move_to(flanks.up.front().p0);
    add_flanks(path, curve, flanks);
    // The foot sinks a little into the ground, with a round lower edge.
    const LimbSection foot = curve.section({0, 0});
    const Vec2 left = path.points.back(), right = flanks.up.front().p0;
    const Vec2 down = -foot.tangent * (foot.half_width * 0.22);
    path.cubic_to(left + (right - left) * 0.18 + down, right + (left - right) * 0.18 + down, right);
    path.close();
    return path;
}

Path child_outline(const LimbCurve& curve, const LimbCurve& parent, std::size_t parent_node,
                   const LookParams& look) {
    const LimbSection base = curve.section({0, 0});
    const Joint joint(curve, parent, parent_node, look.fillet * 2 * base.half_width);
    const int lower = joint.side();
    const auto below = look.fillet > 0 ? joint.fillet(lower, false) : std::nullopt;
    const auto crotch = look.fillet > 0 ? joint.fillet(-lower, true) : std::nullopt;
    const LimbPlace up = below ? below->place : LimbPlace{};
    const LimbPlace down = crotch ? crotch->place : LimbPlace{};
    const Flanks flanks = fit_flanks(curve, lower, up, down, false);
    Path path;
    if (flanks.up.empty() || flanks.down.empty()) return path;
    // On the parent's centre line, between the fillets: a child may run within its parent at first.
    const double start = below && crotch ? (below->along_mm + crotch->along_mm) / 2 : 0;
    path.move_to(parent.section(parent.walk(parent_node, start)).centre);
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
    return signed_area(path) < 0 ? reversed(path) : path;
}

Path centre_line(const Limbs& limbs, const Limb& limb, const LookParams& look) {
    const LimbCurve curve = curve_of(limbs, limb, look);
    Path path;
    path.move_to(limbs.nodes_of(limb)[0].position);
    if (look.straight) {
        for (const LimbNode& node : limbs.nodes_of(limb).subspan(1))
            path.line_to(node.position);
        return path;
    }
    const double half_width = limbs.nodes_of(limb)[0].half_width;
    add_cubics(path,
               fit_cubics(flank_samples(curve, 0, {0, 0}, false), flank_tolerance_mm(half_width)));
    return path;
}

}  // namespace edaha
