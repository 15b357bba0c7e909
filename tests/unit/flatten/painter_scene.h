// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "flatten/labelled_map.h"
#include "mesh/mesh.h"

namespace edaha::scenes {

// Flat cards lying over each other, the last on top: what a mesh is to flatten(), without rays.
struct Card {
    std::vector<Vec2> corners;  // in pixels, y down, any orientation
    std::uint32_t part = 0;
    std::uint8_t tone = 0;
};

// What is seen at a point by painting: the label of the topmost card around it.
FaceLabel seen_at(std::span<const Card> cards, Vec2 p);

// The scene's map with every edge of every card, hidden or not, as label_map() would make it:
// silhouettes against the background, contours between parts, tones within one.
LabelledMap map_of(std::span<const Card> cards);

// Parts "part-0", "part-1" ... for as many as the cards name, all of material 0.
std::vector<MeshPart> parts_of(std::span<const Card> cards);

std::vector<Vec2> rectangle(Vec2 min, Vec2 max);
std::vector<Vec2> ellipse(Vec2 centre, Vec2 radii, int corners);
// A straight bar of some width with square ends.
std::vector<Vec2> bar(Vec2 from, Vec2 to, double width);

// `count` bars, ellipses and triangles of all sizes in a field of `side` pixels, each a part of its
// own with one to three tones.
std::vector<Card> random_scene(int count, double side, std::uint64_t seed);

}  // namespace edaha::scenes
