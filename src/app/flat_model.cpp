// SPDX-License-Identifier: MIT
#include "app/flat_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "app/flat_inks.h"
#include "base/keyed_random.h"
#include "base/stable_math.h"
#include "geometry/bounds.h"

namespace edaha {
namespace {

constexpr std::uint32_t kClumpOrder = 2;

// How wide the mesh's foot is: what lies in the lowest fiftieth of its height.
Bounds extent(const Mesh& mesh, const FlatFrame& frame, double part_of_height) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const Vec3& point : mesh.points) {
        low = std::min(low, point.y);
        high = std::max(high, point.y);
    }
    Bounds box;
    for (const Vec3& point : mesh.points) {
        if (point.y <= low + part_of_height * (high - low))
            box.include(frame.flat_from_world(point));
    }
    return box;
}

// The trunk's own part comes first: prisms and prop roots see to that.
Mesh first_part(const Mesh& mesh) {
    Mesh part;
    std::vector<std::uint8_t> is_in(mesh.points.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.part_of[t] != 0) continue;
        for (const std::uint32_t point : mesh.triangles[t])
            is_in[point] = 1;
    }
    for (std::size_t i = 0; i < is_in.size(); ++i) {
        if (is_in[i] != 0) part.points.push_back(mesh.points[i]);
    }
    return part;
}

Stand stand_of(const ModelMesh& model, const FlatFrame& frame) {
    const Bounds foot = extent(first_part(model.mesh), frame, 0.02);
    const Bounds all = extent(model.mesh, frame, 1);
    Stand stand;
    stand.foot = frame.flat_from_world(Vec3(0));
    stand.foot_width_mm = foot.empty() ? 0 : foot.width();
    stand.crown_left_mm = all.empty() ? stand.foot.x : all.min.x;
    stand.crown_right_mm = all.empty() ? stand.foot.x : all.max.x;
    for (const RootFoot& root : model.root_feet)
        stand.roots.push_back(
            {frame.flat_from_world(root.middle), root.radius * frame.mm_per_unit_at(root.middle)});
    return stand;
}

std::int32_t clump_of(const std::vector<MeshPart>& parts, std::uint32_t part) {
    while (parts[part].order > kClumpOrder && parts[part].parent >= 0)
        part = static_cast<std::uint32_t>(parts[part].parent);
    return static_cast<std::int32_t>(part);
}

Key key_of(const Mesh& mesh, const SprigSite& sprig, std::vector<std::uint32_t>& count_of_part) {
    return step(name_key(mesh.parts[sprig.part].name), count_of_part[sprig.part]++);
}

class IdSettler {
  public:
    void take(const std::vector<Element>& elements) {
        for (const Element& element : elements) {
            if (const auto* shape = std::get_if<Shape>(&element)) taken_.insert(shape->id);
            const auto* group = std::get_if<Group>(&element);
            if (group == nullptr) continue;
            taken_.insert(group->id);
            take(group->children);
        }
    }
    void take(const std::string& id) { taken_.insert(id); }

    void settle(std::vector<Element>& elements) {
        for (Element& element : elements) {
            if (auto* shape = std::get_if<Shape>(&element)) settle(shape->id);
            auto* group = std::get_if<Group>(&element);
            if (group == nullptr) continue;
            settle(group->id);
            settle(group->children);
        }
    }

  private:
    void settle(std::string& id) {
        if (id.empty()) return;
        std::string base = id_from_label(id);
        const bool letter = std::isalpha(static_cast<unsigned char>(base.front())) != 0;
        if (!letter) base.insert(0, "part-");
        id = base;
        for (int& n = uses_.try_emplace(base, 1).first->second; !taken_.insert(id).second;)
            id = base + '-' + std::to_string(++n);
    }

    std::set<std::string> taken_;
    std::map<std::string, int> uses_;
};

