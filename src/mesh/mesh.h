// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/colour.h"

namespace edaha {

using Vec3 = glm::dvec3;

struct Material {
    std::string name;
    std::optional<Colour> colour;  // the palette's if there is none
};

// The middle line of a straight part, for its normals: see FlattenParams::axis_normals.
struct Axis {
    Vec3 from{0}, to{0};
};

// What a designer would call one thing: a prism, a root, a grown branch, a group of a file.
struct MeshPart {
    std::string name;         // unique among the parts: "root-3-1"
    std::uint32_t order = 0;  // of branching; the trunk has 0
    std::int32_t parent = -1;
    std::uint32_t material = 0;
    std::optional<Axis> axis;
};

// A place for a twig with leaves: it leaves the surface in `direction` (of length 1).
struct SprigSite {
    Vec3 position{0};
    Vec3 direction{0, 1, 0};
    double size = 1;  // in units of the mesh
    std::uint32_t part = 0;
};

using Triangle = std::array<std::uint32_t, 3>;

// Triangles in space, between the 3D models (or a file) and flatten(). Right-handed, y up, any
// unit. A triangle's points run counter-clockwise seen from outside. Points belong to one part:
// parts that touch share none, so that closed parts stay closed (validate() in mesh_check.h). Only
// where the parts divide one closed surface among them do they share the points between.
struct Mesh {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> part_of;         // a triangle: index into parts
    std::vector<std::array<glm::dvec2, 3>> uv;  // a triangle's corners; empty if there is none
    std::vector<MeshPart> parts;
    std::vector<Material> materials;
    std::vector<SprigSite> sites;
};

}  // namespace edaha
