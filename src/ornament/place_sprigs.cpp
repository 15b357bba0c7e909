// SPDX-License-Identifier: MIT
#include "ornament/place_sprigs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "ornament/sprig_clumps.h"

namespace edaha {
namespace {

using glm::dvec3;

constexpr double kSprigLength = 10;  // of a symbol, as of leaves

// A sprig that points at the eye keeps this part of its length: less looks squashed.
constexpr double kLeastLength = 0.6;

// Turns a little off its direction, to either side: more tousles the crown, none combs it.
constexpr double kTurnRad = 0.35;

// Sprigs at a clump's rim are smaller by this part: none leaves ragged edges, more bald ones.
constexpr double kRimLoss = 0.4;
constexpr double kLeastAtRim = 0.45;  // of its size: less are specks

// What is farther back than this part of the crown's depth fades: a smaller one makes flat patches
// amid the crown, a larger one leaves no depth.
constexpr double kFar = 0.28;

constexpr std::array<const char*, kSprigTones> kToneNames{"far-shade", "far", "shade", "mid",
                                                          "light"};

enum Purpose : std::uint32_t { kVariant = 300, kSprigSize, kMirror, kTurn, kSprigTone };

struct Sprig {
    Affine page_from_symbol;
    std::uint32_t variant = 0;
    SprigTone tone = SprigTone::mid;
    bool behind = false;
    double depth = 0;
};

using SprigsOfClumps = std::vector<std::vector<const Sprig*>>;

Paint filled(Colour colour) {
    Paint paint;
    paint.fill = colour;
    return paint;
}

class SprigPlacer {
  public:
    SprigPlacer(std::span<const SprigPlace> places, const SprigSymbols& symbols,
                const SprigParams& params, const SprigInks& inks, const dvec3& to_light,
                const KeyedRandom& random)
        : places_(places),
          symbols_(symbols),
          params_(params),
          inks_(inks),
          to_light_(glm::normalize(to_light)),
          random_(random) {
        if (places.empty()) return;
        find_masses();
        for (std::size_t i = 0; i < places.size(); ++i)
            sprigs_.push_back(sprig(i));
    }

    SprigLayers run() const {
        SprigLayers layers;
        const std::vector<std::uint32_t> order = far_and_high_first();
        const SprigsOfClumps behind = by_clump(true), front = by_clump(false);
        add_stems(layers.behind, {".far-stems", inks_.far_stem, true}, behind, order);
        add_stems(layers.behind, {".back-stems", inks_.stem, false}, behind, order);
        add_leaves(layers.behind, behind, order);
        add_stems(layers.behind, {".stems", inks_.stem, false}, front, order);
        add_leaves(layers.front, front, order);
        layers.count = sprigs_.size();
        return layers;
    }

  private:
    double around(Key key, std::uint32_t purpose) const {
        return 2 * random_.uniform(key, purpose) - 1;
    }

    void find_masses() {
        std::vector<dvec3> middles;
        double size = 0;
        for (const SprigPlace& place : places_) {
            middles.push_back(place.foot + place.direction * (place.size_mm / 2));
            size += place.size_mm / static_cast<double>(places_.size());
        }
        clumps_ = find_clumps(middles, params_.clump * size);
        crown_ = find_clumps(middles, 1e9);
        for (const dvec3& middle : middles)
            reach_ = std::max(reach_, std::abs(middle.z - crown_.middles[0].z));
    }

    // Where a point lies in a mass: of length 1 at its rim and beyond.
    static dvec3 place_in(const Clumps& clumps, std::uint32_t c, const dvec3& point) {
        const dvec3 off = (point - clumps.middles[c]) / std::max(clumps.radii[c], 1e-6);
        return off / std::max(glm::length(off), 1.0);
    }

    // The side of a mass that is seen there, whatever lies within.
    static dvec3 dome(const dvec3& place) {
        const double height = 1 - place.x * place.x - place.y * place.y;
        return {place.x, place.y, std::sqrt(std::max(height, 0.0))};
    }

    Sprig sprig(std::size_t i) const {
        const SprigPlace& place = places_[i];
        const std::uint32_t clump = clumps_.of_point[i];
        const dvec3 outwards = place_in(clumps_, clump, place.foot);
        const dvec3 turned = place.direction + outwards * params_.rounding;
        const dvec3 direction = turned / std::max(glm::length(turned), 1e-6);
        const dvec3 middle = place.foot + direction * (place.size_mm / 2);
        Sprig sprig;
        const double off = glm::distance(place.foot, clumps_.middles[clump]) /
                           std::max(clumps_.radii[clump], 1e-6);
        sprig.page_from_symbol =
            map_of(place, direction, std::max(kLeastAtRim, 1 - kRimLoss * off * off));
        const double draw = random_.uniform(place.key, kVariant) * symbols_.variants;
        sprig.variant = std::min(static_cast<std::uint32_t>(draw), symbols_.variants - 1);
        const double depth = (middle.z - crown_.middles[0].z) / reach_;
        // Mostly by the side that it leaves its branch on, and a little by the branch's own.
        sprig.behind = 0.6 * place.direction.z + 0.4 * depth < 0;
        sprig.tone = tone_of(place, clump, middle, depth, sprig.behind);
        sprig.depth = middle.z;
        return sprig;
    }

