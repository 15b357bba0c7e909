// SPDX-License-Identifier: MIT
// What each number of the paper does to a trunk: more of it, more of that.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "surface/move.h"
#include "unit/surface/grown.h"

namespace edaha {
namespace {

std::vector<Vec3> vertices(const SurfaceGrowth& growth,
                           const std::function<bool(std::uint32_t)>& wanted) {
    std::vector<Vec3> places;
    const GrowingMesh& mesh = growth.mesh();
    for (std::uint32_t v = 0; v < mesh.position.size(); ++v)
        if (mesh.is_vertex(v) && wanted(v)) places.push_back(mesh.position[v]);
    return places;
}

std::vector<Vec3> vertices(const SurfaceGrowth& growth) {
    return vertices(growth, [](std::uint32_t) { return true; });
}

double distance_from_axis(const Vec3& p) {
    return std::hypot(p.x, p.z);
}

SurfaceParams with_burl(double strength, double radius_mm) {
    SurfaceParams params = trunk(60);
    BurlPlace burl;
    burl.height_mm = 1200;
    burl.strength = strength;
    burl.radius_mm = radius_mm;
    burl.from = 22;
    params.burls.push_back(burl);
    return params;
}

double burl_height(const SurfaceGrowth& growth) {
    double most = 0;
    for (const Vec3& p : vertices(growth))
        if (std::abs(p.y - 1200) < 250) most = std::max(most, distance_from_axis(p));
    return most;
}

TEST(Responses, BurlsRiseWithTheirStrength) {
    double before = burl_height(grown(with_burl(0, 300)));
    for (const double strength : {0.5, 1.0, 2.0, 3.0}) {
        const double height = burl_height(grown(with_burl(strength, 300)));
        EXPECT_GT(height, before + 10) << strength;
        before = height;
    }
}

// How far up and down the trunk is thicker than without a burl.
double burl_width(const SurfaceGrowth& growth, const SurfaceGrowth& plain) {
    const auto profile = [](const SurfaceGrowth& of) {
        std::vector<double> widest(48, 0);
        for (const Vec3& p : vertices(of)) {
            const auto i = static_cast<std::size_t>(p.y / 50);
            if (p.y >= 0 && i < widest.size())
                widest[i] = std::max(widest[i], distance_from_axis(p));
        }
        return widest;
    };
    const std::vector<double> with = profile(growth), without = profile(plain);
    double width = 0;
    for (std::size_t i = 0; i < with.size(); ++i)
        if (with[i] > 0 && without[i] > 0 && with[i] > without[i] + 25) width += 50;
    return width;
}

TEST(Responses, BurlsWidenWithTheirRadius) {
    const SurfaceGrowth plain = grown(with_burl(0, 300));
    double before = 0;
    for (const double radius : {250.0, 400.0, 600.0, 900.0}) {
        const double width = burl_width(grown(with_burl(1.5, radius)), plain);
        EXPECT_GT(width, before) << radius;
        before = width;
    }
}

// Turns of all lines of phloem about the axis, on average.
double twist(const SurfaceGrowth& growth) {
    const GrowingMesh& mesh = growth.mesh();
    double turned = 0;
    for (std::uint32_t v = 0; v < mesh.position.size(); ++v) {
        const std::uint32_t up = mesh.is_vertex(v) ? mesh.phloem_up[v] : kNone;
        if (up == kNone || mesh.tissue[up] == Tissue::apex) continue;
        const Vec3 p = mesh.position[v], q = mesh.position[up];
        turned += std::atan2(p.z * q.x - p.x * q.z, p.x * q.x + p.z * q.z);
    }
    return turned;
}

TEST(Responses, PhloemTwistsWithItsRate) {
    double before = 0;
    for (const double rate : {0.0, 0.0002, 0.0004, 0.0008}) {
        SurfaceParams params = trunk(60);
        params.winding_rad = rate;
        const double turned = twist(grown(params));
        EXPECT_TRUE(rate == 0 || turned > 1.3 * before) << turned;
        before = turned;
    }
}

SurfaceParams with_hollow() {
    SurfaceParams params = trunk(60);
    params.steps = 70;
    params.thickening_mm = 8;
    SolidParams hollow;
    hollow.shape = SolidShape::ball;
    hollow.from = {0, 1200, 260};
    hollow.radius_mm = 200;
    hollow.step = 40;
    params.hollows.push_back(hollow);
    return params;
}

bool is_xylem(const SurfaceGrowth& growth, std::uint32_t v) {
    return growth.mesh().tissue[v] == Tissue::xylem;
}

TEST(Responses, HollowsDeepenWithTheirRate) {
    double before = 1e9;  // the distance of the deepest wood from the axis
    for (const double rate : {1.0, 2.0, 3.0}) {
        SurfaceParams params = with_hollow();
        params.decay_mm = rate;
        const SurfaceGrowth growth = grown(params);
        const std::vector<Vec3> wood =
            vertices(growth, [&](std::uint32_t v) { return is_xylem(growth, v); });
        ASSERT_FALSE(wood.empty());
        double deepest = 1e9;
        for (const Vec3& p : wood)
            deepest = std::min(deepest, p.z);
        EXPECT_LT(deepest, before - 15) << rate;
        before = deepest;
    }
}

// The area of the faces of bare wood that still show: what cambium has grown over is gone from it.
double bare_area(const SurfaceGrowth& growth) {
    const GrowingMesh& mesh = growth.mesh();
    double low = 1e9, high = -1e9, left = 1e9, right = -1e9;
    for (std::uint32_t h = 0; h < mesh.origin.size(); ++h) {
        if (mesh.origin[h] == kNone || mesh.tissue[mesh.origin[h]] != Tissue::cambium) continue;
        if (mesh.tissue[mesh.target(h)] != Tissue::xylem) continue;
        const Vec3& p = mesh.position[mesh.origin[h]];
        low = std::min(low, p.y), high = std::max(high, p.y);
        left = std::min(left, p.x), right = std::max(right, p.x);
    }
    return high > low ? (high - low) * (right - left) : 0;
}

TEST(Responses, WoundsCloseWithTheirTendency) {
    double before = 1e18;
    for (const double closing : {0.0, 0.15, 0.3}) {
        SurfaceParams params = with_hollow();
        params.decay_mm = 1;
        params.closing = closing;
        const double area = bare_area(grown(params));
        EXPECT_LT(area, before) << closing;
        before = area;
    }
}

SolidParams rod_at(double y, double z) {
    SolidParams rod;
    rod.from = {-2000, y, z};
    rod.to = {2000, y, z};
    rod.radius_mm = 60;
    return rod;
}

// Whether a place is within the tree: the solid angles of all faces add up to a full one.
bool is_within(const GrowingMesh& mesh, const Vec3& p) {
    double sum = 0;
    for (std::uint32_t f = 0; f < mesh.origin.size() / 3; ++f) {
        if (!mesh.is_face(f)) continue;
        const Vec3 a = mesh.position[mesh.origin[3 * f]] - p,
                   b = mesh.position[mesh.origin[3 * f + 1]] - p,
                   c = mesh.position[mesh.origin[3 * f + 2]] - p;
        const double u = glm::length(a), v = glm::length(b), w = glm::length(c);
        sum += std::atan2(glm::dot(a, glm::cross(b, c)),
                          u * v * w + glm::dot(a, b) * w + glm::dot(b, c) * u + glm::dot(c, a) * v);
    }
    return std::abs(sum) > std::numbers::pi;  // halves of the angles: 2 pi within
}

// The part of the rod's surface, before the trunk's middle, that has wood on it.
double covered_part(const SurfaceGrowth& growth, const SolidParams& rod) {
    constexpr int kRound = 24, kAlong = 9;
    constexpr double kLift_mm = 35;  // wood comes close, but does not touch everywhere
    int covered = 0;
    for (int i = 0; i < kRound; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / kRound;
        const Vec3 off(0, std::sin(angle), std::cos(angle));
        for (int j = 0; j < kAlong; ++j) {
            const Vec3 on(-200 + 50 * j, rod.from.y, rod.from.z);
            if (is_within(growth.mesh(), on + off * (rod.radius_mm + kLift_mm))) ++covered;
        }
    }
    return double(covered) / (kRound * kAlong);
}

// Of ten rods, since lips meet over one sooner or later by chance: a rod's part scatters by two
// hundredths, as much as B brings from 0 to 1.
TEST(Responses, RodsAreCoveredTheMoreTheyAreWrapped) {
    SurfaceParams params = trunk(125);
    params.thickening_mm = 4;
    for (int i = 0; i < 10; ++i)
        params.obstacles.push_back(rod_at(900 + 203 * i, (i % 2 == 0 ? 1 : -1) * (260 + 7 * i)));
    double first = 0, before = 0;
    for (const double wrapping : {0.0, 1.0, 2.0}) {
        params.wrapping = wrapping;
        const SurfaceGrowth growth = grown(params);
        double covered = 0;
        for (const SolidParams& rod : params.obstacles)
            covered += covered_part(growth, rod) / double(params.obstacles.size());
        EXPECT_GE(covered, before) << wrapping;
        before = covered;
        if (wrapping == 0) first = covered;
    }
    EXPECT_GT(before, first + 0.01);
}

// The many contacts along a rod are one burl: it goes along the rod at (1 + k) S_c at most.
TEST(Responses, ContactsAlongARodDoNotAddUp) {
    SurfaceParams params = trunk(100);
    params.thickening_mm = 4;
    params.obstacles.push_back(rod_at(1400, 300));
    SurfaceGrowth growth(params, KeyedRandom(1, 1, 1));
    const auto half_width = [&](std::int64_t steps) {
        while (growth.steps() < steps)
            growth.step();
        double most = 0;
        for (const Vec3& p : vertices(growth))
            if (std::abs(p.y - 1400) < 200) most = std::max(most, std::abs(p.x));
        return most;
    };
    const double before = half_width(110), after = half_width(160);
    EXPECT_GT(after, before);
    EXPECT_LT(after - before, 50 * (1 + params.contact_strength) * params.thickening_mm);
}

// Of a trunk that stands against a rod: how far the growth of what touches nothing points to what
// does beside it (eq. 10), on average.
TEST(Responses, LipsTurnToTheObstacleTheMoreTheyWrap) {
    SurfaceParams params = trunk(60);
    params.thickening_mm = 8;
    params.wrapping = 0;
    params.obstacles.push_back(rod_at(1400, 300));
    params.steps = 75;
    const SurfaceGrowth growth = grown(params);
    GrowingMesh mesh = growth.mesh();
    const std::vector<Vec3> normals = vertex_normals(mesh, face_normals(mesh));
    double before = 0;
    for (const double wrapping : {0.0, 0.5, 1.0, 2.0}) {
        params.wrapping = wrapping;
        GrowthFields fields(params, KeyedRandom(1, 1, 1));
        fields.begin(growth.steps(), mesh, growth.apices(), normals);
        std::vector<Vec3> free = fields.moves(mesh, growth.apices(), normals), stopped = free;
        fields.stop_at_obstacles(mesh, stopped);
        ASSERT_GT(fields.contacts(), 4U);
        const std::vector<Vec3> moves = fields.moves(mesh, growth.apices(), normals);
        double towards = 0;
        std::size_t lips = 0;
        for (std::uint32_t v = 0; v < mesh.position.size(); ++v) {
            if (!mesh.is_vertex(v) || stopped[v] != free[v]) continue;
            Vec3 way(0);
            mesh.for_each_out(v, [&](std::uint32_t h) {
                const std::uint32_t other = mesh.target(h);
                if (stopped[other] != free[other])
                    way += glm::normalize(mesh.position[other] - mesh.position[v]);
            });
            if (glm::length(way) < 0.1) continue;
            ++lips;
            towards += glm::dot(moves[v], glm::normalize(way));
        }
        ASSERT_GT(lips, 4U);
        if (wrapping > 0) {
            EXPECT_GT(towards / double(lips), before + 1) << wrapping;
        }
        before = towards / double(lips);
    }
}

}  // namespace
}  // namespace edaha
