// SPDX-License-Identifier: MIT
#include "surface/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "surface/branch_way.h"
#include "surface/move.h"
#include "surface/surface_purposes.h"

namespace edaha {

namespace {

constexpr std::uint32_t kWood = 0, kXylem = 1, kDeadwood = 2;
constexpr std::size_t kFewVertices = 500;  // below: one thread
// Sprigs in a spacing's length of a twig, for each vertex round it: less leaves spikes bare, more
// makes brushes of them.
constexpr double kOnTwigs = 0.35;

class SurfaceMesher {
  public:
    SurfaceMesher(const GrowingMesh& mesh, std::span<const Apex> apices,
                  const SurfaceParams& params, const KeyedRandom& random)
        : mesh_(mesh), apices_(apices), params_(params), random_(random) {}

    Mesh run() {
        add_points();
        add_branches();
        add_faces();
        add_uv();
        add_sites();
        return std::move(result_);
    }

  private:
    void add_points() {
        point_of_.assign(mesh_.position.size(), kNone);
        for (std::uint32_t v = 0; v < mesh_.position.size(); ++v) {
            if (!mesh_.is_vertex(v)) continue;
            point_of_[v] = static_cast<std::uint32_t>(result_.points.size());
            result_.points.push_back(mesh_.position[v]);
        }
        result_.materials = {{"wood", std::nullopt}, {"xylem", std::nullopt}};
        if (params_.deadwood) result_.materials.push_back({"deadwood", std::nullopt});
    }

    // Buds that still wait make no part; the rest keep the numbers that they will always have.
    void add_branches() {
        part_of_branch_.assign(apices_.size(), kNone);
        for (std::uint32_t b = 0; b < apices_.size(); ++b) {
            if (apices_[b].path.empty()) continue;
            part_of_branch_[b] = static_cast<std::uint32_t>(result_.parts.size());
            MeshPart part;
            part.name = b == 0 ? "trunk" : "branch-" + std::to_string(b);
            part.order = apices_[b].order;
            if (apices_[b].parent >= 0)
                part.parent = static_cast<std::int32_t>(
                    part_of_branch_[static_cast<std::size_t>(apices_[b].parent)]);
            const bool dead = params_.deadwood && apices_[b].state.stopped;
            part.material = dead ? kDeadwood : kWood;
            result_.parts.push_back(part);
        }
        xylem_of_branch_.assign(apices_.size(), kNone);
    }

    std::uint32_t xylem_part(std::uint32_t branch) {
        std::uint32_t& at = xylem_of_branch_[branch];
        if (at != kNone) return at;
        at = static_cast<std::uint32_t>(result_.parts.size());
        MeshPart part = result_.parts[part_of_branch_[branch]];
        part.name += "-xylem";
        part.parent = static_cast<std::int32_t>(part_of_branch_[branch]);
        part.material = kXylem;
        result_.parts.push_back(part);
        return at;
    }

    void add_faces() {
        for (std::uint32_t f = 0; f < mesh_.origin.size() / 3; ++f) {
            if (!mesh_.is_face(f)) continue;
            const Triangle corners{mesh_.origin[3 * f], mesh_.origin[3 * f + 1],
                                   mesh_.origin[3 * f + 2]};
            std::uint32_t branch = 0;
            bool decays = false;
            for (const std::uint32_t v : corners) {
                branch = std::max(branch, mesh_.branch[v]);
                decays = decays || mesh_.tissue[v] == Tissue::xylem;
            }
            corners_.push_back(corners);
            branch_of_face_.push_back(branch);
            result_.triangles.push_back(
                {point_of_[corners[0]], point_of_[corners[1]], point_of_[corners[2]]});
            result_.part_of.push_back(decays ? xylem_part(branch) : part_of_branch_[branch]);
        }
    }

    void add_uv() {
        std::vector<BranchWay> ways;
        std::vector<std::uint32_t> way_of(apices_.size(), kNone);
        for (std::uint32_t b = 0; b < apices_.size(); ++b) {
            if (part_of_branch_[b] == kNone) continue;
            way_of[b] = static_cast<std::uint32_t>(ways.size());
            ways.emplace_back(apices_[b]);
        }
        places_.resize(corners_.size());
        for_each_index(corners_.size(), kFewVertices, [&](std::size_t f) {
            for (std::size_t k = 0; k < 3; ++k)
                places_[f][k] =
                    ways[way_of[branch_of_face_[f]]].place(mesh_.position[corners_[f][k]]);
        });
        const std::vector<double> radii = mean_radii();
        result_.uv.resize(corners_.size());
        for_each_index(corners_.size(), kFewVertices,
                       [&](std::size_t f) { result_.uv[f] = uv_of(f, radii[branch_of_face_[f]]); });
    }

    std::vector<double> mean_radii() const {
        std::vector<double> sums(apices_.size(), 0), counts(apices_.size(), 0);
        for (std::size_t f = 0; f < places_.size(); ++f) {
            for (const WayPlace& place : places_[f])
                sums[branch_of_face_[f]] += place.radius;
            counts[branch_of_face_[f]] += 3;
        }
        for (std::size_t b = 0; b < sums.size(); ++b)
            sums[b] /= std::max(counts[b], 1.0);
        return sums;
    }

