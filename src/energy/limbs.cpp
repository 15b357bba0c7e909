// SPDX-License-Identifier: MIT
#include "energy/limbs.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "energy/grow.h"

namespace edaha {
namespace {

enum Purpose : std::uint32_t { kBack = 100, kGnarl, kMember };

// A limb with this part of the tree's energy carries a cloud of leaves of its own: a crown then
// has some ten of them, as illustrators draw it. Less gives crumbs, more a single ball.
constexpr double kClumpShare = 0.04;

// Branches below this many times the energy at which growth ends don't wander: half of all limbs
// are such twigs, whose bend at the fork is movement enough, and two nodes saved on each are a
// tenth of the file.
constexpr double kGnarlEnergy = 2;

// A bough with more of the tree's energy than this never stands behind: it would be a pale hole in
// the crown.
constexpr double kHeavyBough = 0.22;

Vec2 page_from_tree(Vec2 p) {
    return {p.x, -p.y};
}

// For each branch its surviving child of most energy, or -1.
std::vector<std::int32_t> heirs(const Skeleton& skeleton) {
    std::vector<std::int32_t> heir(skeleton.branches.size(), -1);
    for (std::size_t i = 1; i < skeleton.branches.size(); ++i) {
        const Branch& branch = skeleton.branches[i];
        std::int32_t& best = heir[static_cast<std::size_t>(branch.parent)];
        if (best < 0) {
            best = static_cast<std::int32_t>(i);
            continue;
        }
        const Branch& rival = skeleton.branches[static_cast<std::size_t>(best)];
        const bool heavier = branch.energy > rival.energy ||
                             (branch.energy == rival.energy && branch.child < rival.child);
        if (heavier) best = static_cast<std::int32_t>(i);
    }
    return heir;
}

class LimbMaker {
  public:
    LimbMaker(const Skeleton& skeleton, const EnergyParams& energy, const LookParams& look)
        : skeleton_(skeleton),
          energy_(energy),
          look_(look),
          random_(energy.variant.family, energy.variant.seed, energy.variant.vary),
          tip_width_mm_(branch_width_mm(energy.growth, energy.growth.stop_energy) * look.tip),
          heir_(heirs(skeleton)),
          end_node_(skeleton.branches.size(), 0),
          fork_number_(skeleton.branches.size(), 0) {}

    Limbs run() {
        const std::size_t count = skeleton_.branches.size();
        out_.nodes.reserve(count * 2);
        std::vector<std::int32_t> limb_of(count, -1);
        for (std::size_t i = 0; i < count; ++i) {
            const auto index = static_cast<std::int32_t>(i);
            const std::int32_t parent = skeleton_.branches[i].parent;
            if (parent >= 0 && heir_[static_cast<std::size_t>(parent)] == index) {
                limb_of[i] = limb_of[static_cast<std::size_t>(parent)];
                continue;
            }
            limb_of[i] = static_cast<std::int32_t>(out_.limbs.size());
            add_limb(index, parent < 0 ? -1 : limb_of[static_cast<std::size_t>(parent)]);
        }
        return std::move(out_);
    }

  private:
    void add_limb(std::int32_t branch, std::int32_t parent) {
        const Branch& first = skeleton_.branches[static_cast<std::size_t>(branch)];
        Limb limb;
        limb.parent = parent;
        limb.branch = branch;
        limb.key = first.key;
        limb.member_key = mix(static_cast<Key>(random_.uniform(first.key, kMember) * 0x1p53));
        if (energy_.growth.type == TreeType::b && first.child > 0) {
            limb.side = first.child == 1 ? 'r' : 'l';
        }
        limb.first_node = static_cast<std::uint32_t>(out_.nodes.size());
        if (parent >= 0) {
            const Limb& from = out_.limbs[static_cast<std::size_t>(parent)];
            const bool is_bough = from.order == 0;
            limb.order = static_cast<std::uint16_t>(from.order + 1);
            limb.parent_node = end_node_[static_cast<std::size_t>(first.parent)];
            limb.fork = fork_number_[static_cast<std::size_t>(first.parent)];
            limb.bough = is_bough ? static_cast<std::int32_t>(out_.limbs.size()) : from.bough;
            limb.back = is_bough ? stands_behind(first) : from.back;
        }
        const bool bears_clump =
            limb.order < 2 || first.energy >= kClumpShare * energy_.growth.energy;
        limb.clump = bears_clump ? static_cast<std::int32_t>(out_.limbs.size())
                                 : out_.limbs[static_cast<std::size_t>(parent)].clump;
        limb.terminal = add_nodes(branch);
        limb.node_count = static_cast<std::uint32_t>(out_.nodes.size()) - limb.first_node;
        const std::span nodes = std::span(out_.nodes).subspan(limb.first_node);
        limit_base(nodes, limb);
        set_tapers(nodes);
        if (look_.straight) {
            set_straight_velocities(nodes);
        } else {
            set_spline_velocities(nodes, start_velocity(nodes, limb));
        }
        out_.limbs.push_back(limb);
    }

