// SPDX-License-Identifier: MIT
#include "energy/grow.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stable_math.h"
#include "energy/density_grid.h"

namespace edaha {
namespace {

constexpr double kPi = std::numbers::pi;
// More than any cell can hold (a float's largest), and any habit can weigh against.
constexpr double kFull = 1e30;

enum Purpose : std::uint32_t { kShare = 1, kSplit, kTurn, kSide, kBole, kLean };

// A branch that is to grow, once its turn comes.
struct Bud {
    double energy = 0;
    double share = 1;  // of its parent's energy
    Range turn_rad{0, 0};
    std::uint64_t sequence = 0;  // breaks ties of energy
    std::int32_t parent = -1;
    std::uint16_t order = 0;
    std::uint8_t child = 0;
    std::int8_t side = 0;          // type A, opposite: to which side it turns
    std::int8_t lateral_side = 0;  // side of its limb's last lateral
};

// Depth first: a stack. By energy: a heap. Either way the next bud is popped off the back.
class BudQueue {
  public:
    explicit BudQueue(GrowthOrder order) : by_energy_(order == GrowthOrder::energy) {}

    void push(Bud bud) {
        bud.sequence = sequence_++;
        buds_.push_back(bud);
        if (by_energy_) std::push_heap(buds_.begin(), buds_.end(), later);
    }
    Bud pop() {
        if (by_energy_) std::pop_heap(buds_.begin(), buds_.end(), later);
        const Bud bud = buds_.back();
        buds_.pop_back();
        return bud;
    }
    bool empty() const { return buds_.empty(); }

  private:
    static bool later(const Bud& a, const Bud& b) {
        return a.energy != b.energy ? a.energy < b.energy : a.sequence > b.sequence;
    }

    bool by_energy_;
    std::uint64_t sequence_ = 0;
    std::vector<Bud> buds_;
};

class Growth {
  public:
    explicit Growth(const EnergyParams& params)
        : params_(params),
          random_(params.variant.family, params.variant.seed, params.variant.vary),
          grid_(params.space.cell_mm),
          buds_(params.growth.order) {
        const SpaceParams& space = params.space;
        const double kappa = space.habit_weight / (kPi * kPi);
        for (const double heading : space.habit_rad)
            habit_.push_back({heading, kappa});
        if (habit_.empty()) habit_.push_back({0, 0});
        const auto candidates = static_cast<std::size_t>(space.candidates);
        for (std::vector<double>* scratch : {&headings_rad_, &sines_, &cosines_}) {
            scratch->resize(candidates);
        }
        for (int i = 0; i < space.candidates; ++i) {
            turn_salts_.push_back(KeyedRandom::salt(kTurn, static_cast<std::uint32_t>(i)));
        }
    }

    Skeleton run() {
        // Both types make 3 to 3.6 branches per unit of energy; what is not touched costs nothing.
        const double likely = 4 * params_.growth.energy / params_.growth.stop_energy;
        const auto most = static_cast<double>(params_.growth.max_branches);
        tree_.branches.reserve(static_cast<std::size_t>(std::min({likely + 1, most, 1e7})));
        plant();
        while (!buds_.empty())
            sprout(buds_.pop());
        mark_bare_forks();
        return std::move(tree_);
    }

  private:
    struct Habit {
        double heading_rad;
        double weight;  // a score per squared radian
    };
    struct Choice {
        double heading_rad;
        Vec2 end;
        double density;
    };

    void plant() {
        const GrowthParams& growth = params_.growth;
        Branch trunk;
        trunk.key = mix(1);
        trunk.heading_rad = growth.lean_rad.at(random_.uniform(trunk.key, kLean));
        const auto [sin, cos] = stable::sin_cos(trunk.heading_rad);
        const double bole = growth.bole.at(random_.uniform(trunk.key, kBole));
        const double length = bole * branch_length_mm(growth, growth.energy);
        trunk.end = Vec2(sin, cos) * length;
        trunk.energy = growth.energy;
        add(trunk, Vec2(0, 0), 0);
    }

