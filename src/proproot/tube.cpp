// SPDX-License-Identifier: MIT
#include "proproot/tube.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "base/stable_math.h"

namespace edaha {
namespace {

Vec3 reflected(Vec3 v, Vec3 across) {
    return v - across * (2 * glm::dot(across, v) / glm::dot(across, across));
}

// A unit vector square to this one.
Vec3 any_square_to(Vec3 normal) {
    const Vec3 other = std::abs(normal.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    return glm::normalize(glm::cross(other, normal));
}

// The side of the next circle that carries on this one's.
Vec3 carried(Vec3 side, const TubeCircle& from, const TubeCircle& to) {
    const Vec3 way = to.centre - from.centre;
    const Vec3 normal = reflected(from.normal, way);
    side = reflected(side, way);
    const Vec3 rest = to.normal - normal;
    if (glm::dot(rest, rest) > 1e-24) side = reflected(side, rest);
    // Square again, lest errors add up.
    return glm::normalize(side - to.normal * glm::dot(side, to.normal));
}

class TubeMaker {
  public:
    TubeMaker(Mesh& mesh, std::span<const TubeCircle> circles, const TubeParams& params)
        : mesh_(mesh),
          circles_(circles),
          params_(params),
          rings_(circles.size() - (params.pointed ? 1 : 0)),
          part_(static_cast<std::uint32_t>(mesh.parts.size())),
          first_(static_cast<std::uint32_t>(mesh.points.size())) {}

    void run() {
        add_points();
        for (std::size_t ring = 0; ring + 1 < rings_; ++ring)
            join(ring);
        const std::uint32_t end = point(rings_, 0);
        for (int j = 0; j < params_.points; ++j) {
            add({end, point(0, j + 1), point(0, j)}, {uv(0, j + 0.5), uv(0, j + 1), uv(0, j)});
            add({end + 1, point(rings_ - 1, j), point(rings_ - 1, j + 1)},
                {uv(circles_.size() - 1, j + 0.5), uv(rings_ - 1, j), uv(rings_ - 1, j + 1)});
        }
    }

  private:
    void add_points() {
        Vec3 side = any_square_to(circles_[0].normal);
        for (std::size_t i = 0; i < rings_; ++i) {
            if (i > 0) side = carried(side, circles_[i - 1], circles_[i]);
            const bool cut = params_.grounded && i + 1 == rings_;
            const Vec3 other = glm::cross(circles_[i].normal, side);
            for (int j = 0; j < params_.points; ++j) {
                const auto [sine, cosine] =
                    stable::sin_cos(2 * std::numbers::pi * j / params_.points);
                Vec3 offset = (side * cosine + other * sine) * circles_[i].radius;
                if (cut) {  // along the tube onto the ground
                    const Vec3 down = circles_[i].normal;
                    offset -= down * (offset.y / down.y);
                    offset.y = 0;
                }
                mesh_.points.push_back(circles_[i].centre + offset);
            }
        }
        mesh_.points.push_back(circles_.front().centre);
        mesh_.points.push_back(circles_.back().centre);
    }

    void join(std::size_t ring) {
        for (int j = 0; j < params_.points; ++j) {
            const glm::dvec2 a = uv(ring, j), b = uv(ring, j + 1);
            const glm::dvec2 c = uv(ring + 1, j), d = uv(ring + 1, j + 1);
            add({point(ring, j), point(ring, j + 1), point(ring + 1, j)}, {a, b, c});
            add({point(ring, j + 1), point(ring + 1, j + 1), point(ring + 1, j)}, {b, d, c});
        }
    }

    std::uint32_t point(std::size_t ring, int j) const {
        return first_ +
               static_cast<std::uint32_t>(ring) * static_cast<std::uint32_t>(params_.points) +
               static_cast<std::uint32_t>(j % params_.points);
    }

    glm::dvec2 uv(std::size_t circle, double j) const {
        return {params_.round * j / params_.points, circles_[circle].along};
    }

    void add(Triangle triangle, std::array<glm::dvec2, 3> corners) {
        mesh_.triangles.push_back(triangle);
        mesh_.uv.push_back(corners);
        mesh_.part_of.push_back(part_);
    }

    Mesh& mesh_;
    std::span<const TubeCircle> circles_;
    const TubeParams& params_;
    std::size_t rings_;
    std::uint32_t part_, first_;
};

}  // namespace

void add_tube(Mesh& mesh, MeshPart part, std::span<const TubeCircle> circles,
              const TubeParams& params) {
    TubeMaker(mesh, circles, params).run();
    mesh.parts.push_back(std::move(part));
}

}  // namespace edaha
