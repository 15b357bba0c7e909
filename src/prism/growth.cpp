// SPDX-License-Identifier: MIT
#include "prism/growth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stable_math.h"
#include "prism/fork.h"
#include "prism/interference.h"
#include "prism/purposes.h"

namespace edaha {
namespace {

// A triangle flatter than this part of its longest side squared is none.
constexpr double kFlattest = 1e-6;

// From z to x.
Vec2 rotated(Vec2 p, double angle_rad) {
    const auto [sin, cos] = stable::sin_cos(angle_rad);
    return {cos * p.x + sin * p.y, cos * p.y - sin * p.x};
}

// Radius with spread: each corner stays within its third of the circle.
Section round_section(const PrismParams& params, Key key, const KeyedRandom& random) {
    Section section = equilateral(params.radius_mm);
    std::uint32_t index = 0;
    for (Vec2& corner : section.corners) {
        const double turn =
            params.radius_spread * (random.uniform(key, prism::kCorner, index) - 0.5);
        const double wider =
            params.radius_spread * (random.uniform(key, prism::kCorner, index + 1) - 0.5);
        index += 2;
        corner = (1 + wider) * rotated(corner, turn * 2 * std::numbers::pi / 3);
    }
    return moved(section, -centroid(section));
}

Section first_section(const PrismParams& params, Key key, const KeyedRandom& random) {
    const double a = params.side_a_mm, b = params.side_b_mm, c = params.side_c_mm;
    if (a <= 0 && b <= 0 && c <= 0) return round_section(params, key, random);
    const double longest = std::max({a, b, c});
    const Section section = by_sides(a > 0 ? a : longest, b, c);
    if (a + b + c - 2 * longest <= 0 || area(section) < kFlattest * longest * longest)
        throw IoError("prism.side-a, side-b, side-c: no triangle has these sides");
    return section;
}

class PrismGrowth {
  public:
    PrismGrowth(const PrismParams& params, const KeyedRandom& random)
        : params_(params), random_(random) {}

    GrownPrisms run() {
        if (params_.straight + params_.two_way + params_.mixed <= 0)
            throw IoError("prism.straight, two-way, mixed: one of them must be above 0");
        plant();
        for (std::size_t i = 0; i < grown_.prisms.size(); ++i) {
            if (grown_.prisms[i].depth < params_.depth) branch(static_cast<std::int32_t>(i));
        }
        if (params_.pointed) sharpen();
        return std::move(grown_);
    }

  private:
    void plant() {
        Prism trunk;
        trunk.key = name_key("prism");
        const double heading = params_.heading_rad.at(random_.uniform(trunk.key, prism::kHeading));
        trunk.base = first_section(params_, trunk.key, random_);
        for (Vec2& corner : trunk.base.corners)
            corner = rotated(corner, heading);
        finish(trunk, 1);
        add(trunk, 1);
    }

    void branch(std::int32_t parent) {
        const Prism from = grown_.prisms[static_cast<std::size_t>(parent)];
        const double factor = factors_[static_cast<std::size_t>(parent)];
        for (const Shoot& shoot : shoots_of(from, params_, random_)) {
            const double own_factor = factor * shoot.length_factor;
            std::optional<Prism> prism = place(parent, from, shoot, own_factor);
            if (prism) {
                grown_.prisms[static_cast<std::size_t>(parent)].last = false;
                add(*prism, own_factor);
            } else {
                ++grown_.dropped;
            }
        }
    }

    // In the first direction in which nothing is in the way.
    std::optional<Prism> place(std::int32_t parent, const Prism& from, const Shoot& shoot,
                               double factor) {
        Prism prism;
        prism.key = step(from.key, shoot.child);
        prism.parent = parent;
        prism.depth = static_cast<std::uint16_t>(from.depth + 1);
        prism.child = shoot.child;
        prism.order = static_cast<std::uint16_t>(from.order + (shoot.child == 0 ? 0 : 1));
        prism.base = shoot.section;
        // ma = m + ga (the paper prints m + mb for the other, a misprint)
        prism.origin = from.tip() + from.frame[0] * shoot.centre.x + from.frame[2] * shoot.centre.y;
        const auto attempts = params_.interference ? params_.tries : 0;
        for (std::uint32_t attempt = 0; std::cmp_less_equal(attempt, attempts); ++attempt) {
            const Vec3 g = attempt == 0 ? shoot.direction
                                        : turned(shoot, prism.key, attempt, params_, random_);
            prism.frame =
                params_.frame == PrismFrame::paper ? paper_frame(g) : parallel_frame(from.frame, g);
            finish(prism, factor);
            if (params_.joint == PrismJoint::mitre) prism.corners = mitred_corners(prism, from);
            if (params_.joint == PrismJoint::weld) prism.corners = welded_corners(prism, from);
            if (is_free(prism)) {
                grown_.turned += attempt > 0 ? 1 : 0;
                return prism;
            }
        }
        return std::nullopt;
    }

    // What follows from depth, frame, origin and base.
    void finish(Prism& prism, double factor) const {
        const double u = random_.uniform(prism.key, prism::kLength);
        prism.length = factor * (1 + params_.length_spread * (2 * u - 1)) * params_.length_mm /
                       stable::pow(prism.depth, params_.length_power);
        prism.top = params_.taper;
        prism.corners = open_corners(prism);
    }

    bool is_free(const Prism& prism) const {
        if (!params_.interference) return true;
        const bool low = params_.ground_mm > 0 && prism.tip().y < params_.ground_mm;
        return !low && !standing_.in_the_way(prism.corners, prism.parent);
    }

    void add(Prism prism, double factor) {
        if (std::cmp_greater_equal(grown_.prisms.size(), params_.limit)) {
            throw IoError("prism.limit: the tree has more than " + std::to_string(params_.limit) +
                          " prisms; lower prism.depth or raise the limit");
        }
        if (params_.interference) standing_.add(prism.corners, prism.parent);
        grown_.prisms.push_back(prism);
        factors_.push_back(factor);
    }

    // Pyramids lie within the prisms that they replace: nothing gets in the way by that.
    void sharpen() {
        for (Prism& prism : grown_.prisms) {
            if (!prism.last) continue;
            prism.top = 0;
            std::fill(prism.corners.begin() + 3, prism.corners.end(), prism.tip());
        }
    }

    const PrismParams& params_;
    const KeyedRandom& random_;
    StandingPrisms standing_;
    std::vector<double> factors_;  // of each prism's length, by its side branches
    GrownPrisms grown_;
};

}  // namespace

GrownPrisms grow(const PrismParams& params, const KeyedRandom& random) {
    return PrismGrowth(params, random).run();
}

}  // namespace edaha
