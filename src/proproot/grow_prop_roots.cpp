// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"
#include "proproot/level_direction.h"
#include "proproot/prop_roots.h"
#include "proproot/root_line.h"
#include "proproot/root_purpose.h"
#include "proproot/root_space.h"
#include "proproot/root_tables.h"

namespace edaha {
namespace {

constexpr double kPi = std::numbers::pi;

// The height of the root that forks as often as table 3.4 says, part of the mean primary's. Most
// roots are no primaries, so it is less than 1; this brings plants of 49 primaries to the 389 roots
// that the thesis counted on one (1: 245, 0.4: 550).
constexpr double kTypicalRoot = 0.58;

// Young roots are longer than this many radii, or they are stubs.
constexpr double kLeastYoung = 6;

// A plant of more is refused: ten times the richest by the tables.
constexpr std::size_t kMostRoots = 20000;

// A root that is to grow, once its order's turn comes.
struct Bud {
    std::int32_t parent = -1;
    std::uint32_t number = 1;
    Range along{0, 0};  // stretch of the parent that it leaves from
    Range part{0, 0};   // geometric heights: of the ladder
    Key key = 0;
};

// How often something with this mean happens: the count at which the chances add up to u.
int poisson(double mean, double u) {
    double chance = stable::exp(-mean), sum = chance;
    int count = 0;
    while (u > sum && count < 1000) {
        chance *= mean / ++count;
        sum += chance;
    }
    return count;
}

class RootGrowth {
  public:
    RootGrowth(const PropRootParams& params, const KeyedRandom& random)
        : params_(params), random_(random), x_(effective_primaries(params)), age_(root_age(x_)) {
        out_.primaries = x_;
        out_.trunk = make_trunk(params, x_, random);
        std::vector<double> weights = params.turn_weights;
        weights.resize(kTurnBins, 0);
        const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
        double sum = 0;
        for (const double weight : weights) {
            sum += weight;
            turns_.push_back(total > 0 ? sum / total : 1);
        }
        space_.add(trunk_line(), {-1, -2, 0});
    }

    PropRoots run() {
        const int orders = params_.max_order > 0 ? params_.max_order : age_.max_order;
        std::vector<Bud> buds = primaries();
        for (int order = 1; order <= orders && !buds.empty(); ++order) {
            const std::size_t first = out_.roots.size();
            if (first + buds.size() > kMostRoots)
                throw IoError("proproot.branchings: the plant has more than " +
                              std::to_string(kMostRoots) +
                              " roots; lower it or proproot.max_order");
            for (const Bud& bud : buds)
                grow(bud);
            out_.by_order.push_back(out_.roots.size() - first);
            buds = forks(first);
        }
        finish();
        return std::move(out_);
    }

  private:
    double uniform(const Bud& bud, RootPurpose purpose, std::uint32_t attempt) const {
        return random_.uniform(bud.key, purpose, attempt);
    }

    std::vector<Bud> primaries() const {
        std::vector<std::pair<double, int>> ladder;
        for (int i = 0; i < x_; ++i) {
            const Key key = step(name_key("root"), static_cast<std::uint64_t>(i));
            ladder.emplace_back(random_.uniform(key, kRung), i);
        }
        std::sort(ladder.begin(), ladder.end());
        std::vector<Bud> buds(static_cast<std::size_t>(x_));
        for (int rung = 0; rung < x_; ++rung) {
            const int i = ladder[static_cast<std::size_t>(rung)].second;
            Bud& bud = buds[static_cast<std::size_t>(i)];
            bud.number = static_cast<std::uint32_t>(i + 1);
            bud.part = {double(rung) / x_, double(rung + 1) / x_};
            bud.key = step(name_key("root"), static_cast<std::uint64_t>(i));
        }
        return buds;
    }

