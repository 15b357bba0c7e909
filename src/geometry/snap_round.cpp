// SPDX-License-Identifier: MIT
#include "geometry/snap_round.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/parallel.h"
#include "geometry/neighbours.h"

namespace edaha {
namespace {

bool boxes_meet(const GridSegment& s, const GridSegment& t) {
    const auto [sx0, sx1] = std::minmax(s.a.x, s.b.x);
    const auto [tx0, tx1] = std::minmax(t.a.x, t.b.x);
    if (sx1 < tx0 || tx1 < sx0) return false;
    const auto [sy0, sy1] = std::minmax(s.a.y, s.b.y);
    const auto [ty0, ty1] = std::minmax(t.a.y, t.b.y);
    return sy1 >= ty0 && ty1 >= sy0;
}

bool opposite(std::int64_t a, std::int64_t b) {
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

bool cross_properly(const GridSegment& s, const GridSegment& t) {
    return boxes_meet(s, t) && opposite(orientation(s.a, s.b, t.a), orientation(s.a, s.b, t.b)) &&
           opposite(orientation(t.a, t.b, s.a), orientation(t.a, t.b, s.b));
}

// The nearest integer to along * numerator / denominator, halves upwards, exactly: by doubles
// where these can't be wrong (their error is below 1e-6 for the grid's numbers).
std::int32_t rounded_ratio(std::int64_t along, std::int64_t numerator, std::int64_t denominator) {
    const double value = static_cast<double>(along) *
                         (static_cast<double>(numerator) / static_cast<double>(denominator));
    const double rounded = std::floor(value + 0.5);
    const double fraction = value + 0.5 - rounded;
    if (fraction > 1e-5 && fraction < 1 - 1e-5) return static_cast<std::int32_t>(rounded);
    const Int128 twice = Int128{2} * denominator;
    const Int128 top = Int128{2} * along * numerator + denominator;
    Int128 quotient = top / twice;
    if (top % twice != 0 && (top < 0) != (twice < 0)) --quotient;
    return static_cast<std::int32_t>(quotient);
}

GridPoint rounded_crossing(const GridSegment& s, const GridSegment& t) {
    const GridVector along = s.b - s.a;
    const GridVector other = t.b - t.a;
    const std::int64_t numerator = cross(t.a - s.a, other);
    const std::int64_t denominator = cross(along, other);
    return {s.a.x + rounded_ratio(along.x, numerator, denominator),
            s.a.y + rounded_ratio(along.y, numerator, denominator)};
}

// Whether the segment meets the half open pixel around p. The segment's ends are pixel centres,
// so p lies in the segment's box; then it is enough that the pixel has corners strictly on both
// sides of the line, or that the line touches the one corner that belongs to the pixel.
bool passes_pixel(const GridSegment& s, GridPoint p) {
    const auto [x0, x1] = std::minmax(s.a.x, s.b.x);
    const auto [y0, y1] = std::minmax(s.a.y, s.b.y);
    if (p.x < x0 || p.x > x1 || p.y < y0 || p.y > y1) return false;
    const GridVector d = s.b - s.a;
    const std::int64_t centre = 2 * cross(d, p - s.a);
    return std::abs(centre) < std::abs(d.x) + std::abs(d.y) || centre == d.x - d.y;
}

std::uint64_t packed(GridPoint p) {
    return static_cast<std::uint64_t>(p.x + kGridLimit) << 32 |
           static_cast<std::uint32_t>(p.y + kGridLimit);
}

GridPoint unpacked(std::uint64_t key) {
    return {static_cast<std::int32_t>(key >> 32) - kGridLimit,
            static_cast<std::int32_t>(key & 0xffffffffu) - kGridLimit};
}

std::vector<GridPoint> find_nodes(std::span<const GridSegment> segments,
                                  const NeighbourGroups& groups) {
    auto keys = groups.gather<std::uint64_t>(
        [&](std::span<const std::uint32_t> near, auto, std::vector<std::uint64_t>& found) {
            for (std::size_t i = 0; i < near.size(); ++i) {
                for (std::size_t j = i + 1; j < near.size(); ++j) {
                    const GridSegment& s = segments[near[i]];
                    const GridSegment& t = segments[near[j]];
                    if (cross_properly(s, t)) found.push_back(packed(rounded_crossing(s, t)));
                }
            }
        });
    for (const GridSegment& s : segments)
        keys.push_back(packed(s.a)), keys.push_back(packed(s.b));
    sort_all(keys, std::less<>());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<GridPoint> nodes(keys.size());
    std::transform(keys.begin(), keys.end(), nodes.begin(), unpacked);
    return nodes;
}

// A node on a segment, and how far along.
struct Stop {
    std::uint32_t segment = 0, node = 0;
    std::int64_t along = 0;
};

// All stops, by segment and along it. Along a segment pixels follow each other in x and in y, so
// their centres are in order along its direction, without ties.
std::vector<Stop> find_stops(std::span<const GridSegment> segments,
                             std::span<const GridPoint> nodes, const NeighbourGroups& groups) {
    const auto found =
        groups.gather<Stop>([&](std::span<const std::uint32_t> near,
                                std::span<const std::uint32_t> points, std::vector<Stop>& stops) {
            for (const std::uint32_t i : near) {
                const GridSegment& s = segments[i];
                for (const std::uint32_t node : points) {
                    if (passes_pixel(s, nodes[node]))
                        stops.push_back({i, node, dot(s.b - s.a, nodes[node] - s.a)});
                }
            }
        });
    std::vector<std::uint32_t> first(segments.size() + 2, 0);
    for (const Stop& stop : found)
        ++first[stop.segment + 2];
    for (std::size_t i = 1; i < first.size(); ++i)
        first[i] += first[i - 1];
    std::vector<Stop> stops(found.size());
    for (const Stop& stop : found)
        stops[first[stop.segment + 1]++] = stop;
    for_each_index(segments.size(), 20'000, [&](std::size_t i) {
        std::sort(stops.begin() + first[i], stops.begin() + first[i + 1],
                  [](const Stop& a, const Stop& b) { return a.along < b.along; });
    });
    return stops;
}

struct Passage {
    std::uint64_t edge = 0;  // from << 32 | to
    EdgeUse use;
};

std::vector<Passage> find_passages(std::span<const Stop> stops) {
    std::vector<Passage> passages;
    passages.reserve(stops.size());
    for (std::size_t i = 1; i < stops.size(); ++i) {
        if (stops[i].segment != stops[i - 1].segment) continue;
        const std::uint32_t a = stops[i - 1].node, b = stops[i].node;
        passages.push_back({static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b),
                            {stops[i].segment, a < b}});
    }
    sort_all(passages, [](const Passage& p, const Passage& q) {
        return p.edge != q.edge ? p.edge < q.edge : p.use.segment < q.use.segment;
    });
    return passages;
}

}  // namespace

Arrangement snap_round(std::span<const GridSegment> segments) {
    Arrangement result;
    NeighbourGroups groups(segments);
    result.nodes = find_nodes(segments, groups);
    groups.add_points(result.nodes);
    const std::vector<Passage> passages = find_passages(find_stops(segments, result.nodes, groups));
    result.uses.reserve(passages.size());
    for (std::size_t i = 0; i < passages.size(); ++i) {
        if (i == 0 || passages[i].edge != passages[i - 1].edge) {
            result.first_use.push_back(static_cast<std::uint32_t>(i));
            result.edges.push_back({static_cast<std::uint32_t>(passages[i].edge >> 32),
                                    static_cast<std::uint32_t>(passages[i].edge & 0xffffffffu)});
        }
        result.uses.push_back(passages[i].use);
    }
    result.first_use.push_back(static_cast<std::uint32_t>(passages.size()));
    return result;
}

}  // namespace edaha
