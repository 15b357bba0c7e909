// SPDX-License-Identifier: MIT
#include "flatten/view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "base/stable_math.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 20'000;

struct Box {
    Vec3 min{HUGE_VAL}, max{-HUGE_VAL};

    void include(Vec3 p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    Vec3 middle() const { return (min + max) * 0.5; }
};

Box box_of(std::span<const Vec3> points) {
    Box box;
    for (const Vec3& p : points)
        box.include(p);
    return box;
}

// Where the camera stands, and how points look from there before they are scaled to the grid.
class Eye {
  public:
    Eye(const Mesh& mesh, const CameraParams& camera)
        : middle_(box_of(mesh.points).middle()),
          perspective_(camera.projection == Projection::perspective) {
        const auto [sin_az, cos_az] = stable::sin_cos(camera.azimuth_rad);
        const auto [sin_el, cos_el] = stable::sin_cos(camera.elevation_rad);
        to_eye = {sin_az * cos_el, sin_el, cos_az * cos_el};
        right = {cos_az, 0, -sin_az};
        up = glm::cross(to_eye, right);
        if (perspective_) distance_ = distance_to_see(mesh.points, camera.field_of_view_rad);
    }

    Vec3 see(Vec3 point) const {
        const Vec3 p = point - middle_;
        const Vec3 seen(glm::dot(p, right), -glm::dot(p, up), -glm::dot(p, to_eye));
        if (!perspective_) return seen;
        const double nearness = distance_ / (distance_ + seen.z);
        return {seen.x * nearness, seen.y * nearness, -distance_ * nearness};
    }

    Vec3 middle() const { return middle_; }
    double distance() const { return distance_; }  // 0: orthographic

    Vec3 right, up, to_eye;

  private:
    // From the middle, so that a sphere round all points just fills the field of view.
    double distance_to_see(std::span<const Vec3> points, double field_of_view_rad) const {
        double radius = 0;
        for (const Vec3& p : points)
            radius = std::max(radius, glm::distance(p, middle_));
        return std::max(radius, 1e-9) / stable::sin_cos(field_of_view_rad / 2).sin;
    }

    Vec3 middle_;
    bool perspective_;
    double distance_ = 0;
};

std::int32_t step(double value) {
    return static_cast<std::int32_t>(std::floor(value + 0.5));
}

}  // namespace

View project(const Mesh& mesh, const CameraParams& camera, double resolution) {
    const Eye eye(mesh, camera);
    std::vector<Vec3> seen(mesh.points.size());
    for_each_index(seen.size(), kWorthThreads,
                   [&](std::size_t i) { seen[i] = eye.see(mesh.points[i]); });
    const Box box = box_of(seen);
    const Vec3 size = box.max - box.min, middle = box.middle();
    // A mesh seen along its length must fit in depth as well.
    const double longer = std::max({size.x, size.y, size.z / 2, 1e-12});
    View view;
    view.right = eye.right, view.up = eye.up, view.to_eye = eye.to_eye;
    view.middle = eye.middle(), view.distance = eye.distance();
    view.steps_per_unit = resolution * kStepsPerPx / longer;
    const Vec3 origin = eye.see(Vec3(0)) - middle;
    view.origin = Vec2(origin.x, origin.y) * view.steps_per_unit;
    view.at.resize(seen.size());
    for_each_index(seen.size(), kWorthThreads, [&](std::size_t i) {
        const Vec3 p = (seen[i] - middle) * view.steps_per_unit;
        view.at[i] = {step(p.x), step(p.y), step(p.z)};
    });
    view.front.resize(mesh.triangles.size());
    for_each_index(view.front.size(), kWorthThreads, [&](std::size_t i) {
        const auto& [a, b, c] = mesh.triangles[i];
        view.front[i] =  // y points down: what runs counter-clockwise to the eye has area < 0
            orientation(on_screen(view.at[a]), on_screen(view.at[b]), on_screen(view.at[c])) < 0;
    });
    return view;
}

std::vector<std::uint8_t> find_shown(const Mesh& mesh, std::span<const MeshEdge> edges,
                                     const View& view) {
    std::vector<std::uint8_t> is_open(mesh.parts.size(), 0);
    for (const MeshEdge& edge : edges) {
        if (edge.left == kNone) is_open[mesh.part_of[edge.right]] = 1;
        if (edge.right == kNone) is_open[mesh.part_of[edge.left]] = 1;
    }
    std::vector<std::uint8_t> shown = view.front;
    for (std::size_t i = 0; i < shown.size(); ++i)
        shown[i] |= is_open[mesh.part_of[i]];
    return shown;
}

}  // namespace edaha
