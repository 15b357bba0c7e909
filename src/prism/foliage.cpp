// SPDX-License-Identifier: MIT
#include "prism/foliage.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "prism/purposes.h"

namespace edaha {
namespace {

constexpr double kPi = std::numbers::pi;

// A ball hangs over its branch's tip by so much of its height: the joint is never seen.
constexpr double kBallBelow = 0.4;
// A tier is hollow from below by so much of its height; every other corner of its rim is drawn in
// and up by so much of its radius, as boughs end. More makes stars, none makes lampshades.
constexpr double kTierHollow = 0.2, kTierNotch = 0.14;
// The last tier is higher than others by so much, and so comes to a point.
constexpr double kCrown = 1.6;
// A spray is widest so far along its branch; a leaf's outline.
constexpr double kSprayWidest = 0.4;
// The cone at the end of a trunk with sprays begins so many lengths of the last prism before it.
constexpr double kLeader = 2;

// Corners round an ellipse of two half axes, square to the body's axis.
struct Ring {
    Vec3 centre{0}, across{0}, upward{0};
    bool between = false;  // each corner half a step on
    bool notched = false;
};

// A closed body of rings between two points.
struct Body {
    Vec3 first{0}, last{0};
    std::vector<Ring> rings;
    double spin = 0;  // of all rings, in steps
};

class Masses {
  public:
    Masses(const std::vector<Prism>& prisms, const FoliageParams& params, const KeyedRandom& random)
        : prisms_(prisms), params_(params), random_(random) {}

    std::vector<FoliageMass> run() {
        for (std::uint32_t i = 0; i < prisms_.size(); ++i) {
            if (std::cmp_less(prisms_[i].depth, params_.from)) continue;
            if (const std::optional<Body> body = body_at(prisms_[i])) add(i, *body);
        }
        return std::move(masses_);
    }

  private:
    std::optional<Body> body_at(const Prism& prism) const {
        const bool trunk = prism.order == 0;
        switch (params_.shape) {
            case FoliageShape::none:
                break;
            case FoliageShape::balls:
                if (prism.last) return ball(prism);
                break;
            case FoliageShape::tiers:
                if (trunk) return tier(prism);
                break;
            case FoliageShape::sprays:
                if (prism.last) return trunk ? leader(prism) : spray(prism);
        }
        return std::nullopt;
    }

    double draw(const Prism& prism, std::uint32_t index) const {
        return random_.uniform(prism.key, prism::kFoliage, index);
    }

    double radius(const Prism& prism) const {
        return params_.size_mm * (1 + params_.size_spread * (2 * draw(prism, 0) - 1));
    }

    Body ball(const Prism& prism) const {
        const double r = radius(prism);
        const Vec3 axis = (1 - params_.upright) * prism.direction() + Vec3(0, params_.upright, 0);
        const Mat3 frame = paper_frame(glm::length(axis) > 1e-6 ? axis : Vec3(0, 1, 0));
        const Vec3 half = frame[1] * (r * params_.stretch);
        const Vec3 centre = prism.tip() + (1 - 2 * kBallBelow) * half;
        Body body{centre - half, centre + half, {}, draw(prism, 1)};
        for (int i = 1; i <= params_.rings; ++i) {
            const auto [sin, cos] =
                stable::sin_cos(kPi * i / static_cast<double>(params_.rings + 1));
            body.rings.push_back({centre - cos * half, frame[0] * (r * sin), -frame[2] * (r * sin),
                                  i % 2 == 0, false});
        }
        return body;
    }

    Body tier(const Prism& prism) const {
        const double crown = prism.last ? kCrown : 1;
        return cone(prism, prism.origin, params_.stretch * prism.length * crown);
    }

    Body leader(const Prism& last) const {
        const double height = (1 + kLeader) * last.length * params_.stretch;
        return cone(last, last.tip() - kLeader * last.length * last.direction(), height);
    }

