// SPDX-License-Identifier: MIT
#include "surface/growth_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "base/stable_math.h"
#include "surface/move.h"
#include "surface/surface_purposes.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 2000;
constexpr double kSkin_mm = 0.5;  // touching is nearer than that
// Of T_m: how far faces may reach into obstacles, and how exactly that is known. Together below the
// tenth that must hold, as corners stop one by one and their faces turn; with much less, bark can't
// close round what is thin. More exactly, faces that lie against an obstacle take longer than all
// else.
constexpr double kDeep = 0.065;
constexpr double kDepthTolerance = 0.03;
constexpr double kReported_mm = 0.2;  // at the end, and where T_m is next to nothing
// A contact presses where the ways off the obstacle of what touches it, on average, are longer than
// this: 1 on one side of it, 0 all round it. With 0.5 the lips stop before they meet, and leave
// dents; with 0 what lies all round a rod goes on swelling along it without end.
constexpr double kOneSided = 0.25;

Vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 1e-12 ? v / length : Vec3(0);
}

// Random burls begin within the first half of the growth, where the trunk then is.
std::vector<BurlPlace> random_places(const SurfaceParams& params, const KeyedRandom& random) {
    std::vector<BurlPlace> places;
    for (std::int64_t i = 0; i < params.random_burls; ++i) {
        const Key key = step(name_key("burl"), static_cast<Key>(i));
        const auto number = [&](std::uint32_t index) {
            return random.uniform(key, surface::kBurlPlace, index);
        };
        BurlPlace place;
        place.from = 1 + static_cast<std::int64_t>(static_cast<double>(params.steps) *
                                                   (0.1 + 0.4 * number(0)));
        const double reached = static_cast<double>(place.from) * params.speed_mm;
        place.height_mm = (0.05 + 0.7 * number(1)) * reached;
        place.azimuth_rad = 2 * std::numbers::pi * number(2);
        place.radius_mm = params.burl_radius_mm * (0.6 + 0.8 * number(3));
        place.core_mm = params.burl_core_mm * place.radius_mm / params.burl_radius_mm;
        place.strength = params.burl_strength * (0.6 + 0.8 * number(4));
        places.push_back(place);
    }
    return places;
}

}  // namespace

GrowthFields::GrowthFields(const SurfaceParams& params, const KeyedRandom& random)
    : params_(params), places_(params.burls) {
    const std::vector<BurlPlace> more = random_places(params, random);
    places_.insert(places_.end(), more.begin(), more.end());
    for (const SolidParams& hollow : params.hollows)
        hollows_.emplace_back(hollow);
    for (const SolidParams& obstacle : params.obstacles)
        obstacles_.emplace_back(obstacle);
}

void GrowthFields::begin(std::int64_t step, GrowingMesh& mesh, std::span<const Apex> apices,
                         std::span<const Vec3> normals) {
    step_ = step;
    for (const BurlPlace& burl : places_) {
        if (burl.from != step) continue;
        const auto [sine, cosine] = stable::sin_cos(burl.azimuth_rad);
        const Vec3 way(sine, 0, cosine);
        std::uint32_t best = kNone;
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t v = 0; v < mesh.out.size(); ++v) {
            if (!mesh.is_vertex(v) || mesh.tissue[v] != Tissue::cambium || mesh.branch[v] != 0)
                continue;
            const double aside = 1 - glm::dot(normals[v], way);
            const double off = std::abs(mesh.position[v].y - burl.height_mm) + 300 * aside;
            if (off < least) least = off, best = v;
        }
        if (best != kNone) put_centre(mesh, best, burl);
    }
    string_burls(mesh, apices);
    rot(step, mesh);
}

void GrowthFields::put_centre(GrowingMesh& mesh, std::uint32_t vertex, const BurlPlace& burl) {
    mesh.is_bud[vertex] = 1;
    centres_.push_back({vertex, burl.radius_mm, burl.core_mm, burl.strength});
}

// Along the first line of phloem, evenly, each as soon as the trunk is so long (6.3).
void GrowthFields::string_burls(GrowingMesh& mesh, std::span<const Apex> apices) {
    if (strung_ >= params_.strung || foot_ == kNone) return;
    const double spacing = static_cast<double>(params_.steps) * params_.speed_mm /
                           static_cast<double>(params_.strung + 1);
    const double next = spacing * static_cast<double>(strung_ + 1);
    if (apices[0].travel < next) return;
    ++strung_;
    std::uint32_t v = foot_;
    for (std::uint32_t steps = 0; steps < mesh.out.size(); ++steps) {
        const std::uint32_t up = mesh.phloem_up[v];
        if (mesh.travel[v] >= next - params_.split_mm || up == kNone ||
            mesh.tissue[up] == Tissue::apex)
            break;
        v = up;
    }
    if (mesh.is_vertex(v) && mesh.tissue[v] == Tissue::cambium)
        put_centre(mesh, v,
                   {0, 0, params_.burl_radius_mm, params_.burl_core_mm, params_.burl_strength, 0});
}

