// SPDX-License-Identifier: MIT
#include "surface/face_grid.h"

#include <set>

#include <gtest/gtest.h>

#include "base/keyed_random.h"
#include "block_meshes.h"

using namespace edaha;

namespace {

// With corners moved at random, on both sides of 0.
GrowingMesh rough_blocks() {
    GrowingMesh mesh = two_blocks(1);
    const KeyedRandom random(1, 2, 3);
    for (std::uint32_t v = 0; v < mesh.position.size(); ++v) {
        const auto number = [&](std::uint32_t i) { return random.uniform(v, 1, i) - 0.5; };
        mesh.position[v] += 90.0 * Vec3(number(0), number(1), number(2)) - Vec3(250, 1200, 250);
    }
    return mesh;
}

FaceBox box_of_face(const GrowingMesh& mesh, std::uint32_t f) {
    return box_round(mesh.position[mesh.origin[3 * f]], mesh.position[mesh.origin[3 * f + 1]],
                     mesh.position[mesh.origin[3 * f + 2]]);
}

}  // namespace

TEST(FaceGrid, FindsAllFacesOfABoxAndNoOthers) {
    const GrowingMesh mesh = rough_blocks();
    for (const double cell : {40.0, 150.0, 5000.0}) {
        const FaceGrid grid(mesh, cell);
        for (int i = -3; i < 3; ++i) {
            const FaceBox box = box_round(Vec3(100.0 * i, 37, -50), Vec3(100.0 * i + 80, 90, 60));
            std::multiset<std::uint32_t> found, expected;
            grid.visit(box, [&](std::uint32_t f) { found.insert(f); });
            for (std::uint32_t f = 0; f < mesh.origin.size() / 3; ++f)
                if (box_of_face(mesh, f).meets(box)) expected.insert(f);
            EXPECT_EQ(found, expected) << cell << " " << i;
        }
    }
}

TEST(FaceGrid, FindsEachPairOnce) {
    const GrowingMesh mesh = rough_blocks();
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    const FaceGrid grid(mesh, 120);
    for (std::size_t bucket = 0; bucket < grid.buckets(); ++bucket)
        grid.visit_pairs(
            bucket, [&](std::uint32_t f, std::uint32_t g) { found.insert(std::minmax(f, g)); });
    const auto faces = static_cast<std::uint32_t>(mesh.origin.size() / 3);
    for (std::uint32_t f = 0; f < faces; ++f)
        for (std::uint32_t g = f + 1; g < faces; ++g)
            if (box_of_face(mesh, f).meets(box_of_face(mesh, g))) expected.insert({f, g});
    EXPECT_GT(expected.size(), 500U);
    EXPECT_EQ(found, expected);
}

// Numbers may be higher than all that the grid has seen, and none may be given.
TEST(FaceGrid, FindsFacesByTheirNewNumbers) {
    FaceGrid grid(100, 5);
    const auto box_at = [](double x) { return box_round(Vec3(x, 0, 0), Vec3(x + 50, 50, 50)); };
    for (std::uint32_t f = 0; f < 4; ++f)
        grid.put(f, box_at(1000 * f));
    std::vector<std::uint32_t> number(2500, kNone);
    number[0] = 2400, number[1] = 0, number[3] = 7;
    grid.renumber(number);
    const auto found = [&](double x) {
        std::vector<std::uint32_t> faces;
        grid.visit(box_at(x), [&](std::uint32_t f) { faces.push_back(f); });
        return faces;
    };
    EXPECT_EQ(found(0), std::vector<std::uint32_t>{2400});
    EXPECT_EQ(found(1000), std::vector<std::uint32_t>{0});
    EXPECT_TRUE(found(2000).empty());
    EXPECT_EQ(found(3000), std::vector<std::uint32_t>{7});
    grid.put(2400, {});
    EXPECT_TRUE(found(0).empty());
}

// Faces that come, creep, jump and go: what is found is what a new grid finds, and with slack no
// less than that.
TEST(FaceGrid, FollowsFacesThatChange) {
    const KeyedRandom random(4, 5, 6);
    constexpr std::uint32_t kFaces = 2000;
    std::vector<FaceBox> boxes(kFaces);
    FaceGrid grid(120, 0), slack(120, 15);
    for (std::uint32_t round = 0; round < 8; ++round) {
        for (std::uint32_t f = 0; f < kFaces; ++f) {
            const auto number = [&](std::uint32_t i) { return random.uniform(f, round, i); };
            const bool is_gone = number(0) < 0.2, stays = number(1) < 0.5;
            if (is_gone) boxes[f] = {};
            if (is_gone || (stays && !boxes[f].empty())) continue;
            const Vec3 low = 900.0 * Vec3(number(2), number(3), number(4)) - 450.0;
            boxes[f] = box_round(low, low + 100.0 * Vec3(number(5), number(6), number(7)));
        }
        grid.put_all(boxes);
        slack.put_all(boxes);
        for (double x = -400; x < 400; x += 190) {
            const FaceBox box = box_round(Vec3(x, -100, -50), Vec3(x + 80, 90, 160));
            std::multiset<std::uint32_t> found, roughly, expected;
            grid.visit(box, [&](std::uint32_t f) { found.insert(f); });
            slack.visit(box, [&](std::uint32_t f) { roughly.insert(f); });
            for (std::uint32_t f = 0; f < kFaces; ++f)
                if (!boxes[f].empty() && boxes[f].meets(box)) expected.insert(f);
            EXPECT_EQ(found, expected) << round << " " << x;
            EXPECT_TRUE(
                std::includes(roughly.begin(), roughly.end(), expected.begin(), expected.end()));
            for (const std::uint32_t f : roughly)
                EXPECT_EQ(roughly.count(f), 1U);
        }
    }
}
