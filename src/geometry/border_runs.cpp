// SPDX-License-Identifier: MIT
#include "geometry/border_runs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

// Weaving outlines change places every few chords; looking further ahead than this finds nothing.
constexpr std::size_t kMostRunsBetween = 6;
constexpr double kMostChordsBetween = 256;
// Chords that fell into one pixel, and spikes of a few steps, leave gaps of this size.
constexpr double kSnapReach = 4;

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double length2 = glm::dot(d, d);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0;
    return glm::distance(p, a + d * t);
}

// No point of `line` is further than `reach` from the polyline `other`.
bool stays_near(const std::vector<Vec2>& line, const std::vector<Vec2>& other, double reach) {
    return std::all_of(line.begin(), line.end(), [&](Vec2 p) {
        for (std::size_t i = 1; i < other.size(); ++i) {
            if (distance_to_segment(p, other[i - 1], other[i]) <= reach) return true;
        }
        return other.size() == 1 && glm::distance(p, other[0]) <= reach;
    });
}

// Area between two lines with common ends, as seen from their start.
double area_between(const std::vector<Vec2>& line, const std::vector<Vec2>& other) {
    const auto swept = [&](const std::vector<Vec2>& points) {
        double sum = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec2 a = points[i - 1] - line[0], b = points[i] - line[0];
            sum += (a.x * b.y - a.y * b.x) / 2;
        }
        return sum;
    };
    return std::abs(swept(line) - swept(other));
}

double length_of(const std::vector<Vec2>& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += glm::distance(line[i - 1], line[i]);
    return length;
}

// Two lines with common ends that run side by side: not a loop, and the same loop the other way
// round.
bool run_together(const std::vector<Vec2>& line, const std::vector<Vec2>& other, double reach) {
    return stays_near(line, other, reach) && stays_near(other, line, reach) &&
           area_between(line, other) <= reach * (length_of(line) + reach);
}

class RunFinder {
  public:
    RunFinder(const Cover& cover, std::span<const std::uint32_t> ring,
              std::span<const std::uint8_t> touching, double reach)
        : cover_(cover), map_(cover.map), ring_(ring), touching_(touching), reach_(reach) {}

    std::vector<BorderRun> find() {
        for (std::uint32_t i = 0; i < ring_.size(); ++i)
            add(i);
        join_ends();
        heal();
        // Once more with the seam elsewhere.
        if (runs_.size() > 2) {
            std::rotate(runs_.begin(), runs_.begin() + runs_.size() / 2, runs_.end());
            heal();
        }
        return std::move(runs_);
    }

  private:
    double ring_length(const BorderRun& run) const {
        const SourceRing& ring = cover_.chords.rings[run.ring];
        return ring.end_chord - ring.first_chord;
    }

    // The half-edge as a passage of one of its sources.
    BorderRun passage(std::uint32_t index, const EdgeUse& use) const {
        const std::uint32_t h = ring_[index];
        const Chords& chords = cover_.chords;
        const GridSegment& chord = chords.segments[use.segment];
        BorderRun run;
        run.ring = chords.ring_of[use.segment];
        run.forward = use.forward == (h % 2 == 0);
        run.straight = chords.curves[chords.curve_of[use.segment]].straight;
        run.start = map_.nodes[map_.origin(h)];
        run.stop = map_.nodes[map_.target(h)];
        const double place = use.segment - chords.rings[run.ring].first_chord;
        run.begin = place + fraction_at(chord, run.start);
        run.end = place + fraction_at(chord, run.stop);
        run.first = index;
        run.count = 1;
        return run;
    }

    // How far the source runs on between the end of one run and the start of another, in chords.
    std::optional<double> gap(const BorderRun& before, const BorderRun& after) const {
        if (before.ring != after.ring || before.forward != after.forward) return std::nullopt;
        const double around = ring_length(before);
        const double on = before.forward ? after.begin - before.end : before.end - after.begin;
        const double rest = std::fmod(std::fmod(on, around) + around, around);
        return rest > around - 1e-9 ? 0 : rest;
    }

    // The source's own corners from `place` on over `chords` chords.
    std::vector<Vec2> source_line(const BorderRun& run, double place, double chords) const {
        const SourceRing& ring = cover_.chords.rings[run.ring];
        const auto around = static_cast<std::int64_t>(ring.end_chord - ring.first_chord);
        const double last = run.forward ? place + chords : place - chords;
        const double low = std::min(place, last), high = std::max(place, last);
        std::vector<Vec2> line{at(ring, around, low)};
        for (double p = std::floor(low) + 1; p < high; ++p)
            line.push_back(at(ring, around, p));
        line.push_back(at(ring, around, high));
        if (!run.forward) std::reverse(line.begin(), line.end());
        return line;
    }

    Vec2 at(const SourceRing& ring, std::int64_t around, double place) const {
        const auto whole = static_cast<std::int64_t>(std::floor(place));
        const auto chord = static_cast<std::uint32_t>((whole % around + around) % around);
        const GridSegment& s = cover_.chords.segments[ring.first_chord + chord];
        return to_vec(s.a) + (to_vec(s.b) - to_vec(s.a)) * (place - static_cast<double>(whole));
    }

