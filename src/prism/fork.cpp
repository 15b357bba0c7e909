// SPDX-License-Identifier: MIT
#include "prism/fork.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "prism/purposes.h"

namespace edaha {
namespace {

enum class Case { straight, two_way, mixed };

// A direction within `most_rad` of `d`, uniform on that cap for small angles.
Vec3 astray(Vec3 d, double most_rad, double u, double v) {
    if (most_rad <= 0) return d;
    const auto [sin, cos] = stable::sin_cos(most_rad * std::sqrt(u));
    const auto [sin_round, cos_round] = stable::sin_cos(2 * std::numbers::pi * v);
    const Mat3 frame = paper_frame(d);
    return cos * d + sin * (cos_round * frame[0] + sin_round * frame[2]);
}

class Forking {
  public:
    Forking(const Prism& prism, const PrismParams& params, const KeyedRandom& random)
        : prism_(prism), params_(params), random_(random) {}

    std::vector<Shoot> run() {
        const Case which = choose();
        if (which != Case::two_way) shoots_.push_back(straight_on());
        if (which != Case::straight) add_halves(which);
        for (Shoot& shoot : shoots_)
            shoot.direction = bent(shoot);
        return std::move(shoots_);
    }

  private:
    double draw(prism::Purpose purpose) const { return random_.uniform(prism_.key, purpose); }

    Case choose() const {
        if (prism_.depth <= params_.bole || prism_.order >= params_.halvings) return Case::straight;
        const double straight = params_.straight, two_way = params_.two_way;
        const double u = draw(prism::kCase) * (straight + two_way + params_.mixed);
        return u < straight ? Case::straight : u < straight + two_way ? Case::two_way : Case::mixed;
    }

    // 6.1. The section is the parent's top.
    Shoot straight_on() const {
        Shoot shoot;
        shoot.section = scaled(prism_.base, prism_.top);
        shoot.direction = prism_.direction();
        return shoot;
    }

    // 6.2; and 6.3, where one of the two may be left out.
    void add_halves(Case which) {
        const Section top = scaled(prism_.base, prism_.top);
        const double at = 0.5 + params_.cut_spread * (draw(prism::kCut) - 0.5);
        const Halves halves = halve(top, side_to_cut(top), at);
        const bool both = which == Case::two_way || draw(prism::kBoth) < params_.both;
        const bool first = draw(prism::kWhich) < 0.5;
        const double alpha = params_.alpha.at(draw(prism::kAlpha));
        const double beta = params_.beta.at(draw(prism::kBeta));
        if (both || first) add_half(1, halves.a, halves.centre_a, alpha);
        if (both || !first) add_half(2, halves.b, halves.centre_b, beta);
        if (which != Case::mixed) return;
        for (Shoot& shoot : shoots_) {
            if (shoot.child == 0) continue;
            shoot.section = scaled(shoot.section, params_.side_thickness);
            shoot.length_factor = params_.side_length;
        }
    }

    std::size_t side_to_cut(const Section& top) const {
        return params_.cut == PrismCut::longest ? longest_side(top) : prism_.depth % 3U;
    }

    // GA = alpha ga' + (1 - alpha) g, where ga' is square to g and as long. On the top, ga - g is
    // the half's centre: g leads to the centroid, the origin there.
    void add_half(std::uint8_t child, const Section& half, Vec2 centre, double alpha) {
        const Vec3 outward =
            glm::normalize(prism_.frame[0] * centre.x + prism_.frame[2] * centre.y);
        const Vec3 direction = alpha * outward + (1 - alpha) * prism_.direction();
        shoots_.push_back({child, half, centre, glm::normalize(direction), 1});
    }

    Vec3 bent(const Shoot& shoot) const {
        const Key key = step(prism_.key, shoot.child);
        const Vec3 d =
            astray(shoot.direction, params_.wander_rad, random_.uniform(key, prism::kWander, 0),
                   random_.uniform(key, prism::kWander, 1));
        const Vec3 lifted = d + Vec3(0, params_.lift, 0);
        const double length = glm::length(lifted);
        return length > 1e-9 ? lifted / length : d;
    }

    const Prism& prism_;
    const PrismParams& params_;
    const KeyedRandom& random_;
    std::vector<Shoot> shoots_;
};

}  // namespace

std::vector<Shoot> shoots_of(const Prism& prism, const PrismParams& params,
                             const KeyedRandom& random) {
    return Forking(prism, params, random).run();
}

Vec3 turned(const Shoot& shoot, Key key, std::uint32_t attempt, const PrismParams& params,
            const KeyedRandom& random) {
    return astray(shoot.direction, params.turn_rad, random.uniform(key, prism::kTurn, 2 * attempt),
                  random.uniform(key, prism::kTurn, 2 * attempt + 1));
}

}  // namespace edaha
