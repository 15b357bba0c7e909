// SPDX-License-Identifier: MIT
#include "surface/close_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "surface/crossings.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 2000;
constexpr double kForEver = std::numeric_limits<double>::infinity();

// How far a vertex may come forward along an axis, and back: `high` is not below 0, `low` not
// above.
struct Extent {
    double low, high;
};

Extent reach_of(const StepPlan& plan, std::uint32_t v, const Vec3& axis) {
    const double by = glm::dot(plan.growth[v], axis), aside = glm::dot(plan.slides[v], axis);
    return {std::min(0.0, by) + std::min(0.0, aside), std::max(0.0, by) + std::max(0.0, aside)};
}

// How many steps a gap lasts that closes by so much in each.
double lasting(double gap, double closing) {
    if (gap <= 0) return 0;
    return closing > 0 ? gap / closing : kForEver;
}

struct SharedCorner {
    std::size_t first = 3, second = 3;  // which of either face
    int count = 0;
};

SharedCorner shared_corner(const GrowingMesh& mesh, const FacePair& pair) {
    SharedCorner shared;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (mesh.origin[3 * pair[0] + i] != mesh.origin[3 * pair[1] + k]) continue;
            shared = {i, k, shared.count + 1};
        }
    }
    return shared;
}

// Two faces as seen from the corner that they share: the other corners of the first one as they
// are, those of the second mirrored. A plane through that corner is between the faces if all four
// are on one side of it.
struct RoundCorner {
    std::uint32_t middle = 0;
    std::array<std::uint32_t, 4> corners{};
    std::array<Vec3, 4> at{};
};

RoundCorner round_corner(const GrowingMesh& mesh, const FacePair& pair,
                         const SharedCorner& shared) {
    RoundCorner around{mesh.origin[3 * pair[0] + shared.first], {}, {}};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t from = i < 2 ? shared.first : shared.second;
        around.corners[i] = mesh.origin[3 * pair[i / 2] + (from + 1 + i % 2) % 3];
        const Vec3 off = mesh.position[around.corners[i]] - mesh.position[around.middle];
        around.at[i] = i < 2 ? off : -off;
    }
    return around;
}

double steps_before_split(const RoundCorner& around, const StepPlan& plan, const Vec3& square) {
    const double length = glm::length(square);
    if (length < 1e-9) return 0;
    const Vec3 axis = square / length;
    const Extent own = reach_of(plan, around.middle, axis);
    double steps = kForEver;
    for (std::size_t i = 0; i < 4; ++i) {
        const Extent reach = reach_of(plan, around.corners[i], axis);
        const double closing = i < 2 ? own.high - reach.low : reach.high - own.low;
        steps = std::min(steps, lasting(glm::dot(around.at[i], axis), closing));
    }
    return steps;
}

// The plane that is furthest from all four is square to the way to what is nearest of the
// tetrahedron between them.
double steps_round(const RoundCorner& around, const StepPlan& plan, double enough) {
    Vec3 sum(0), nearest(1e9);
    for (const Vec3& at : around.at)
        sum += at;
    const double steps = steps_before_split(around, plan, sum);
    if (steps >= enough) return steps;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 found =
            nearest_point({around.at[i], around.at[(i + 1) % 4], around.at[(i + 2) % 4]}, Vec3(0));
        if (glm::dot(found, found) < glm::dot(nearest, nearest)) nearest = found;
    }
    return std::max(steps, steps_before_split(around, plan, nearest));
}

// Where a face is along an axis, and how much wider it may get there in a step.
struct FaceExtent {
    Extent at, more;
};

FaceExtent extent_of(const GrowingMesh& mesh, const StepPlan& plan, std::uint32_t f,
                     const Vec3& axis) {
    FaceExtent extent{{kForEver, -kForEver}, {0, 0}};
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.origin[3 * f + k];
        const double at = glm::dot(mesh.position[v], axis);
        const Extent reach = reach_of(plan, v, axis);
        extent.at = {std::min(extent.at.low, at), std::max(extent.at.high, at)};
        extent.more = {std::min(extent.more.low, reach.low),
                       std::max(extent.more.high, reach.high)};
    }
    return extent;
}

double steps_between(const GrowingMesh& mesh, const StepPlan& plan, const FacePair& pair,
                     const Vec3& axis) {
    const FaceExtent one = extent_of(mesh, plan, pair[0], axis),
                     other = extent_of(mesh, plan, pair[1], axis);
    return std::max(lasting(one.at.low - other.at.high, other.more.high - one.more.low),
                    lasting(other.at.low - one.at.high, one.more.high - other.more.low));
}

Vec3 middle_of(const GrowingMesh& mesh, std::uint32_t f) {
    return (mesh.position[mesh.origin[3 * f]] + mesh.position[mesh.origin[3 * f + 1]] +
            mesh.position[mesh.origin[3 * f + 2]]) /
           3.0;
}

FaceBox box_of_way(const GrowingMesh& mesh, const StepPlan& plan, std::uint32_t f, double more_mm) {
    Vec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.origin[3 * f + k];
        const Vec3 &here = mesh.position[v], &by = plan.growth[v], &aside = plan.slides[v];
        low = glm::min(low, here + glm::min(by, Vec3(0)) + glm::min(aside, Vec3(0)));
        high = glm::max(high, here + glm::max(by, Vec3(0)) + glm::max(aside, Vec3(0)));
    }
    return box_round(low - more_mm, high + more_mm);
}

// The fastest of its corners, in mm a step.
double speed_of(const GrowingMesh& mesh, std::span<const Vec3> moves, std::uint32_t f) {
    double most = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const Vec3& move = moves[mesh.origin[3 * f + k]];
        most = std::max(most, glm::dot(move, move));
    }
    return std::sqrt(most);
}