// Once: what closes over a hollow later does not decay again.
void GrowthFields::rot(std::int64_t step, GrowingMesh& mesh) const {
    for (const Solid& hollow : hollows_) {
        if (hollow.step() != step) continue;
        for (std::uint32_t v = 0; v < mesh.out.size(); ++v) {
            if (mesh.is_vertex(v) && mesh.tissue[v] == Tissue::cambium && mesh.is_bud[v] == 0 &&
                hollow.contains(mesh.position[v]))
                mesh.tissue[v] = Tissue::xylem;
        }
    }
}

std::vector<BurlSphere> GrowthFields::spheres(const GrowingMesh& mesh) const {
    std::vector<BurlSphere> all;
    for (const Centre& centre : centres_)
        all.push_back({mesh.position[centre.vertex], centre.radius, centre.core, centre.strength});
    if (!params_.rim || hollows_.empty()) return all;
    std::vector<Vec3> rim;
    for (std::uint32_t v = 0; v < mesh.out.size(); ++v) {
        if (!mesh.is_vertex(v) || mesh.tissue[v] != Tissue::cambium) continue;
        bool beside = false;
        mesh.for_each_out(v, [&](std::uint32_t h) {
            beside = beside || mesh.tissue[mesh.target(h)] == Tissue::xylem;
        });
        if (beside && is_alone(rim, mesh.position[v])) rim.push_back(mesh.position[v]);
    }
    for (const Vec3& place : rim)
        all.push_back({place, params_.rim_radius_mm, params_.burl_core_mm, params_.rim_strength});
    return all;
}

bool GrowthFields::is_at_pith(const GrowingMesh& mesh, std::span<const Apex> apices,
                              std::uint32_t v) const {
    const std::vector<Vec3>& way = apices[mesh.branch[v]].path;
    return std::ranges::any_of(
        way, [&](const Vec3& p) { return glm::distance(p, mesh.position[v]) < params_.merge_mm; });
}

std::vector<Vec3> GrowthFields::moves(const GrowingMesh& mesh, std::span<const Apex> apices,
                                      std::span<const Vec3> normals) const {
    const std::vector<BurlSphere> all = spheres(mesh);
    const BurlField field(all), pressed(contacts_);
    std::vector<Vec3> result(mesh.position.size(), Vec3(0));
    for_each_index(result.size(), kWorthThreads, [&](std::size_t i) {
        const auto v = static_cast<std::uint32_t>(i);
        if (!mesh.is_vertex(v) || mesh.tissue[v] == Tissue::apex) return;
        if (mesh.tissue[v] == Tissue::xylem) {  // eq. 8
            if (!is_at_pith(mesh, apices, v)) result[v] = -params_.decay_mm * normals[v];
            return;
        }
        Vec3 to_xylem(0), to_touching(0);
        mesh.for_each_out(v, [&](std::uint32_t h) {
            const std::uint32_t other = mesh.target(h);
            const Vec3 way = unit(mesh.position[other] - mesh.position[v]);
            if (mesh.tissue[other] == Tissue::xylem) to_xylem += way;
            if (other < touches_.size() && touches_[other] != 0) to_touching += way;
        });
        // Where it points back into the wood it would only hold the lips up, the more the larger
        // B is: that part of it is left out [E].
        to_touching = unit(to_touching);
        to_touching -= std::min(0.0, glm::dot(to_touching, normals[v])) * normals[v];
        // Eqs. 9, 10; without either, eq. 4.
        const Vec3 way =
            normals[v] + params_.closing * unit(to_xylem) + params_.wrapping * to_touching;
        const Vec3& p = mesh.position[v];
        result[v] = (field.factor(p) + pressed.largest(p)) * mesh.thickening[v] * way;  // eq. 6
        const double length = glm::length(result[v]), most = params_.merge_mm / 2;
        if (length > most) result[v] *= most / length;
    });
    return result;
}

// Spheres of rims stand R' apart: one a vertex would add up without end.
bool GrowthFields::is_alone(std::span<const Vec3> centres, const Vec3& p) const {
    return std::ranges::none_of(
        centres, [&](const Vec3& other) { return glm::distance(other, p) < params_.burl_core_mm; });
}

bool GrowthFields::is_barred(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const double tolerance = std::max(kDepthTolerance * params_.merge_mm, kReported_mm);
    return is_deeper(obstacles_, {a, b, c}, {step_, kDeep * params_.merge_mm, tolerance});
}