    void sprout(const Bud& bud) {
        const Branch& parent = tree_.branches[static_cast<std::size_t>(bud.parent)];
        const Vec2 start = parent.end;
        Branch branch;
        branch.energy = bud.energy;
        branch.key = step(parent.key, bud.child);
        branch.parent = bud.parent;
        branch.order = bud.order;
        branch.child = bud.child;
        const Choice choice = choose(bud, parent, branch.key);
        const double full = params_.space.drop > 0 ? params_.space.drop : kFull;
        if (choice.density >= full) {  // 2.3.2
            tree_.dropped.push_back({bud.parent, bud.energy});
            return;
        }
        branch.end = choice.end;
        branch.heading_rad = choice.heading_rad;
        add(branch, start, bud.lateral_side);
    }

    // 2.3.1: of k candidates, the one whose destination is emptiest; the first drawn wins ties.
    Choice choose(const Bud& bud, const Branch& parent, Key key) {
        const double length = branch_length_mm(params_.growth, bud.energy);
        const double factor = 1 - params_.branch.balance * bud.share;
        Habit habit = habit_[std::min<std::size_t>(bud.order, habit_.size() - 1)];
        if (params_.space.weep > 0) habit.heading_rad += weep(bud.energy, habit.heading_rad);
        // In rounds, so that the sines run side by side.
        for (std::size_t i = 0; i < turn_salts_.size(); ++i) {
            double turn = bud.turn_rad.at(random_.at(key ^ turn_salts_[i])) * factor;
            if (bud.side != 0) turn = std::abs(turn) * bud.side;
            headings_rad_[i] = parent.heading_rad + turn;
        }
        sines_of(headings_rad_);
        Choice best{};
        double best_score = 0;
        for (std::size_t i = 0; i < turn_salts_.size(); ++i) {
            double score = habit.weight > 0 ? habit.weight * off_habit(headings_rad_[i], habit) : 0;
            if (i > 0 && score >= best_score) continue;  // density only adds to it
            const Vec2 end = parent.end + Vec2(sines_[i], cosines_[i]) * length;
            const double crowd = density(end);
            score += crowd;
            if (i == 0 || score < best_score)
                best = {headings_rad_[i], end, crowd}, best_score = score;
        }
        return best;
    }

    void sines_of(const std::vector<double>& angles_rad) {
        for (std::size_t i = 0; i < angles_rad.size(); ++i) {
            const auto [sin, cos] = stable::sin_cos(angles_rad[i]);
            sines_[i] = sin;
            cosines_[i] = cos;
        }
    }

    // How far a branch of this energy turns from its habit to straight down.
    double weep(double energy, double heading_rad) const {
        const double lightness = 1 - std::sqrt(energy / params_.growth.energy);
        return params_.space.weep * lightness * lightness * (kPi - heading_rad);
    }

    // Below the clearance a place is as good as full.
    double density(Vec2 place) const {
        const double clearance = params_.space.clearance_mm;
        if (clearance > 0 && place.y < clearance) return kFull;
        return grid_.density(place);
    }

    // Squared difference between a heading, left or right alike, and the habit's.
    static double off_habit(double heading_rad, Habit habit) {
        const auto whole_turns = static_cast<double>(stable::floor(heading_rad / (2 * kPi) + 0.5));
        const double away = std::abs(heading_rad - 2 * kPi * whole_turns);
        return (away - habit.heading_rad) * (away - habit.heading_rad);
    }

    void add(const Branch& branch, Vec2 start, std::int8_t lateral_side) {
        const GrowthParams& growth = params_.growth;
        if (std::cmp_greater_equal(tree_.branches.size(), growth.max_branches)) {
            throw IoError("growth.max-branches: the tree has more than " +
                          std::to_string(growth.max_branches) +
                          " branches; lower growth.energy or raise the limit");
        }
        tree_.branches.push_back(branch);
        // 2.3: what is added grows with the thickness of the branch.
        const double amount = branch_width_mm(growth, branch.energy) / params_.space.cell_mm;
        if (params_.space.deposit == Deposit::ends) {
            grid_.add(branch.end, amount);
        } else {
            grid_.add_segment(start, branch.end, amount);
        }
        const auto index = static_cast<std::int32_t>(tree_.branches.size()) - 1;
        if (branch.energy <= growth.stop_energy) {  // 2.1
            tree_.branches.back().terminal = true;
        } else if (growth.type == TreeType::a) {
            fork_a(index, lateral_side);
        } else {
            fork_b(index);
        }
    }