LimbsPlace crown_on(const TrunkTop& top, const FlatFrame& frame, double trunk_mm) {
    LimbsPlace place;
    place.foot_mm = frame.flat_from_world(top.position);
    const Vec2 way =
        frame.flat_from_world(top.position + top.direction * top.radius) - place.foot_mm;
    place.turn_rad = stable::atan2(way.x, -way.y);
    place.scale = 2 * top.radius * frame.mm_per_unit_at(top.position) / trunk_mm;
    return place;
}

}  // namespace

FlatModel draw_model(const Style& style, ModelMesh model, double trunk_mm, const BarkTile& bark) {
    FlatModel result;
    result.model = std::move(model);
    FlattenParams params = style.flatten;
    const std::optional<TrunkTop>& top = result.model.top;
    if (top && trunk_mm > 0 && params.mm_per_unit == 0)
        params.mm_per_unit = trunk_mm / (2 * top->radius);
    const Mesh& mesh = result.model.mesh;
    FlattenInks inks = flat_inks(style.palette, mesh.materials);
    if (top && trunk_mm > 0) {
        for (Colour& tone : inks.tones[mesh.parts.front().material])
            tone = style.palette.wood;
    }
    result.flat = flatten(mesh, params, inks, bark);
    const FlatFrame& frame = result.flat.frame;
    result.stand = stand_of(result.model, frame);
    if (top && trunk_mm > 0) result.crown = crown_on(*top, frame, trunk_mm);
    return result;
}

std::vector<Site> sites(const FlatModel& model) {
    const Mesh& mesh = model.model.mesh;
    const FlatFrame& frame = model.flat.frame;
    std::vector<Site> result;
    std::vector<std::uint32_t> count_of_part(mesh.parts.size(), 0);
    for (const SprigSite& sprig : mesh.sites) {
        Site site;
        site.position = frame.flat_from_world(sprig.position);
        const Vec2 seen(glm::dot(sprig.direction, frame.right),
                        -glm::dot(sprig.direction, frame.up));
        const double length = glm::length(seen);
        site.direction = length > 1e-3 ? seen / length : Vec2(0, -1);  // towards the eye: upwards
        site.key = key_of(mesh, sprig, count_of_part);
        site.wood_width_mm = sprig.size * frame.mm_per_unit_at(sprig.position);
        site.clump = clump_of(mesh.parts, sprig.part);
        site.terminal = true;
        site.back = glm::dot(sprig.position, frame.to_eye) < 0;
        result.push_back(site);
    }
    return result;
}

std::vector<SprigPlace> sprig_places(const FlatModel& model) {
    const Mesh& mesh = model.model.mesh;
    const FlatFrame& frame = model.flat.frame;
    const auto seen = [&](const Vec3& v) {
        return Vec3(glm::dot(v, frame.right), -glm::dot(v, frame.up), glm::dot(v, frame.to_eye));
    };
    std::vector<SprigPlace> result;
    std::vector<std::uint32_t> count_of_part(mesh.parts.size(), 0);
    for (const SprigSite& sprig : mesh.sites) {
        const double scale = frame.mm_per_unit_at(sprig.position);
        SprigPlace place;
        place.key = key_of(mesh, sprig, count_of_part);
        place.foot = Vec3(frame.flat_from_world(sprig.position),
                          glm::dot(sprig.position - frame.middle, frame.to_eye) * scale);
        place.direction = seen(sprig.direction);
        place.size_mm = sprig.size * scale;
        result.push_back(place);
    }
    return result;
}

void settle_ids(std::vector<Layer>& layers, const std::vector<Layer>& taken,
                const std::vector<Symbol>& symbols) {
    IdSettler ids;
    for (const Layer& layer : taken) {
        ids.take(layer.id());
        ids.take(layer.children);
    }
    for (const Layer& layer : layers)
        ids.take(layer.id());
    for (const Symbol& symbol : symbols) {
        ids.take(symbol.id);
        for (const Shape& shape : symbol.shapes)
            ids.take(shape.id);
    }
    for (Layer& layer : layers)
        ids.settle(layer.children);
}

}  // namespace edaha