    bool continues(const BorderRun& before, const BorderRun& after) const {
        const auto chords = gap(before, after);
        if (!chords) return false;
        if (before.straight && after.straight && touches_before(after)) return false;
        if (*chords < 1e-9) return true;
        return *chords < 8 && stays_near(source_line(before, before.end, *chords),
                                         {to_vec(before.stop)}, kSnapReach);
    }

    bool touches_before(const BorderRun& run) const {
        return touching_[map_.origin(ring_[run.first])] != 0;
    }

    void extend(BorderRun& run, const BorderRun& more, double chords) const {
        const double length = chords + std::abs(more.end - more.begin);
        run.end += run.forward ? length : -length;
        run.stop = more.stop;
        run.straight = run.straight && more.straight;
        const auto size = static_cast<std::uint32_t>(ring_.size());
        run.count = (more.first + more.count + 2 * size - run.first) % size;
        if (run.count == 0) run.count = size;
    }

    void add(std::uint32_t index) {
        const auto uses = cover_.arrangement.uses_of(ring_[index] / 2);
        for (const EdgeUse& use : uses) {
            const BorderRun next = passage(index, use);
            if (runs_.empty() || !continues(runs_.back(), next)) continue;
            extend(runs_.back(), next, *gap(runs_.back(), next));
            return;
        }
        runs_.push_back(passage(index, uses.front()));
    }

    // The ring starts anywhere: the last run may go on as the first, or a single one as itself,
    // which then is the whole source ring from its own start.
    void join_ends() {
        if (runs_.size() > 1 && continues(runs_.back(), runs_.front())) {
            extend(runs_.back(), runs_.front(), *gap(runs_.back(), runs_.front()));
            runs_.erase(runs_.begin());
        }
        if (runs_.size() != 1 || !continues(runs_[0], runs_[0])) return;
        BorderRun& run = runs_[0];
        run.begin = run.forward ? 0 : ring_length(run);
        run.end = run.forward ? ring_length(run) : 0;
        run.start = run.stop = cover_.chords.segments[cover_.chords.rings[run.ring].first_chord].a;
    }

    void heal() {
        std::vector<BorderRun> healed;
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            BorderRun run = runs_[i];
            while (const std::size_t back = return_after(run, i)) {
                extend(run, runs_[back], *gap(run, runs_[back]));
                i = back;
            }
            healed.push_back(run);
        }
        runs_ = std::move(healed);
    }

    // The run after `i` in which the border is back on the source of `run`, 0 if it isn't.
    std::size_t return_after(const BorderRun& run, std::size_t i) const {
        const std::size_t last = std::min(runs_.size() - 1, i + 1 + kMostRunsBetween);
        for (std::size_t j = i + 2; j <= last; ++j) {
            if (run.straight && runs_[j].straight) continue;  // polygons don't weave
            const auto chords = gap(run, runs_[j]);
            if (!chords || *chords > kMostChordsBetween) continue;
            if (std::abs(run.end - run.begin) + *chords > ring_length(run)) continue;
            const std::vector<Vec2> source = source_line(run, run.end, *chords);
            const std::vector<Vec2> border = border_line(run, runs_[j]);
            if (run_together(border, source, reach_)) return j;
        }
        return 0;
    }

    // The nodes from the end of one run to the start of another.
    std::vector<Vec2> border_line(const BorderRun& from, const BorderRun& to) const {
        const auto size = static_cast<std::uint32_t>(ring_.size());
        const std::uint32_t begin = (from.first + from.count) % size;
        const std::uint32_t steps = (to.first + size - begin) % size;
        std::vector<Vec2> line;
        for (std::uint32_t i = 0; i <= steps; ++i) {
            line.push_back(to_vec(map_.nodes[map_.origin(ring_[(begin + i) % size])]));
        }
        return line;
    }

    const Cover& cover_;
    const PlanarMap& map_;
    std::span<const std::uint32_t> ring_;
    std::span<const std::uint8_t> touching_;
    double reach_;
    std::vector<BorderRun> runs_;
};

}  // namespace

std::vector<std::uint8_t> touching_nodes(const PlanarMap& map, const RegionRings& rings) {
    std::vector<std::uint8_t> visits(map.nodes.size(), 0);
    for (const std::uint32_t h : rings.half_edges) {
        std::uint8_t& count = visits[map.origin(h)];
        count = static_cast<std::uint8_t>(std::min(count + 1, 2));
    }
    for (std::uint8_t& count : visits)
        count = count > 1;
    return visits;
}

std::vector<BorderRun> border_runs(const Cover& cover, std::span<const std::uint32_t> ring,
                                   std::span<const std::uint8_t> touching, double reach) {
    return RunFinder(cover, ring, touching, reach).find();
}

}  // namespace edaha
