// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "prism/interference.h"
#include "solids.h"

namespace edaha {
namespace {

double any_number(int most) {
    return *rc::gen::inRange(-1000 * most, 1000 * most + 1) / 1000.0;
}

// Zeros and equal components are as likely as any other.
Vec3 any_direction() {
    const auto part = [] {
        return *rc::gen::inRange(0, 2) == 0 ? *rc::gen::inRange(-1, 2) : any_number(5);
    };
    for (;;) {
        const Vec3 g(part(), part(), part());
        if (glm::length(g) > 0) return g;
    }
}

Section any_section() {
    const Section section{{Vec2(any_number(3), any_number(3)), Vec2(any_number(3), any_number(3)),
                           Vec2(any_number(3), any_number(3))}};
    const Section turned{{section.corners[0], section.corners[2], section.corners[1]}};
    const Section positive = area(section) > 0 ? section : turned;
    RC_PRE(area(positive) > 0.01);
    return moved(positive, -centroid(positive));
}

Prism any_prism() {
    Prism prism;
    prism.base = any_section();
    prism.frame = paper_frame(any_direction());
    prism.origin = Vec3(any_number(4), any_number(4), any_number(4));
    prism.length = 0.5 + std::abs(any_number(5));
    prism.top = *rc::gen::inRange(0, 11) / 10.0;
    prism.corners = open_corners(prism);
    return prism;
}

bool is_rotation(const Mat3& m) {
    const Vec3 lengths(glm::length(m[0]), glm::length(m[1]), glm::length(m[2]));
    return glm::distance(lengths, Vec3(1)) < 1e-12 &&
           glm::distance(glm::cross(m[0], m[1]), m[2]) < 1e-12;
}

RC_GTEST_PROP(PrismProperty, PaperFrameTakesTheYAxisOntoAnyDirection, ()) {
    const Vec3 g = any_direction();
    const Mat3 frame = paper_frame(g);
    RC_ASSERT(is_rotation(frame));
    RC_ASSERT(glm::distance(frame[1], glm::normalize(g)) < 1e-12);
}

RC_GTEST_PROP(PrismProperty, ParallelFrameTurnsByTheAngleBetweenAndNoMore, ()) {
    const Mat3 from = paper_frame(any_direction());
    const Vec3 g = any_direction();
    const Mat3 frame = parallel_frame(from, g);
    RC_ASSERT(is_rotation(frame));
    RC_ASSERT(glm::distance(frame[1], glm::normalize(g)) < 1e-12);
    // The angle of a rotation from its trace: 1 + 2 cos.
    const Mat3 turn = frame * glm::transpose(from);
    const double cosine = (turn[0].x + turn[1].y + turn[2].z - 1) / 2;
    RC_ASSERT(std::abs(cosine - glm::dot(from[1], frame[1])) < 1e-9);
}

RC_GTEST_PROP(PrismProperty, HalvesFillTheWhole, ()) {
    const Section whole = any_section();
    const double at = *rc::gen::inRange(1, 100) / 100.0;
    const Halves halves = halve(whole, longest_side(whole), at);
    const double a = area(halves.a), b = area(halves.b);
    RC_ASSERT(a > 0 && b > 0);
    RC_ASSERT(std::abs(a + b - area(whole)) < 1e-9);
    RC_ASSERT(glm::length(centroid(halves.a)) < 1e-12);
    RC_ASSERT(glm::length(centroid(halves.b)) < 1e-12);
    // Centroids balance about the whole's, which is the origin.
    RC_ASSERT(glm::length(a * halves.centre_a + b * halves.centre_b) < 1e-9);
}

RC_GTEST_PROP(PrismProperty, OverlapAgreesWithSeparatingAxes, ()) {
    const Prism a = any_prism(), b = any_prism();
    const double gap = oracles::gap(a.corners, b.corners);
    RC_PRE(std::abs(gap) > 1e-4);
    RC_ASSERT(overlap(a.corners, b.corners) == (gap < 0));
    RC_ASSERT(overlap(b.corners, a.corners) == (gap < 0));
}

// Bent sides count as flat ones outside of them: none that reach into each other are missed.
RC_GTEST_PROP(PrismProperty, NoOverlapOfWeldedPrismsIsMissed, ()) {
    Prism a = any_prism(), b = any_prism();
    b.origin = a.origin + 0.3 * b.origin;  // else few would meet
    for (Prism* prism : {&a, &b}) {
        Prism parent = *prism;
        parent.frame = paper_frame(any_direction());
        prism->corners = welded_corners(*prism, parent);
    }
    // A flat one, welded to a parent in its own plane, has no inner points.
    RC_PRE(std::max(oracles::gap(a.corners, a.corners), oracles::gap(b.corners, b.corners)) <
           -0.01);
    RC_PRE(oracles::gap(a.corners, b.corners) < -1e-4);
    RC_ASSERT(overlap(a.corners, b.corners));
}

RC_GTEST_PROP(PrismProperty, MitredPrismsKeepFlatSides, ()) {
    const Prism parent = any_prism();
    Prism prism = any_prism();
    prism.origin = parent.tip();
    const double cosine = glm::dot(prism.direction(), parent.direction());
    RC_PRE(cosine > 0.5);
    prism.corners = mitred_corners(prism, parent);
    // A flat side: the two ends of an edge of the top and those of the base lie in a plane.
    for (std::size_t i = 0; i < 3 && prism.top > 0; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Vec3 p = prism.corners[i];
        const double off = glm::dot(glm::cross(prism.corners[j] - p, prism.corners[i + 3] - p),
                                    prism.corners[j + 3] - p);
        RC_ASSERT(std::abs(off) < 1e-6);
    }
}

}  // namespace
}  // namespace edaha