// What was close before and whose first face rests: looked at again when it may no longer be clear.
std::vector<ClosePair> still_close(const GrowingMesh& mesh, const StepPlan& plan,
                                   std::span<const ClosePair> before) {
    constexpr double kEnough = 8;
    return gather<ClosePair>(before.size(), [&](std::size_t i, std::vector<ClosePair>& found) {
        ClosePair pair = before[i];
        const auto [f, g] = pair.faces;
        if (std::max(f, g) >= mesh.face_rest.size() || !mesh.is_face(f) || !mesh.is_face(g) ||
            mesh.face_rest[f] == 0)
            return;
        if (pair.clear > 1 && mesh.face_rest[g] > 0)
            --pair.clear;
        else
            pair.clear = static_cast<std::uint8_t>(
                std::min(kEnough, clear_steps(mesh, plan, pair.faces, kEnough)));
        found.push_back(pair);
    });
}

}  // namespace

std::vector<FaceBox> boxes_of_ways(const GrowingMesh& mesh, const StepPlan& plan, double more_mm) {
    std::vector<FaceBox> boxes(mesh.origin.size() / 3);
    for_each_index(boxes.size(), kWorthThreads, [&](std::size_t i) {
        const auto f = static_cast<std::uint32_t>(i);
        if (mesh.is_face(f)) boxes[i] = box_of_way(mesh, plan, f, more_mm);
    });
    return boxes;
}

double clear_steps(const GrowingMesh& mesh, const StepPlan& plan, const FacePair& pair,
                   double enough) {
    const SharedCorner shared = shared_corner(mesh, pair);
    if (shared.count > 1) return kForEver;
    if (shared.count == 1) return steps_round(round_corner(mesh, pair, shared), plan, enough);
    const Vec3 way = middle_of(mesh, pair[0]) - middle_of(mesh, pair[1]);
    const double length = glm::length(way);
    double steps = length > 0 ? steps_between(mesh, plan, pair, way / length) : 0;
    for (const std::uint32_t f : pair)
        if (steps < enough)
            steps = std::max(steps, steps_between(mesh, plan, pair, plan.of_faces[f]));
    return steps;
}

std::uint8_t steps_of_rest(double free_mm, double speed_mm, const RestParams& params) {
    constexpr double kMost = 12;
    if (free_mm <= 0) return 0;
    return static_cast<std::uint8_t>(std::min(kMost, free_mm / (speed_mm + params.fast_mm)));
}

void wake_fast(GrowingMesh& mesh, std::span<const Vec3> growth, double fast_mm) {
    const auto is_fast = [&](std::uint32_t v) {
        return glm::dot(growth[v], growth[v]) > fast_mm * fast_mm;
    };
    for_each_index(mesh.vertex_rest.size(), kWorthThreads, [&](std::size_t v) {
        if (is_fast(static_cast<std::uint32_t>(v))) mesh.vertex_rest[v] = 0;
    });
    for_each_index(mesh.face_rest.size(), kWorthThreads, [&](std::size_t f) {
        const std::uint32_t* v = &mesh.origin[3 * f];
        if (mesh.face_rest[f] > 0 && (is_fast(v[0]) || is_fast(v[1]) || is_fast(v[2])))
            mesh.face_rest[f] = 0;
    });
}

std::vector<ClosePair> close_faces(GrowingMesh& mesh, const StepPlan& plan, const FaceGrid& grid,
                                   const CloseParams& params) {
    constexpr std::size_t kChunk = 64;  // faces look at dozens of others each
    const auto is_awake = [&](std::uint32_t f) {
        return params.is_watched[f] != 0 && mesh.face_rest[f] == 0;
    };
    const std::vector<std::uint32_t> awake = gather<std::uint32_t>(
        mesh.origin.size() / 3, [&](std::size_t f, std::vector<std::uint32_t>& found) {
            if (is_awake(static_cast<std::uint32_t>(f)))
                found.push_back(static_cast<std::uint32_t>(f));
        });
    std::vector<std::uint8_t> rests(awake.size(), 0);
    const auto look = [&](std::size_t i, std::vector<ClosePair>& found) {
        const std::uint32_t f = awake[i];
        const double growth = speed_of(mesh, plan.growth, f);
        const double more = growth > params.rest.fast_mm ? 0 : params.rest.horizon_mm;
        rests[i] = steps_of_rest(more, growth + speed_of(mesh, plan.slides, f), params.rest);
        const double enough = rests[i] + 1.0;
        const FaceBox box = box_of_way(mesh, plan, f, more);
        grid.visit(box, [&](std::uint32_t g) {
            if (g == f || (g < f && is_awake(g)) || !box.meets(params.boxes[g])) return;
            const double steps = clear_steps(mesh, plan, {f, g}, enough);
            if (steps <= enough) found.push_back({{f, g}, static_cast<std::uint8_t>(steps)});
        });
    };
    std::vector<ClosePair> pairs = gather<ClosePair>(awake.size(), look, kChunk);
    const std::vector<ClosePair> kept = still_close(mesh, plan, params.before);
    pairs.insert(pairs.end(), kept.begin(), kept.end());
    for (std::uint8_t& rest : mesh.face_rest)
        rest -= rest > 0;
    for (std::size_t i = 0; i < awake.size(); ++i)
        mesh.face_rest[awake[i]] = rests[i];
    return pairs;
}

std::vector<FacePair> closest(std::span<const ClosePair> pairs) {
    std::vector<FacePair> found;
    for (const ClosePair& pair : pairs)
        if (pair.clear == 0) found.push_back(pair.faces);
    return found;
}

}  // namespace edaha
