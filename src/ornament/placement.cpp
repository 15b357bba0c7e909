// SPDX-License-Identifier: MIT
#include "ornament/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "base/stable_math.h"
#include "ornament/cloud.h"

namespace edaha {
namespace {

constexpr double kSymbolLength = 10;

enum Purpose : std::uint32_t {
    kBears = 200,
    kCount,
    kFan,
    kSize,
    kTone,
    kBehind,
    kScatterRadius,
    kScatterAngle,
    kSide,
    kStagger,
    kPurposes = 32
};

enum Tone : std::size_t { kShade, kMid, kLight, kTones };

constexpr std::array<const char*, kTones> kToneNames{"shade", "mid", "light"};

// The ornaments of a clump, tone by tone.
using Tonal = std::array<std::vector<Element>, kTones>;

struct Placed {
    Affine page_from_symbol;
    std::int32_t clump;
    Tone tone;
};

class Placer {
  public:
    Placer(std::span<const Site> sites, const PlacementParams& params, const KeyedRandom& random)
        : params_(params), ornament_(params.ornament), random_(random) {
        std::vector<Bounds> boxes;
        Bounds crown;
        for (const Site& site : sites) {
            const auto clump = static_cast<std::size_t>(site.clump);
            if (clump >= boxes.size()) boxes.resize(clump + 1);
            boxes[clump].include(site.position);
            crown.include(site.position);
        }
        for (const Bounds& box : boxes)
            clumps_.emplace_back(box);
        crown_ = Cloud(crown);
        reserve(sites.size());
        for (const Site& site : sites) {
            if (uniform(site.key, kBears) < ornament_.share) dress(site);
        }
    }

    Placement result() {
        Placement placement;
        const Tones& tones = params_.tones;
        placement.front = layer(front_, params_.label, {tones.shade, tones.mid, tones.light});
        // Behind, the three tones draw near to one.
        placement.behind = layer(
            behind_, params_.label + " behind",
            {mixed(tones.back, tones.shade, 0.4), tones.back, mixed(tones.back, tones.light, 0.4)});
        placement.all = std::move(all_);
        return placement;
    }

  private:
    // What is likely, and a little more: a list that grows is copied again and again.
    void reserve(std::size_t sites) {
        const double part = std::min(ornament_.share, 1.0) * 1.1;
        const double likely = static_cast<double>(sites) * part * (ornament_.count + 0.5);
        const auto room = static_cast<std::size_t>(std::min(likely, 1e6));
        all_.reserve(room);
        front_.reserve(room);
    }

    double uniform(Key key, std::uint32_t purpose, std::uint32_t index = 0) const {
        return random_.uniform(key, purpose + params_.salt * kPurposes, index);
    }
    double around(Key key, std::uint32_t purpose, std::uint32_t index) const {
        return 2 * uniform(key, purpose, index) - 1;
    }

    void dress(const Site& site) {
        const double twig = stable::atan2(site.direction.x, -site.direction.y);
        if (!site.terminal) {
            const double side = uniform(site.key, kSide) < 0.5 ? -1 : 1;
            const double angle =
                side * ornament_.along_angle_rad * (1 + 0.35 * around(site.key, kFan, 0));
            add(site, 0, twig + angle, site.position);
            return;
        }
        // A mean of 2.4 is two or three.
        const double count = ornament_.count + uniform(site.key, kCount);
        const auto n = static_cast<std::uint32_t>(count);
        for (std::uint32_t i = 0; i < n; ++i) {
            const double spread = n > 1 ? 2.0 * i / (n - 1) - 1 : 0;
            const double jitter = n > 1 ? 0.7 / (n - 1) : 0.4;
            const double fan = (spread + jitter * around(site.key, kFan, i)) * ornament_.fan_rad;
            // The outer ones of a fan stand further down the twig.
            const double back =
                std::abs(spread) * 0.12 * ornament_.size_mm * uniform(site.key, kStagger, i);
            add(site, i, twig + fan, site.position - site.direction * back);
        }
    }