void GrowthFields::stop_at_obstacles(const GrowingMesh& mesh, std::vector<Vec3>& moves) {
    touches_.assign(mesh.position.size(), 0);
    near_.assign(mesh.position.size(), 0);
    if (obstacles_.empty()) return;
    for_each_index(moves.size(), kWorthThreads, [&](std::size_t i) {
        const auto v = static_cast<std::uint32_t>(i);
        if (!mesh.is_vertex(v)) return;
        const Vec3& p = mesh.position[v];
        const double reach = glm::length(moves[v]) + kSkin_mm;
        const double now = least_distance(obstacles_, step_, p, std::max(reach, params_.split_mm));
        near_[v] = now < params_.split_mm;
        if (now >= reach) return;
        const double then = least_distance(obstacles_, step_, p + moves[v], kSkin_mm);
        if (then >= kSkin_mm) return;
        // Straight to the surface, or not at all.
        const double part = now <= kSkin_mm ? 0 : (now - kSkin_mm) / (now - then);
        moves[v] *= std::clamp(part, 0.0, 1.0);
        touches_[v] = 1;
    });
    // What stops takes the faces round it elsewhere than they were to go.
    while (stop_entering(mesh, moves))
        continue;
    find_contacts(mesh);
}

// Whether any corner of a face that would reach too deep in had still been moving.
bool GrowthFields::stop_entering(const GrowingMesh& mesh, std::vector<Vec3>& moves) {
    const auto entering = gather<std::uint32_t>(
        mesh.origin.size() / 3, [&](std::size_t f, std::vector<std::uint32_t>& found) {
            if (mesh.origin[3 * f] == kNone) return;
            const std::uint32_t* v = &mesh.origin[3 * f];
            if (near_[v[0]] + near_[v[1]] + near_[v[2]] == 0) return;
            if (is_barred(mesh.position[v[0]] + moves[v[0]], mesh.position[v[1]] + moves[v[1]],
                          mesh.position[v[2]] + moves[v[2]]))
                found.push_back(static_cast<std::uint32_t>(f));
        });
    bool stopped = false;
    for (const std::uint32_t f : entering) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.origin[3 * f + k];
            stopped = stopped || moves[v] != Vec3(0);
            moves[v] = Vec3(0);
            touches_[v] = 1;
        }
    }
    return stopped;
}

// Of the nearest obstacle.
Vec3 GrowthFields::outward(const Vec3& p) const {
    const Solid* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Solid& obstacle : obstacles_) {
        if (obstacle.step() > step_) continue;
        const double distance = obstacle.distance(p);
        if (distance < least) least = distance, nearest = &obstacle;
    }
    return nearest == nullptr ? Vec3(0) : nearest->outward(p);
}

// Centres stand R' apart: nearer ones would add nothing to the largest K at what touches.
void GrowthFields::find_contacts(const GrowingMesh& mesh) {
    std::vector<Vec3> touching, outwards, centres;
    for (std::uint32_t v = 0; v < touches_.size(); ++v) {
        if (touches_[v] == 0 || mesh.tissue[v] != Tissue::cambium) continue;
        touching.push_back(mesh.position[v]);
        outwards.push_back(outward(mesh.position[v]));
        if (is_alone(centres, mesh.position[v])) centres.push_back(mesh.position[v]);
    }
    contacts_.clear();
    for (const Vec3& centre : centres) {
        Vec3 sum(0);
        double count = 0;
        for (std::size_t i = 0; i < touching.size(); ++i) {
            if (glm::distance(touching[i], centre) >= params_.burl_core_mm) continue;
            sum += outwards[i];
            ++count;
        }
        if (glm::length(sum) > kOneSided * count)
            contacts_.push_back({centre, params_.contact_radius_mm, params_.burl_core_mm,
                                 params_.contact_strength});
    }
}

void GrowthFields::renumber(std::span<const std::uint32_t> vertex) {
    for (Centre& centre : centres_)
        centre.vertex = vertex[centre.vertex];
    if (foot_ != kNone) foot_ = vertex[foot_];
    // More vertices may have come since than touched or not.
    std::vector<std::uint8_t> touches(vertex.size(), 0);
    for (std::size_t v = 0; v < touches_.size(); ++v)
        if (touches_[v] != 0 && vertex[v] != kNone) touches[vertex[v]] = 1;
    touches_ = std::move(touches);
}

std::size_t GrowthFields::contacts() const {
    return static_cast<std::size_t>(std::count(touches_.begin(), touches_.end(), 1));
}

double GrowthFields::deepest_mm(const GrowingMesh& mesh) const {
    double most = 0;
    for (std::size_t f = 0; f < mesh.origin.size() / 3; ++f) {
        if (mesh.origin[3 * f] == kNone) continue;
        const std::uint32_t* v = &mesh.origin[3 * f];
        most = deepest(obstacles_, {mesh.position[v[0]], mesh.position[v[1]], mesh.position[v[2]]},
                       {step_, most, kReported_mm});
    }
    return most;
}

}  // namespace edaha