    // As wide as its prism is long: narrower up the trunk.
    Body cone(const Prism& prism, Vec3 from, double height) const {
        const double r = radius(prism) * prism.length / prisms_[0].length;
        const Mat3& frame = prism.frame;
        return {from + kTierHollow * height * frame[1],
                from + height * frame[1],
                {{from, frame[0] * r, -frame[2] * r, false, true}},
                draw(prism, 1)};
    }

    // Along the limb that ends here, from where that left another; as it bends.
    Body spray(const Prism& last) const {
        std::vector<const Prism*> limb{&last};
        while (limb.back()->child == 0)
            limb.push_back(&prisms_[static_cast<std::size_t>(limb.back()->parent)]);
        const Vec3 from = limb.back()->origin, to = last.tip();
        const Vec3 along = to - from;
        const double reach = glm::length(along) / prisms_[0].length;
        const double width = radius(last) * std::sqrt(reach);
        const Vec3 level = glm::cross(Vec3(0, 1, 0), along);
        const Vec3 side = glm::length(level) > 1e-9 ? glm::normalize(level) : last.frame[0];
        const Vec3 up = glm::normalize(glm::cross(along, side));
        const auto middle =
            static_cast<std::size_t>((1 - kSprayWidest) * static_cast<double>(limb.size()));
        const Ring ring{limb[middle]->tip(), side * width, up * (width * params_.flatness)};
        return {from, to + (params_.stretch - 1) * along, {ring}, 0};
    }

    void add(std::uint32_t bearer, const Body& body) {
        FoliageMass mass;
        mass.bearer = bearer;
        mass.points = points_of(body, prisms_[bearer]);
        const auto sides = static_cast<std::uint32_t>(params_.sides);
        const auto end = static_cast<std::uint32_t>(mass.points.size() - 1);
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t j = (i + 1) % sides;
            mass.triangles.push_back({0, 1 + j, 1 + i});
            for (std::uint32_t r = 0; r + 1 < body.rings.size(); ++r) {
                const std::uint32_t low = 1 + r * sides, high = low + sides;
                // Between corners of one ring lies one of the next.
                const bool ahead = body.rings[r + 1].between;
                const Triangle a{low + i, low + j, high + (ahead ? i : j)};
                const Triangle b{low + (ahead ? j : i), high + j, high + i};
                mass.triangles.insert(mass.triangles.end(), {a, b});
            }
            mass.triangles.push_back({end - sides + i, end - sides + j, end});
        }
        masses_.push_back(std::move(mass));
    }

    std::vector<Vec3> points_of(const Body& body, const Prism& bearer) const {
        const Vec3 along = glm::normalize(body.last - body.first);
        const auto sides = static_cast<std::uint32_t>(params_.sides);
        std::uint32_t index = 2;
        const auto off = [&] { return params_.roughness * (2 * draw(bearer, index++) - 1); };
        std::vector<Vec3> points{body.first};
        for (const Ring& ring : body.rings) {
            for (std::uint32_t i = 0; i < sides; ++i) {
                const double turn = i + body.spin + (ring.between ? 0.5 : 0);
                const auto [sin, cos] = stable::sin_cos(2 * kPi * turn / sides);
                const double in = ring.notched && i % 2 == 1 ? kTierNotch : 0;
                const Vec3 out = (1 - in + off()) * (cos * ring.across + sin * ring.upward);
                const double rise = (in + off()) * glm::length(ring.upward);
                points.push_back(ring.centre + out + rise * along);
            }
        }
        points.push_back(body.last);
        return points;
    }

    const std::vector<Prism>& prisms_;
    const FoliageParams& params_;
    const KeyedRandom& random_;
    std::vector<FoliageMass> masses_;
};

}  // namespace

std::vector<FoliageMass> foliage_of(const std::vector<Prism>& prisms, const FoliageParams& params,
                                    const KeyedRandom& random) {
    return Masses(prisms, params, random).run();
}

}  // namespace edaha
