// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

#include "geometry/path.h"

namespace edaha {

// A prism's cross-section: a triangle in the xz plane of the branch's frame, y of a point here
// being z there. Its corners run counter-clockwise seen from the tip: from z to x.
struct Section {
    std::array<Vec2, 3> corners{};
};

double area(const Section& section);  // above 0 unless the corners run the other way
Vec2 centroid(const Section& section);
Section moved(Section section, Vec2 by);
Section scaled(Section section, double factor);  // about the origin

// Side i runs from corner i to the next. The first of several that are as long.
std::size_t longest_side(const Section& section);

// Uehara & Takai 6.2: cut from a point of a side to the opposite corner. Each half has its
// centroid in its own origin; the centres say where that lies in the whole.
struct Halves {
    Section a, b;
    Vec2 centre_a{0}, centre_b{0};
};

// `at` in (0, 1): the cut's place along the side; 0.5 is the paper's. O(1).
Halves halve(const Section& section, std::size_t side, double at);

// With the centroid in the origin. Equilateral: corner 0 lies on +z. By three sides: side a (from
// corner 0 to 1) along +x. Sides that close no triangle give a flat one.
Section equilateral(double radius);
Section by_sides(double a, double b, double c);

}  // namespace edaha