    void grow(const Bud& bud) {
        const int attempts = params_.apart ? params_.tries + 1 : 1;
        for (int i = 0; i < attempts; ++i) {
            const auto attempt = static_cast<std::uint32_t>(i);
            PropRoot root = bud.parent < 0 ? draw_primary(bud, attempt) : draw_child(bud, attempt);
            if (!params_.apart) return out_.roots.push_back(root);
            const auto self = static_cast<std::int32_t>(out_.roots.size());
            const RootBody body{self, root.parent, joint_of(root)};
            const std::vector<LinePoint> line = root_line(root, params_);
            if (!space_.free(line, body)) continue;
            space_.add(line, body);
            return out_.roots.push_back(root);
        }
        ++out_.removed;
    }

    double joint_of(const PropRoot& root) const {
        const double parent = root.parent < 0
                                  ? root.trunk_radius
                                  : out_.roots[static_cast<std::size_t>(root.parent)].radius;
        return joint_length(root.radius, parent);
    }

    PropRoot draw_primary(const Bud& bud, std::uint32_t attempt) const {
        PropRoot root;
        // Evenly round the trunk, each off by up to (60 / x) degrees.
        const double off = 2 * uniform(bud, kAzimuth, attempt) - 1;
        root.azimuth_rad = (2 * kPi * (bud.number - 1) + kPi / 3 * off) / x_;
        const double highest = highest_primary(params_, x_);
        const double u = uniform(bud, kHeight, attempt);
        // By the ladder H S^i of Yoshikai et al. (2021), or anywhere (3.3.2).
        const double b = params_.heights == RootHeights::geometric
                             ? highest * stable::pow(kLowestBranching / highest, bud.part.at(u))
                             : Range{kLowestBranching, highest}.at(u);
        root.trunk_radius = out_.trunk.radius(b);
        root.base = out_.trunk.centre(b) + level_direction(root.azimuth_rad) * root.trunk_radius;
        draw_curve(root, bud, attempt);
        return root;
    }

    PropRoot draw_child(const Bud& bud, std::uint32_t attempt) const {
        const PropRoot& parent = out_.roots[static_cast<std::size_t>(bud.parent)];
        PropRoot root;
        root.parent = bud.parent;
        root.order = parent.order + 1;
        root.parent_along = bud.along.at(uniform(bud, kPlace, attempt + 1));
        root.base = parent.at(root.parent_along);
        root.turn_rad = draw_turn(bud, attempt);
        root.azimuth_rad = parent.azimuth_rad + root.turn_rad;
        draw_curve(root, bud, attempt);
        return root;
    }

    double draw_turn(const Bud& bud, std::uint32_t attempt) const {
        const double u = uniform(bud, kTurn, attempt);
        const auto bin = static_cast<std::size_t>(std::min<std::ptrdiff_t>(
            std::upper_bound(turns_.begin(), turns_.end(), u) - turns_.begin(), kTurnBins - 1));
        const double before = bin == 0 ? 0 : turns_[bin - 1];
        const double width = bin + 1 == kTurnBins ? kPi / 18 : kPi / kTurnBins;
        const double within = (u - before) / (turns_[bin] - before);
        const double turn = double(bin) * kPi / kTurnBins + width * within;
        return uniform(bud, kSide, attempt) < 0.5 ? -turn : turn;
    }

    void draw_curve(PropRoot& root, const Bud& bud, std::uint32_t attempt) const {
        root.number = bud.number;
        root.key = bud.key;
        root.radius = root_radius(x_, root.order);
        const double a = sag(params_.type).at(uniform(bud, kSag, attempt));
        const double bulges = params_.bulges < 0 ? bulge_share(params_.type) : params_.bulges;
        const double b = root.base.y;
        // The steeper the more it turns (table 3.5).
        root.curve = {-a / slope_factor(root.turn_rad), b, 0};
        root.bulges = uniform(bud, kBulges, attempt) < bulges;
        if (root.bulges) {
            // Less than a twentieth of its height would not be seen.
            const Range rise{0.05, kMostBulge};
            root.curve =
                rising_catenary(root.curve.a, b, b * rise.at(uniform(bud, kRise, attempt)));
        }
        root.length = root.curve.length(root.curve.at_height(0));
        const double tip = root.length * Range{0.35, 0.8}.at(uniform(bud, kReach, attempt));
        root.young = uniform(bud, kYoung, 0) < params_.young && tip > kLeastYoung * root.radius;
        if (root.young) root.length = tip;
    }