    // Buds are pushed last child first: the stack then grows the first child first.
    void fork_a(std::int32_t parent, std::int8_t lateral_side) {
        const Branch& from = tree_.branches[static_cast<std::size_t>(parent)];
        const double r = params_.growth.share.at(random_.uniform(from.key, kShare));
        const double shares[2] = {r, 1 - r};
        const int leader = r >= 0.5 ? 0 : 1;
        std::int8_t side = 0;
        if (params_.branch.opposite) {
            const bool first_right = random_.uniform(from.key, kSide) < 0.5;
            side = lateral_side != 0 ? static_cast<std::int8_t>(-lateral_side)
                                     : static_cast<std::int8_t>(first_right ? 1 : -1);
        }
        for (int child = 1; child >= 0; --child) {
            Bud bud = bud_of(parent, child, child == leader);
            bud.share = shares[child];
            bud.energy = child == 0 ? r * from.energy : from.energy - r * from.energy;
            bud.turn_rad = params_.branch.turn_rad;
            bud.side = child == leader ? static_cast<std::int8_t>(-side) : side;
            bud.lateral_side = child == leader ? side : std::int8_t{0};
            buds_.push(bud);
        }
    }

    void fork_b(std::int32_t parent) {
        const Branch& from = tree_.branches[static_cast<std::size_t>(parent)];
        const GrowthParams& growth = params_.growth;
        const double r = growth.main_share.at(random_.uniform(from.key, kShare));
        const double split = growth.lateral_split.at(random_.uniform(from.key, kSplit));
        const double main = r * from.energy;
        const double right = split * (from.energy - main);
        const double energies[3] = {main, right, from.energy - main - right};
        const Range turns[3] = {params_.branch.main_turn_rad, params_.branch.right_turn_rad,
                                params_.branch.left_turn_rad};
        const auto leader = std::max_element(energies, energies + 3) - energies;
        for (int child = 2; child >= 0; --child) {
            Bud bud = bud_of(parent, child, child == leader);
            bud.energy = energies[child];
            bud.share = 0;  // balance is type A's
            bud.turn_rad = turns[child];
            buds_.push(bud);
        }
    }

    Bud bud_of(std::int32_t parent, int child, bool leader) const {
        Bud bud;
        bud.parent = parent;
        bud.child = static_cast<std::uint8_t>(child);
        const int order = tree_.branches[static_cast<std::size_t>(parent)].order + (leader ? 0 : 1);
        bud.order = static_cast<std::uint16_t>(order);
        return bud;
    }

    // A fork all of whose children were dropped becomes a terminal.
    void mark_bare_forks() {
        if (tree_.dropped.empty() || !params_.space.drop_leaf) return;
        std::vector<bool> bears(tree_.branches.size(), false);
        for (const Branch& branch : tree_.branches) {
            if (branch.parent >= 0) bears[static_cast<std::size_t>(branch.parent)] = true;
        }
        for (std::size_t i = 0; i < bears.size(); ++i) {
            if (!bears[i]) tree_.branches[i].terminal = true;
        }
    }

    const EnergyParams& params_;
    KeyedRandom random_;
    DensityGrid grid_;
    BudQueue buds_;
    std::vector<Habit> habit_;
    std::vector<Key> turn_salts_;                         // of each candidate
    std::vector<double> headings_rad_, sines_, cosines_;  // of each candidate: scratch
    Skeleton tree_;
};

}  // namespace

double branch_length_mm(const GrowthParams& params, double energy) {
    return params.length_mm * stable::pow(energy, params.length_power);
}

double branch_width_mm(const GrowthParams& params, double energy) {
    return params.width_mm * stable::pow(energy, params.width_power);
}

Skeleton grow(const EnergyParams& params) {
    return Growth(params).run();
}

}  // namespace edaha
