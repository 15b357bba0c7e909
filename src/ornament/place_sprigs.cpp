// SPDX-License-Identifier: MIT
#include "ornament/place_sprigs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/stable_math.h"
#include "ornament/cloud.h"

namespace edaha {
namespace {

constexpr double kSprigLength = 10;  // of a symbol, as of leaves

// A sprig that points at the eye keeps this part of its length: less looks squashed.
constexpr double kLeastLength = 0.6;

// Turns a little off its direction, to either side: more tousles the crown, none combs it.
constexpr double kTurnRad = 0.35;

enum Purpose : std::uint32_t { kVariant = 300, kSprigSize, kMirror, kTurn, kSprigTone };

class SprigPlacer {
  public:
    SprigPlacer(std::span<const SprigPlace> places, const SprigSymbols& symbols,
                const SprigParams& params, const KeyedRandom& random)
        : places_(places), symbols_(symbols), params_(params), random_(random) {
        std::map<std::int32_t, Bounds> boxes;
        Bounds crown;
        for (const SprigPlace& place : places) {
            boxes[place.site.clump].include(place.site.position);
            crown.include(place.site.position);
        }
        for (const auto& [clump, box] : boxes)
            clouds_.emplace(clump, Cloud(box));
        if (!crown.empty()) crown_ = Cloud(crown);
    }

    // Clump by clump, the far ones first, and so the sprigs of each.
    void fill(Layer& layer, bool back, const std::function<std::string(std::int32_t)>& id) const {
        std::map<std::int32_t, std::vector<const SprigPlace*>> clumps;
        for (const SprigPlace& place : places_) {
            if (place.site.back == back) clumps[place.site.clump].push_back(&place);
        }
        std::vector<std::pair<double, std::int32_t>> order;
        for (auto& [clump, places] : clumps) {
            std::ranges::stable_sort(places, {}, &SprigPlace::depth);
            double sum = 0;
            for (const SprigPlace* place : places)
                sum += place->depth;
            order.emplace_back(sum / static_cast<double>(places.size()), clump);
        }
        std::ranges::stable_sort(order);
        for (const auto& [depth, clump] : order) {
            Group group{layer.id() + '.' + id(clump), {}, {}};
            for (const SprigPlace* place : clumps[clump])
                group.children.emplace_back(instance(*place));
            layer.children.emplace_back(std::move(group));
        }
    }

  private:
    double around(const Site& site, std::uint32_t purpose) const {
        return 2 * random_.uniform(site.key, purpose) - 1;
    }

    Use instance(const SprigPlace& place) const {
        const Site& site = place.site;
        double angle = stable::atan2(site.direction.x, -site.direction.y);
        angle += kTurnRad * around(site, kTurn);
        angle += params_.droop * ((angle < 0 ? -1 : 1) * std::numbers::pi - angle);
        const double across =
            place.size_mm / kSprigLength * (1 + params_.size_spread * around(site, kSprigSize));
        const double along = across * (kLeastLength + (1 - kLeastLength) * place.seen);
        const double mirrored = random_.uniform(site.key, kMirror) < 0.5 ? -across : across;
        const auto [s, c] = stable::sin_cos(angle);
        const Affine map(Vec2(c, s) * mirrored, Vec2(-s, c) * along, site.position);
        const double draw = random_.uniform(site.key, kVariant) * symbols_.variants;
        const auto variant = std::min(static_cast<std::uint32_t>(draw), symbols_.variants - 1);
        const Vec2 middle = transform(map, Vec2(0, -kSprigLength / 2));
        return {symbols_.index(tone_of(site, middle), variant), map, {}};
    }

    SprigTone tone_of(const Site& site, Vec2 middle) const {
        if (site.back) return SprigTone::back;
        const double light = 0.7 * clouds_.at(site.clump).light(middle) +
                             0.45 * crown_.light(middle) + 0.2 * around(site, kSprigTone);
        // Nearly a third each; a sprig has chance enough in itself.
        if (light > 0.3) return SprigTone::light;
        return light < -0.25 ? SprigTone::shade : SprigTone::mid;
    }

    std::span<const SprigPlace> places_;
    const SprigSymbols& symbols_;
    const SprigParams& params_;
    const KeyedRandom& random_;
    std::map<std::int32_t, Cloud> clouds_;
    Cloud crown_;
};

}  // namespace

SprigLayers place_sprigs(std::span<const SprigPlace> places, const SprigSymbols& symbols,
                         const SprigParams& params,
                         const std::function<std::string(std::int32_t)>& clump_id,
                         const KeyedRandom& random) {
    SprigLayers layers;
    const SprigPlacer placer(places, symbols, params, random);
    placer.fill(layers.behind, true, clump_id);
    placer.fill(layers.front, false, clump_id);
    layers.count = places.size();
    return layers;
}

}  // namespace edaha