    // On the way itself there is no angle: the mean of the other corners'.
    std::array<glm::dvec2, 3> uv_of(std::size_t f, double radius) const {
        constexpr double kOnWay_mm = 1e-3, kPi = std::numbers::pi;
        const std::array<WayPlace, 3>& at = places_[f];
        std::array<double, 3> angles{};
        std::size_t first = 0;
        while (first < 2 && at[first].radius < kOnWay_mm)
            ++first;
        double sum = 0;
        int count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (at[k].radius < kOnWay_mm) continue;
            angles[k] = at[k].angle;
            if (angles[k] - angles[first] > kPi) angles[k] -= 2 * kPi;
            if (angles[k] - angles[first] < -kPi) angles[k] += 2 * kPi;
            sum += angles[k];
            ++count;
        }
        std::array<glm::dvec2, 3> uv{};
        for (std::size_t k = 0; k < 3; ++k) {
            const double angle = at[k].radius < kOnWay_mm ? sum / std::max(count, 1) : angles[k];
            uv[k] = {(angle - params_.winding_rad * at[k].along) * radius, at[k].along};
        }
        return uv;
    }

    // Each vertex once, with the first of its faces.
    void add_sites() {
        std::vector<double> areas(mesh_.position.size(), 0);
        std::vector<std::uint32_t> face_of(mesh_.position.size(), kNone);
        for (std::uint32_t f = 0; f < corners_.size(); ++f) {
            const auto& [a, b, c] = corners_[f];
            const double area = glm::length(glm::cross(mesh_.position[b] - mesh_.position[a],
                                                       mesh_.position[c] - mesh_.position[a])) /
                                2;
            for (const std::uint32_t v : corners_[f]) {
                areas[v] += area / 3;
                if (face_of[v] == kNone && branch_of_face_[f] == mesh_.branch[v]) face_of[v] = f;
            }
        }
        const std::vector<Vec3> normals = vertex_normals(mesh_, face_normals(mesh_));
        for (const std::uint32_t v : by_name()) {
            if (face_of[v] == kNone || mesh_.tissue[v] == Tissue::xylem) continue;
            const Key key = step(step(name_key("sprig"), mesh_.branch[v]), mesh_.name[v]);
            const double share = mesh_.tissue[v] == Tissue::apex ? 1 : share_of_sprigs(v, areas[v]);
            if (random_.uniform(key, surface::kSprig) < share) add_site(v, face_of[v], normals[v]);
        }
    }

    // The vertices as they were made, so that sprigs stay what they are while the tree grows on.
    std::vector<std::uint32_t> by_name() const {
        std::vector<std::uint32_t> order(mesh_.position.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::sort(order, {}, [&](std::uint32_t v) { return mesh_.name[v]; });
        return order;
    }

    // By its area; on thin twigs, which have little of that, by its edges' length.
    double share_of_sprigs(std::uint32_t v, double area) const {
        double length = 0, edges = 0;
        mesh_.for_each_out(v, [&](std::uint32_t h) {
            length += glm::distance(mesh_.position[v], mesh_.position[mesh_.target(h)]);
            ++edges;
        });
        const double spacing = params_.sprig_spacing_mm;
        return std::max(area / (spacing * spacing), kOnTwigs * length / (edges * spacing));
    }

    void add_site(std::uint32_t v, std::uint32_t face, const Vec3& normal) {
        const Apex& apex = apices_[mesh_.branch[v]];
        const auto corner = static_cast<std::size_t>(
            std::find(corners_[face].begin(), corners_[face].end(), v) - corners_[face].begin());
        const WayPlace& place = places_[face][corner];
        if (!apex.grows || apex.travel - place.along > params_.sprig_reach_mm) return;
        const Vec3 direction = normal + place.heading;
        const double length = glm::length(direction);
        if (length < 1e-6) return;
        // A tip is finer than a stem, which begins within the wood there.
        const double back = mesh_.tissue[v] == Tissue::apex ? params_.split_mm / 2 : 0;
        result_.sites.push_back({mesh_.position[v] - place.heading * back, direction / length,
                                 params_.sprig_mm, part_of_branch_[mesh_.branch[v]]});
    }

    const GrowingMesh& mesh_;
    std::span<const Apex> apices_;
    const SurfaceParams& params_;
    const KeyedRandom& random_;
    Mesh result_;
    std::vector<std::uint32_t> point_of_;
    std::vector<std::uint32_t> part_of_branch_, xylem_of_branch_;
    std::vector<Triangle> corners_;  // of the faces of the result: vertices
    std::vector<std::uint32_t> branch_of_face_;
    std::vector<std::array<WayPlace, 3>> places_;
};

}  // namespace

Mesh surface_mesh(const GrowingMesh& mesh, std::span<const Apex> apices,
                  const SurfaceParams& params, const KeyedRandom& random) {
    return SurfaceMesher(mesh, apices, params, random).run();
}

}  // namespace edaha
