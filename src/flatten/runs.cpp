// SPDX-License-Identifier: MIT
#include "flatten/runs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/stable_math.h"

namespace edaha {
namespace {

// Another kind counts as this much more of a turn (1 - cosine).
constexpr double kChangeOfKind = 0.02;

// The pair that turns least, if one turns little enough.
void pair_best(std::span<const Spoke> spokes, double least_cos,
               std::vector<std::uint32_t>& partner) {
    double best = HUGE_VAL;
    const Spoke *first = nullptr, *second = nullptr;
    for (std::size_t i = 0; i < spokes.size(); ++i) {
        for (std::size_t j = i + 1; j < spokes.size(); ++j) {
            const double turn = 1 + glm::dot(spokes[i].direction, spokes[j].direction);
            const double cost = turn + (spokes[i].kind != spokes[j].kind ? kChangeOfKind : 0);
            if (turn > 1 - least_cos || cost >= best) continue;
            best = cost, first = &spokes[i], second = &spokes[j];
        }
    }
    if (first == nullptr) return;
    partner[first->end] = second->end;
    partner[second->end] = first->end;
}

// Walks along paired ends.
class Follower {
  public:
    Follower(const ArcSet& arcs, std::span<const std::uint32_t> partner)
        : arcs_(arcs), partner_(partner) {}

    RunSet follow(std::span<const std::uint8_t> wanted) {
        done_.assign(arcs_.arcs.size(), 0);
        for (std::uint32_t a = 0; a < arcs_.arcs.size(); ++a) {
            if (wanted[a] && !done_[a]) collect(a);
        }
        return std::move(result_);
    }

  private:
    // An end that leaves a node is the arc's own start if it is left forward.
    ArcUse before(ArcUse use) const {
        const std::uint32_t end = partner_[2 * use.arc + (use.forward ? 0 : 1)];
        return end == kNone ? ArcUse{} : ArcUse{end / 2, end % 2 != 0};
    }
    ArcUse after(ArcUse use) const {
        const std::uint32_t end = partner_[2 * use.arc + (use.forward ? 1 : 0)];
        return end == kNone ? ArcUse{} : ArcUse{end / 2, end % 2 == 0};
    }

    void collect(std::uint32_t arc) {
        Run run;
        run.closed = arcs_.arcs[arc].closed;
        ArcUse use{arc, true};
        for (ArcUse b = before(use); b.arc != kNone && !run.closed; b = before(use)) {
            run.closed = b.arc == arc;
            use = b;
        }
        if (run.closed) use = {arc, true};
        run.first = static_cast<std::uint32_t>(result_.uses.size());
        for (; use.arc != kNone && !done_[use.arc]; use = after(use)) {
            done_[use.arc] = 1;
            result_.uses.push_back(use);
        }
        run.end = static_cast<std::uint32_t>(result_.uses.size());
        result_.runs.push_back(run);
    }

    const ArcSet& arcs_;
    std::span<const std::uint32_t> partner_;
    std::vector<std::uint8_t> done_;
    RunSet result_;
};

}  // namespace

RunSet follow_partners(const ArcSet& arcs, std::span<const std::uint32_t> partner,
                       std::span<const std::uint8_t> wanted) {
    return Follower(arcs, partner).follow(wanted);
}

RunSet join_arcs(const ArcGraph& graph, const JoinParams& params) {
    const std::size_t count = graph.arcs.arcs.size();
    std::vector<std::uint8_t> wanted(count);
    for (std::size_t a = 0; a < count; ++a)
        wanted[a] = !graph.vanished[a];
    const double least_cos = stable::sin_cos(params.most_turn * std::numbers::pi / 180).cos;
    std::vector<std::uint32_t> partner(2 * count, kNone);
    visit_nodes(spokes_of(graph, wanted, params.window),
                [&](std::span<const Spoke> spokes) { pair_best(spokes, least_cos, partner); });
    return follow_partners(graph.arcs, partner, wanted);
}

}  // namespace edaha
