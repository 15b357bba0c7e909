// SPDX-License-Identifier: MIT
#include "prism/prism_tree.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "prism/foliage.h"
#include "prism/growth.h"
#include "prism/purposes.h"

namespace edaha {
namespace {

// Where a prism stands in its tree, for its name: limb "2a" leaves the second prism of the trunk
// on half a; prisms of a limb are counted.
struct Place {
    std::string limb;
    std::size_t number = 1;

    std::string path() const { return limb + std::to_string(number); }
};

Place place_of(const Prism& prism, const std::vector<Place>& places) {
    if (prism.parent < 0) return {};
    const Place& parent = places[static_cast<std::size_t>(prism.parent)];
    if (prism.child == 0) return {parent.limb, parent.number + 1};
    return {parent.path() + (prism.child == 1 ? 'a' : 'b'), 1};
}

class Modelling {
  public:
    Modelling(GrownPrisms grown, const PrismParams& params, const KeyedRandom& random)
        : grown_(std::move(grown)), params_(params), random_(random) {}

    PrismTree run() {
        tree_.mesh.materials = {{"wood", std::nullopt}};
        std::vector<Place> places;
        for (const Prism& prism : grown_.prisms) {
            places.push_back(place_of(prism, places));
            add_part(prism, places.back());
            if (prism.top > 0) {
                add_prism(prism.corners);
            } else {
                add_pyramid(prism.corners);
            }
            add_sites(prism);
            count(prism);
        }
        add_foliage(places);
        tree_.counts.turned = grown_.turned;
        tree_.counts.dropped = grown_.dropped;
        return std::move(tree_);
    }

  private:
    void add_part(const Prism& prism, const Place& place) {
        MeshPart part;
        part.name = (place.limb.empty() ? "trunk-" : "branch-") + place.path();
        part.order = prism.depth - 1U;
        part.parent = prism.parent;
        part.axis = Axis{prism.origin, prism.tip()};
        tree_.mesh.parts.push_back(std::move(part));
    }

    void add_prism(const PrismCorners& corners) {
        add({0, 2, 1});
        add({3, 4, 5});
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t j = (i + 1) % 3;
            add({i, j, j + 3});
            add({i, j + 3, i + 3});
        }
        Mesh& mesh = tree_.mesh;
        mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
    }

    void add_pyramid(const PrismCorners& corners) {
        add({0, 2, 1});
        for (std::uint32_t i = 0; i < 3; ++i)
            add({i, (i + 1) % 3, 3});
        Mesh& mesh = tree_.mesh;
        mesh.points.insert(mesh.points.end(), corners.begin(), corners.begin() + 4);
    }

    // Of the last part; the points that follow are counted from 0.
    void add(Triangle triangle) {
        Mesh& mesh = tree_.mesh;
        for (std::uint32_t& corner : triangle)
            corner += static_cast<std::uint32_t>(mesh.points.size());
        mesh.triangles.push_back(triangle);
        mesh.part_of.push_back(static_cast<std::uint32_t>(mesh.parts.size() - 1));
    }

    void add_sites(const Prism& prism) {
        if (prism.last) add_site(prism.tip(), prism.direction());
        if (params_.along_mm <= 0 || std::sqrt(area(prism.base)) >= params_.along_width_mm) return;
        const auto sites = static_cast<std::uint32_t>(prism.length / params_.along_mm);
        for (std::uint32_t i = 0; i < sites; ++i)
            add_flank_site(prism, (i + 1.0) / (sites + 1), i);
    }

    // In the middle of one of the three sides, half outward and half along.
    void add_flank_site(const Prism& prism, double at, std::uint32_t index) {
        const double u = random_.uniform(prism.key, prism::kSite, index);
        const auto side = std::min<std::size_t>(static_cast<std::size_t>(3 * u), 2);
        const std::size_t next = (side + 1) % 3;
        const PrismCorners& c = prism.corners;
        const Vec3 base = (c[side] + c[next]) / 2.0, top = (c[side + 3] + c[next + 3]) / 2.0;
        const Vec3 outward = glm::normalize(glm::cross(c[next] - c[side], top - base));
        add_site(base + at * (top - base), glm::normalize(outward + prism.direction()));
    }

    void add_site(Vec3 position, Vec3 direction) {
        const auto part = static_cast<std::uint32_t>(tree_.mesh.parts.size() - 1);
        tree_.mesh.sites.push_back({position, direction, params_.site_mm, part});
    }

    void add_foliage(const std::vector<Place>& places) {
        Mesh& mesh = tree_.mesh;
        const auto masses = foliage_of(grown_.prisms, params_.foliage, random_);
        if (!masses.empty()) mesh.materials.push_back({"leaf", std::nullopt});
        for (const FoliageMass& mass : masses) {
            MeshPart part;
            part.name = "leaves-" + places[mass.bearer].path();
            part.order = mesh.parts[mass.bearer].order;
            part.parent = static_cast<std::int32_t>(mass.bearer);
            part.material = 1;
            mesh.parts.push_back(std::move(part));
            for (const Triangle& triangle : mass.triangles)
                add(triangle);
            mesh.points.insert(mesh.points.end(), mass.points.begin(), mass.points.end());
        }
        tree_.counts.foliage = masses.size();
    }

    void count(const Prism& prism) {
        PrismCounts& counts = tree_.counts;
        ++counts.prisms;
        if (counts.by_order.size() < prism.depth) counts.by_order.resize(prism.depth);
        ++counts.by_order[prism.depth - 1U];
    }

    GrownPrisms grown_;
    const PrismParams& params_;
    const KeyedRandom& random_;
    PrismTree tree_;
};

}  // namespace

PrismTree grow_prisms(const PrismParams& params, const KeyedRandom& random) {
    return Modelling(grow(params, random), params, random).run();
}

}  // namespace edaha
