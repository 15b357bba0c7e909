// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>

namespace edaha {

using Vec2 = glm::dvec2;

// Affine map: columns (a b), (c d), (e f) as in SVG's matrix(a b c d e f). Names read
// target-from-source: page_from_leaf.
using Affine = glm::dmat3x2;

inline Vec2 transform(const Affine& target_from_source, Vec2 p) {
    return target_from_source[0] * p.x + target_from_source[1] * p.y + target_from_source[2];
}

// Applies `inner` first.
inline Affine compose(const Affine& outer, const Affine& inner) {
    const Vec2 x = outer[0] * inner[0].x + outer[1] * inner[0].y;
    const Vec2 y = outer[0] * inner[1].x + outer[1] * inner[1].y;
    return Affine(x, y, transform(outer, inner[2]));
}

enum class Verb : std::uint8_t { move, line, cubic, close };

// Absolute path of move, line, cubic and close. Points per verb: 1, 1, 3, 0. Every subpath starts
// with move. Units are the owner's: millimetres, y down, in a Drawing.
struct Path {
    std::vector<Verb> verbs;
    std::vector<Vec2> points;

    void move_to(Vec2 p) { add(Verb::move), points.push_back(p); }
    void line_to(Vec2 p) { add(Verb::line), points.push_back(p); }
    void cubic_to(Vec2 c1, Vec2 c2, Vec2 p) {
        add(Verb::cubic), points.insert(points.end(), {c1, c2, p});
    }
    void close() { add(Verb::close); }
    bool empty() const { return verbs.empty(); }

  private:
    void add(Verb verb) { verbs.push_back(verb); }
};

}  // namespace edaha