    void add(const Site& site, std::uint32_t i, double angle, Vec2 position) {
        if (ornament_.scatter_mm > 0) {
            const double radius =
                std::sqrt(uniform(site.key, kScatterRadius, i)) * ornament_.scatter_mm;
            const auto [s, c] =
                stable::sin_cos(2 * std::numbers::pi * uniform(site.key, kScatterAngle, i));
            position += Vec2(s, c) * radius;
        }
        angle = turned(turned(angle, std::numbers::pi, ornament_.droop), 0, ornament_.upright);
        const double size =
            ornament_.size_mm * (1 + ornament_.size_spread * around(site.key, kSize, i));
        const double scale = size / kSymbolLength;
        const auto [s, c] = stable::sin_cos(angle);
        const Affine map(Vec2(c, s) * scale, Vec2(-s, c) * scale, position);
        const bool behind = site.back || uniform(site.key, kBehind, i) < ornament_.behind;
        const Vec2 middle = transform(map, Vec2(0, -kSymbolLength / 2));
        const Tone tone = tone_of(site, middle, i);
        (behind ? behind_ : front_).push_back({map, site.clump, tone});
        all_.push_back(map);
    }

    // Turns a heading by `part` of the way to another one, the shorter way round.
    static double turned(double angle, double to, double part) {
        if (part == 0) return angle;
        const double full = 2 * std::numbers::pi;
        const auto turns = static_cast<double>(stable::floor((to - angle) / full + 0.5));
        const double way = to - angle - full * turns;
        return angle + way * part;
    }

    Tone tone_of(const Site& site, Vec2 place, std::uint32_t i) const {
        const double light = 0.75 * clumps_[static_cast<std::size_t>(site.clump)].light(place) +
                             0.3 * crown_.light(place) + 0.4 * around(site.key, kTone, i);
        // About a third of the leaves in each tone. More chance makes confetti, less hard edges.
        if (light > 0.28) return kLight;
        return light < -0.28 ? kShade : kMid;
    }

    // Clump by clump, the high ones first: the lit top of each lies over the shade of the one
    // above it, as clouds do. The middle tone is the layer's own paint.
    Layer layer(const std::vector<Placed>& placed, const std::string& label,
                const std::array<Colour, kTones>& colours) const {
        Layer result{label, paint_of(colours[kMid]), {}};
        const std::string prefix = result.id() + '.';
        std::vector<Tonal> tonal = by_clump(placed);
        for (const std::size_t i : high_first(tonal)) {
            const std::string id = prefix + params_.clump_id(static_cast<std::int32_t>(i));
            Group clump{id, {}, {}};
            for (std::size_t tone = 0; tone < kTones; ++tone) {
                if (tonal[i][tone].empty()) continue;
                const Paint paint = tone == kMid ? Paint{} : paint_of(colours[tone]);
                clump.children.emplace_back(
                    Group{id + '.' + kToneNames[tone], paint, std::move(tonal[i][tone])});
            }
            result.children.emplace_back(std::move(clump));
        }
        return result;
    }

    // The ornaments of each clump by tone, in the order in which they were placed.
    std::vector<Tonal> by_clump(const std::vector<Placed>& placed) const {
        std::vector<std::array<std::size_t, kTones>> counts(clumps_.size());
        for (const Placed& one : placed)
            ++counts[static_cast<std::size_t>(one.clump)][one.tone];
        std::vector<Tonal> tonal(clumps_.size());
        for (std::size_t i = 0; i < tonal.size(); ++i) {
            for (std::size_t tone = 0; tone < kTones; ++tone)
                tonal[i][tone].reserve(counts[i][tone]);
        }
        for (const Placed& one : placed) {
            tonal[static_cast<std::size_t>(one.clump)][one.tone].emplace_back(
                Use{params_.symbol, one.page_from_symbol, {}});
        }
        return tonal;
    }

    // The clumps that have any.
    std::vector<std::size_t> high_first(const std::vector<Tonal>& tonal) const {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < tonal.size(); ++i) {
            const auto bare = [](const std::vector<Element>& uses) { return uses.empty(); };
            if (!std::all_of(tonal[i].begin(), tonal[i].end(), bare)) order.push_back(i);
        }
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return clumps_[a].centre.y < clumps_[b].centre.y;
        });
        return order;
    }

    Paint paint_of(Colour colour) const {
        Paint paint;
        paint.fill = colour;
        if (params_.stroked) paint.stroke = colour;
        return paint;
    }

    const PlacementParams& params_;
    const OrnamentParams& ornament_;
    const KeyedRandom& random_;
    std::vector<Cloud> clumps_;
    Cloud crown_;
    std::vector<Placed> behind_, front_;
    std::vector<Affine> all_;
};

}  // namespace

Placement place(std::span<const Site> sites, const PlacementParams& params,
                const KeyedRandom& random) {
    return Placer(sites, params, random).result();
}

}  // namespace edaha