    Affine map_of(const SprigPlace& place, const dvec3& direction, double part) const {
        double angle = stable::atan2(direction.x, -direction.y);
        angle += kTurnRad * around(place.key, kTurn);
        angle += params_.droop * ((angle < 0 ? -1 : 1) * std::numbers::pi - angle);
        const double across = place.size_mm * part / kSprigLength *
                              (1 + params_.size_spread * around(place.key, kSprigSize));
        const double seen = std::sqrt(std::max(0.0, 1 - direction.z * direction.z));
        const double along = across * (kLeastLength + (1 - kLeastLength) * seen);
        const double mirrored = random_.uniform(place.key, kMirror) < 0.5 ? -across : across;
        const auto [s, c] = stable::sin_cos(angle);
        return {Vec2(c, s) * mirrored, Vec2(-s, c) * along, Vec2(place.foot.x, place.foot.y)};
    }

    SprigTone tone_of(const SprigPlace& place, std::uint32_t clump, const dvec3& middle,
                      double depth, bool behind) const {
        double light = 0.75 * glm::dot(dome(place_in(clumps_, clump, middle)), to_light_) +
                       0.35 * glm::dot(dome(place_in(crown_, 0, middle)), to_light_) +
                       0.1 * around(place.key, kSprigTone);
        if (behind && depth < -kFar) return light < 0.3 ? SprigTone::far_shade : SprigTone::far;
        if (behind) light -= 0.4;  // in the shade of the boughs
        if (light > 0.55) return SprigTone::light;
        return light < 0.22 ? SprigTone::shade : SprigTone::mid;
    }

    // The lit top of each lies over the shade of the one above it, as clouds do.
    std::vector<std::uint32_t> far_and_high_first() const {
        std::vector<std::uint32_t> order(clumps_.middles.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::stable_sort(order, {}, [&](std::uint32_t c) {
            return clumps_.middles[c].z + 0.5 * clumps_.middles[c].y;
        });
        return order;
    }

    // The far ones of a clump first.
    SprigsOfClumps by_clump(bool behind) const {
        SprigsOfClumps clumps(clumps_.middles.size());
        for (std::size_t i = 0; i < sprigs_.size(); ++i) {
            if (sprigs_[i].behind == behind) clumps[clumps_.of_point[i]].push_back(&sprigs_[i]);
        }
        for (std::vector<const Sprig*>& clump : clumps)
            std::ranges::stable_sort(clump, {}, &Sprig::depth);
        return clumps;
    }

    struct Stems {
        const char* id;
        Colour colour;
        bool far;
    };

    void add_stems(Layer& layer, const Stems& stems, const SprigsOfClumps& clumps,
                   const std::vector<std::uint32_t>& order) const {
        Group group{layer.id() + stems.id, filled(stems.colour), {}};
        for (const std::uint32_t c : order) {
            for (const Sprig* sprig : clumps[c]) {
                if ((sprig->tone <= SprigTone::far) == stems.far)
                    group.children.emplace_back(use(*sprig, SprigPart::stem));
            }
        }
        if (!group.children.empty()) layer.children.emplace_back(std::move(group));
    }

    void add_leaves(Layer& layer, const SprigsOfClumps& clumps,
                    const std::vector<std::uint32_t>& order) const {
        for (const std::uint32_t c : order) {
            if (!clumps[c].empty()) layer.children.emplace_back(leaves(layer.id(), c, clumps[c]));
        }
    }

    Group leaves(const std::string& layer, std::uint32_t clump,
                 const std::vector<const Sprig*>& sprigs) const {
        Group group{layer + ".clump-" + std::to_string(clump + 1), {}, {}};
        for (std::uint32_t tone = 0; tone < kSprigTones; ++tone) {
            const SprigInks::Leaves& inks = inks_.leaves[tone];
            Group toned{group.id + '.' + kToneNames[tone], paint_of(inks.outer), {}};
            for (const Sprig* sprig : sprigs) {
                if (sprig->tone != SprigTone{tone}) continue;
                toned.children.emplace_back(use(*sprig, SprigPart::inner, paint_of(inks.inner)));
                toned.children.emplace_back(use(*sprig, SprigPart::outer));
            }
            if (!toned.children.empty()) group.children.emplace_back(std::move(toned));
        }
        return group;
    }

    Paint paint_of(Colour colour) const {
        Paint paint = filled(colour);
        if (inks_.stroked) paint.stroke = colour;
        return paint;
    }

    Use use(const Sprig& sprig, SprigPart part, const Paint& paint = {}) const {
        return {symbols_.index(part, sprig.variant), sprig.page_from_symbol, paint};
    }

    std::span<const SprigPlace> places_;
    const SprigSymbols& symbols_;
    const SprigParams& params_;
    const SprigInks& inks_;
    dvec3 to_light_;
    const KeyedRandom& random_;
    Clumps clumps_, crown_;
    double reach_ = 1e-9;  // of the crown towards the eye
    std::vector<Sprig> sprigs_;
};

}  // namespace

SprigLayers place_sprigs(std::span<const SprigPlace> places, const SprigSymbols& symbols,
                         const SprigParams& params, const SprigInks& inks, const dvec3& to_light,
                         const KeyedRandom& random) {
    return SprigPlacer(places, symbols, params, inks, to_light, random).run();
}

}  // namespace edaha