    bool stands_behind(const Branch& bough) const {
        return bough.energy < kHeavyBough * energy_.growth.energy &&
               random_.uniform(bough.key, kBack) < look_.back;
    }

    // Says whether the last branch bears a leaf.
    bool add_nodes(std::int32_t branch) {
        const Branch& first = skeleton_.branches[static_cast<std::size_t>(branch)];
        double here_width = width_of(first), width = here_width;
        std::uint32_t fork = 0;
        bool terminal = false;
        add_node(page_from_tree(skeleton_.start(first)), width);
        for (std::int32_t at = branch; at >= 0; at = heir_[static_cast<std::size_t>(at)]) {
            const Branch& here = skeleton_.branches[static_cast<std::size_t>(at)];
            const std::int32_t next = heir_[static_cast<std::size_t>(at)];
            // Between two branches the mean of their widths: the fall at a fork is spread over
            // both sides of it.
            const double next_width =
                next < 0 ? 0 : width_of(skeleton_.branches[static_cast<std::size_t>(next)]);
            const double end_width = next < 0 ? std::min(look_.tip * here_width, tip_width_mm_)
                                              : (here_width + next_width) / 2;
            const Vec2 start = out_.nodes.back().position, end = page_from_tree(here.end);
            if (look_.gnarl > 0 && !look_.straight &&
                here.energy > kGnarlEnergy * energy_.growth.stop_energy) {
                const double u = random_.uniform(here.key, kGnarl) * 2 - 1;
                const Vec2 along = end - start;
                // A fifth of the length aside is as crooked as an old oak: that is gnarl 1.
                add_node((start + end) * 0.5 + Vec2(-along.y, along.x) * (0.2 * look_.gnarl * u),
                         (width + end_width) / 2);
            }
            add_node(end, end_width);
            width = end_width;
            here_width = next_width;
            terminal = here.terminal;
            fork_number_[static_cast<std::size_t>(at)] = ++fork;
            end_node_[static_cast<std::size_t>(at)] =
                static_cast<std::uint32_t>(out_.nodes.size() - 1);
        }
        return terminal;
    }

    void add_node(Vec2 position, double width) {
        LimbNode node;
        node.position = position;
        node.half_width = std::max(width, look_.min_width_mm) / 2;
        out_.nodes.push_back(node);
    }

    double width_of(const Branch& branch) const {
        return branch_width_mm(energy_.growth, branch.energy);
    }

    // A child is never wider than its parent where it leaves.
    void limit_base(std::span<LimbNode> nodes, const Limb& limb) const {
        if (limb.parent < 0) return;
        const double most = out_.nodes[limb.parent_node].half_width;
        for (LimbNode& node : nodes)
            node.half_width = std::min(node.half_width, most);
    }

    // Fritsch & Carlson (1980): harmonic means of the slopes keep a falling width falling.
    // Chords too.
    static void set_tapers(std::span<LimbNode> nodes) {
        const std::size_t last = nodes.size() - 1;
        for (std::size_t i = 0; i < last; ++i) {
            nodes[i].chord = glm::distance(nodes[i].position, nodes[i + 1].position);
        }
        const auto slope = [&](std::size_t i) {
            return (nodes[i + 1].half_width - nodes[i].half_width) / nodes[i].chord;
        };
        nodes[0].taper = slope(0);
        nodes[last].taper = slope(last - 1);
        for (std::size_t i = 1; i < last; ++i) {
            const double before = slope(i - 1), after = slope(i);
            nodes[i].taper = before * after > 0 ? 2 * before * after / (before + after) : 0;
        }
    }

