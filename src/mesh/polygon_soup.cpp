// SPDX-License-Identifier: MIT
#include "mesh/polygon_soup.h"

#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "mesh/triangulate.h"

namespace edaha {
namespace {

class MeshBuilder {
  public:
    explicit MeshBuilder(PolygonSoup soup) : soup_(std::move(soup)) {}

    Mesh run() {
        keep_used_parts();
        add_triangles();
        number_points();
        name_parts();
        return std::move(mesh_);
    }

  private:
    void keep_used_parts() {
        std::vector<char> part_used(soup_.parts.size(), 0);
        std::vector<char> material_used(soup_.materials.size(), 0);
        for (const PolygonSoup::Face& face : soup_.faces)
            part_used[face.part] = 1;
        for (std::size_t i = 0; i < soup_.parts.size(); ++i) {
            if (part_used[i] != 0) material_used[soup_.parts[i].material] = 1;
        }
        const std::vector<std::uint32_t> new_part = numbers_of(part_used);
        const std::vector<std::uint32_t> new_material = numbers_of(material_used);
        for (std::size_t i = 0; i < soup_.materials.size(); ++i) {
            if (new_material[i] != kNone) mesh_.materials.push_back(std::move(soup_.materials[i]));
        }
        for (std::size_t i = 0; i < soup_.parts.size(); ++i) {
            if (new_part[i] == kNone) continue;
            MeshPart& part = mesh_.parts.emplace_back(std::move(soup_.parts[i]));
            part.material = new_material[part.material];
            if (part.parent >= 0) {
                const std::uint32_t parent = new_part[static_cast<std::size_t>(part.parent)];
                part.parent = parent == kNone ? -1 : static_cast<std::int32_t>(parent);
            }
        }
        for (PolygonSoup::Face& face : soup_.faces)
            face.part = new_part[face.part];
    }

    static std::vector<std::uint32_t> numbers_of(const std::vector<char>& used) {
        std::vector<std::uint32_t> numbers(used.size(), kNone);
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (used[i] != 0) numbers[i] = count++;
        }
        return numbers;
    }

    void add_triangles() {
        mesh_.triangles.reserve(soup_.faces.size());
        mesh_.part_of.reserve(soup_.faces.size());
        soup_.corner_uv.resize(soup_.uv.empty() ? 0 : soup_.corner_points.size(), kNone);
        std::uint32_t first = 0;
        for (const PolygonSoup::Face& face : soup_.faces) {
            if (face.corners == 3) {
                add_triangle({first, first + 1, first + 2}, face.part);
            } else {
                add_polygon(first, face);
            }
            first += face.corners;
        }
    }

    void add_polygon(std::uint32_t first, const PolygonSoup::Face& face) {
        polygon_.clear();
        for (std::uint32_t k = 0; k < face.corners; ++k)
            polygon_.push_back(soup_.points[soup_.corner_points[first + k]]);
        for (const Triangle& t : triangulate(polygon_))
            add_triangle({first + t[0], first + t[1], first + t[2]}, face.part);
    }

    void add_triangle(const Triangle& corners, std::uint32_t part) {
        Triangle points{};
        for (std::size_t k = 0; k < 3; ++k)
            points[k] = soup_.corner_points[corners[k]];
        mesh_.triangles.push_back(points);
        mesh_.part_of.push_back(part);
        if (soup_.uv.empty()) return;
        std::array<glm::dvec2, 3>& uv = mesh_.uv.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t place = soup_.corner_uv[corners[k]];
            uv[k] = place == kNone ? glm::dvec2(0) : soup_.uv[place];
        }
    }

    // Part after part, so that one number a point tells whether the part has it already.
    void number_points() {
        std::vector<std::uint32_t> number(soup_.points.size());
        std::vector<std::uint32_t> owner(soup_.points.size(), kNone);
        mesh_.points.reserve(soup_.points.size());
        for (const std::uint32_t t : triangles_by_part()) {
            const std::uint32_t part = mesh_.part_of[t];
            for (std::uint32_t& point : mesh_.triangles[t]) {
                if (owner[point] != part) {
                    owner[point] = part;
                    number[point] = static_cast<std::uint32_t>(mesh_.points.size());
                    mesh_.points.push_back(soup_.points[point]);
                }
                point = number[point];
            }
        }
    }

    std::vector<std::uint32_t> triangles_by_part() const {
        std::vector<std::uint32_t> first(mesh_.parts.size() + 1, 0);
        for (const std::uint32_t part : mesh_.part_of)
            ++first[part + 1];
        std::partial_sum(first.begin(), first.end(), first.begin());
        std::vector<std::uint32_t> order(mesh_.triangles.size());
        for (std::uint32_t t = 0; t < order.size(); ++t)
            order[first[mesh_.part_of[t]]++] = t;
        return order;
    }

    void name_parts() {
        std::map<std::string, int> uses;
        for (MeshPart& part : mesh_.parts) {
            const std::string name = part.name.empty() ? "mesh" : part.name;
            part.name = name;
            for (int& n = uses[name]; uses.contains(part.name) && ++n > 1;)
                part.name = name + '-' + std::to_string(n);
            uses.try_emplace(part.name, 1);
        }
    }

    PolygonSoup soup_;
    Mesh mesh_;
    std::vector<Vec3> polygon_;
};

}  // namespace

Mesh mesh_of(PolygonSoup soup) {
    return MeshBuilder(std::move(soup)).run();
}

}  // namespace edaha