    // Where children may leave a root: between two parts of its own height, never too low.
    Range fork_stretch(const PropRoot& root) const {
        const double b = root.base.y;
        const auto along = [&](double y) { return root.curve.length(root.curve.at_height(y)); };
        return {along(kForkHeights.high * b), along(kForkHeights.low * b)};
    }

    std::vector<Bud> forks(std::size_t first) const {
        const double mean = params_.branchings < 0 ? age_.branchings : params_.branchings;
        const int most = params_.max_branchings < 0 ? age_.max_branchings : params_.max_branchings;
        const double rate = mean / typical_stretch();
        std::vector<Bud> buds;
        for (std::size_t i = first; i < out_.roots.size(); ++i)
            add_forks(i, rate, most, buds);
        return buds;
    }

    // Of a root that forks as often as the table says: longer ones fork more.
    double typical_stretch() const {
        PropRoot root;
        const Range heights{kLowestBranching, highest_primary(params_, x_)};
        root.base.y = kTypicalRoot * heights.at(0.5);
        root.curve = {-sag(params_.type).at(0.5), root.base.y, 0};
        const Range stretch = fork_stretch(root);
        return stretch.high - stretch.low;
    }

    // Children come with an even chance along the root (3.3.3), here at nearly even spacing
    // (2.2.1).
    void add_forks(std::size_t index, double rate, int most, std::vector<Bud>& buds) const {
        const PropRoot& root = out_.roots[index];
        if (root.young) return;
        const Range stretch = fork_stretch(root);
        const double length = stretch.high - stretch.low;
        const int count = std::min(poisson(rate * length, random_.uniform(root.key, kForks)), most);
        const double lowest = root.base.y <= kLowestBranching
                                  ? 0
                                  : root.curve.length(root.curve.at_height(kLowestBranching));
        for (int i = 0; i < count; ++i) {
            Bud bud;
            bud.parent = static_cast<std::int32_t>(index);
            bud.number = static_cast<std::uint32_t>(i + 1);
            bud.along = {stretch.low + length * (i + 0.1) / count,
                         stretch.low + length * (i + 0.9) / count};
            bud.key = step(root.key, static_cast<std::uint64_t>(i));
            if (bud.along.at(uniform(bud, kPlace, 0)) > lowest) break;
            bud.along.high = std::min(bud.along.high, lowest);
            buds.push_back(bud);
        }
    }

    std::vector<LinePoint> trunk_line() const {
        std::vector<LinePoint> line;
        constexpr int kSteps = 12;
        for (int i = 0; i <= kSteps; ++i) {
            const double y = out_.trunk.span * i / kSteps;
            line.push_back({out_.trunk.centre(y), y, out_.trunk.radius(y)});
        }
        return line;
    }

    // The trunk is a fifth higher than the highest root (3.4).
    void finish() {
        double top = 0;
        for (const PropRoot& root : out_.roots) {
            top = std::max(top, root.curve.height(root.curve.apex));
            out_.bulging += root.bulges;
        }
        if (top > 0) out_.trunk.height = 1.2 * top;
    }

    const PropRootParams& params_;
    const KeyedRandom& random_;
    int x_;
    const RootAge& age_;
    std::vector<double> turns_;  // how many turn less, by bin
    RootSpace space_{16};
    PropRoots out_;
};

}  // namespace

int effective_primaries(const PropRootParams& params) {
    const double seedling =
        params.propagule_length / 30 * (1 + 0.6 * (params.planting_depth - 0.5));
    return std::clamp(static_cast<int>(std::lround(params.primaries * seedling)), 1, 100);
}

PropRoots grow_prop_roots(const PropRootParams& params, const KeyedRandom& random) {
    return RootGrowth(params, random).run();
}

}  // namespace edaha