    static void set_straight_velocities(std::span<LimbNode> nodes) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Vec2 from = nodes[i > 0 ? i - 1 : 0].position;
            const Vec2 to = nodes[std::min(i + 1, nodes.size() - 1)].position;
            nodes[i].velocity = glm::normalize(to - from);
        }
    }

    // Between the parent's heading and the way to the first fork.
    Vec2 start_velocity(std::span<const LimbNode> nodes, const Limb& limb) const {
        const Vec2 own = glm::normalize(nodes[1].position - nodes[0].position);
        // A trunk rises straight from the ground before it leans.
        if (limb.parent < 0) return glm::normalize(own * 0.15 + Vec2(0, -0.85));
        const Vec2 parent = glm::normalize(out_.nodes[limb.parent_node].velocity);
        const Vec2 between = parent * look_.sweep + own * (1 - look_.sweep);
        const double length = glm::length(between);
        // Nearly opposite headings have no middle worth the name.
        return length < 0.3 ? own : between / length;
    }

    // The C2 cubic spline by chord length, clamped at the start, natural at the end: a tridiagonal
    // system in the velocities.
    void set_spline_velocities(std::span<LimbNode> nodes, Vec2 start) {
        const std::size_t n = nodes.size();
        diagonal_.resize(n);
        nodes[0].velocity = start;
        diagonal_[0] = 0;  // the upper coefficient after elimination
        for (std::size_t i = 1; i < n; ++i) {
            const Vec2 before = nodes[i].position - nodes[i - 1].position;
            const double h0 = nodes[i - 1].chord;
            if (i + 1 == n) {  // no curvature at the tip: v[n-2] + 2 v[n-1] = 3 slope
                const double pivot = 2 - diagonal_[i - 1];
                nodes[i].velocity = (before * (3 / h0) - nodes[i - 1].velocity) / pivot;
                break;
            }
            const Vec2 after = nodes[i + 1].position - nodes[i].position;
            const double h1 = nodes[i].chord;
            const Vec2 right = 3.0 * (before * (h1 / h0) + after * (h0 / h1));
            const double pivot = 2 * (h0 + h1) - h1 * diagonal_[i - 1];
            diagonal_[i] = h0 / pivot;
            nodes[i].velocity = (right - h1 * nodes[i - 1].velocity) / pivot;
        }
        for (std::size_t i = n - 1; i-- > 1;) {
            nodes[i].velocity -= diagonal_[i] * nodes[i + 1].velocity;
        }
    }

    const Skeleton& skeleton_;
    const EnergyParams& energy_;
    const LookParams& look_;
    KeyedRandom random_;
    double tip_width_mm_;
    std::vector<std::int32_t> heir_;
    std::vector<std::uint32_t> end_node_;     // of each branch: the node at its end
    std::vector<std::uint32_t> fork_number_;  // of each branch: its end's, along its limb
    std::vector<double> diagonal_;            // scratch
    Limbs out_;
};

}  // namespace

namespace {

std::string id_from(const Limb& limb, std::string stem) {
    stem += '-' + std::to_string(limb.fork);
    if (limb.side != 0) stem += limb.side;
    return stem;
}

}  // namespace

std::string Limbs::id(const Limb& limb) const {
    if (limb.parent < 0) return "trunk";
    const Limb& parent = limbs[static_cast<std::size_t>(limb.parent)];
    return id_from(limb, parent.parent < 0 ? "limb" : id(parent));
}

std::vector<std::string> Limbs::ids() const {
    std::vector<std::string> ids;
    ids.reserve(limbs.size());
    for (const Limb& limb : limbs) {
        const std::string stem =
            limb.parent > 0 ? ids[static_cast<std::size_t>(limb.parent)] : "limb";
        ids.push_back(limb.parent < 0 ? "trunk" : id_from(limb, stem));
    }
    return ids;
}

Limbs make_limbs(const Skeleton& skeleton, const EnergyParams& energy, const LookParams& look) {
    return LimbMaker(skeleton, energy, look).run();
}

}  // namespace edaha
