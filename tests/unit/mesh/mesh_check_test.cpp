// SPDX-License-Identifier: MIT
#include "mesh/mesh_check.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "shapes.h"

namespace edaha {
namespace {

void turn(Mesh& mesh, std::size_t triangle) {
    std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

void drop(Mesh& mesh, std::size_t triangle) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
    mesh.part_of.erase(mesh.part_of.begin() + static_cast<std::ptrdiff_t>(triangle));
}

TEST(Validate, finds_nothing_wrong_with_closed_pieces) {
    Mesh mesh = test::box();
    test::add_box(mesh, "second", Vec3(0.5), Vec3(2));
    const MeshReport report = validate(mesh);
    EXPECT_TRUE(report.sound());
    EXPECT_EQ(report.pieces, 2U);
    EXPECT_TRUE(validate(test::torus(12, 8)).sound());
    EXPECT_GT(test::volume6(test::torus(12, 8)), 0);
}

TEST(Validate, counts_open_edges) {
    Mesh mesh = test::box();
    drop(mesh, 4);
    EXPECT_EQ(validate(mesh).lines(), std::vector<std::string>{"3 open edges"});
}

TEST(Validate, counts_turned_triangles_by_their_edges) {
    Mesh mesh = test::box();
    turn(mesh, 4);
    EXPECT_EQ(validate(mesh).lines(),
              std::vector<std::string>{"3 edges whose triangles face opposite ways"});
}

TEST(Validate, finds_pieces_inside_out) {
    Mesh mesh = test::box();
    test::add_box(mesh, "second", Vec3(2), Vec3(3));
    for (std::size_t t = 0; t < 12; ++t)
        turn(mesh, t);
    EXPECT_EQ(validate(mesh).lines(),
              std::vector<std::string>{"1 closed piece that is inside out"});
}

TEST(Validate, counts_edges_of_many_triangles) {
    Mesh mesh = test::box();
    mesh.points.emplace_back(-1, -1, 0.5);
    test::add_triangle(mesh, {0, 4, 8});
    const MeshReport report = validate(mesh);
    EXPECT_EQ(report.crowded_edges, 1U);
    EXPECT_EQ(report.open_edges, 2U);
}

TEST(Validate, counts_triangles_without_area_and_double_ones) {
    Mesh mesh = test::box();
    mesh.points.emplace_back(0, 0, 0.5);
    test::add_triangle(mesh, {0, 8, 4});
    const Triangle first = mesh.triangles[0];
    test::add_triangle(mesh, {first[1], first[2], first[0]});
    const MeshReport report = validate(mesh);
    EXPECT_EQ(report.flat_triangles, 1U);
    EXPECT_EQ(report.double_triangles, 1U);
}

TEST(Validate, leaves_broken_triangles_out) {
    Mesh mesh = test::box();
    mesh.points.emplace_back(0, std::numeric_limits<double>::quiet_NaN(), 0);
    test::add_triangle(mesh, {0, 1, 8});
    test::add_triangle(mesh, {0, 1, 99});
    EXPECT_EQ(validate(mesh).lines(),
              (std::vector<std::string>{"1 point that is not finite",
                                        "1 triangle with a point or part that does not exist"}));
}

TEST(Validate, counts_points_of_several_parts) {
    Mesh mesh = test::box();
    test::add_part(mesh, "half");
    for (std::size_t t = 0; t < 6; ++t)
        mesh.part_of[t] = 1;
    EXPECT_EQ(validate(mesh).shared_points, 8U);
}

TEST(Mend, turns_what_is_inside_out_or_turned) {
    EXPECT_TRUE(rc::check([] {
        Mesh mesh = test::torus(7, 5);
        const double volume = test::volume6(mesh);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (*rc::gen::arbitrary<bool>()) turn(mesh, t);
        }
        const Mesh mended = mend(mesh);
        RC_ASSERT(validate(mended).sound());
        RC_ASSERT(std::abs(test::volume6(mended) - volume) < 1e-9 * volume);
    }));
}

TEST(Mend, turns_open_pieces_as_most_triangles_are) {
    Mesh mesh = test::box();
    drop(mesh, 11);
    turn(mesh, 0);
    turn(mesh, 5);
    const Mesh mended = mend(mesh);
    turn(mesh, 0);
    turn(mesh, 5);
    EXPECT_EQ(mended.triangles, mesh.triangles);
}

TEST(Mend, gives_each_part_its_points) {
    Mesh mesh = test::box();
    test::add_part(mesh, "half");
    for (std::size_t t = 0; t < 6; ++t)
        mesh.part_of[t] = 1;
    const Mesh mended = mend(mesh);
    EXPECT_EQ(mended.points.size(), 16U);
    EXPECT_EQ(validate(mended).shared_points, 0U);
    EXPECT_NEAR(test::volume6(mended), 6, 1e-12);
}

TEST(Mend, leaves_broken_and_double_triangles_out) {
    Mesh mesh = test::box();
    const Mesh whole = mesh;
    mesh.points.emplace_back(std::numeric_limits<double>::infinity(), 0, 0);
    test::add_triangle(mesh, {0, 1, 8});
    test::add_triangle(mesh, {0, 1, 99});
    test::add_triangle(mesh, {5, 5, 1});
    test::add_triangle(mesh, mesh.triangles[3]);
    const Mesh mended = mend(mesh);
    EXPECT_EQ(mended.triangles, whole.triangles);
    EXPECT_EQ(mended.points, whole.points);
}

TEST(Mend, keeps_what_is_sound) {
    Mesh mesh = test::torus(9, 4);
    test::add_box(mesh, "box", Vec3(0), Vec3(2));
    mesh.uv.resize(mesh.triangles.size(), {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1)});
    const Mesh mended = mend(mesh);
    EXPECT_EQ(mended.points, mesh.points);
    EXPECT_EQ(mended.triangles, mesh.triangles);
    EXPECT_EQ(mended.uv, mesh.uv);
}

// Whatever it is given, it ends, and what can be mended is.
TEST(Mend, any_triangles) {
    EXPECT_TRUE(rc::check([] {
        Mesh mesh;
        test::add_part(mesh, "a");
        test::add_part(mesh, "b");
        for (int i = 0; i < 6; ++i)
            mesh.points.emplace_back(i % 2, i % 3, i);
        mesh.triangles = *rc::gen::container<std::vector<Triangle>>(
            rc::gen::container<Triangle>(rc::gen::inRange(0U, 7U)));
        mesh.part_of = *rc::gen::container<std::vector<std::uint32_t>>(mesh.triangles.size(),
                                                                       rc::gen::inRange(0U, 3U));
        const Mesh mended = mend(mesh);
        const MeshReport report = validate(mended);
        RC_ASSERT(report.missing_points == 0U);
        RC_ASSERT(report.shared_points == 0U);
        if (report.crowded_edges == 0) RC_ASSERT(report.inverted_pieces == 0U);
    }));
}

}  // namespace
}  // namespace edaha
