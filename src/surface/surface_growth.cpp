// SPDX-License-Identifier: MIT
#include "surface/surface_growth.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "surface/buds.h"
#include "surface/channels.h"
#include "surface/fuse.h"
#include "surface/move.h"
#include "surface/remesh.h"
#include "surface/seed.h"

namespace edaha {

namespace {

constexpr std::size_t kWorthThreads = 2000;
// Of T_m. Sheets are sewn as soon as they are nearer than that: before any edge of one, which are
// chords, could reach into the other, and so that the folds that are left round the seam, narrower
// than T_m, close by re-meshing. What can't be sewn stays apart by half of that.
constexpr double kMeeting = 0.5;
constexpr double kApart = 0.25;
constexpr double kRetreat = 0.05;  // of T_m a part of a step, until nothing passes through
// Sewing brings new neighbours: what they meet is looked for again, this often a step.
constexpr int kFusionRounds = 3;

std::uint32_t only_apex(const GrowingMesh& mesh) {
    const auto at = std::find(mesh.tissue.begin(), mesh.tissue.end(), Tissue::apex);
    return static_cast<std::uint32_t>(at - mesh.tissue.begin());
}

}  // namespace

SurfaceGrowth::SurfaceGrowth(const SurfaceParams& params, const KeyedRandom& random)
    : params_(params),
      random_(random),
      rules_(parse_rules(params.rules, "rules")),
      mesh_(seed_mesh(params)),
      fields_(params, random) {
    Apex trunk;
    trunk.vertex = only_apex(mesh_);
    trunk.state = first_apex(*rules_, params.speed_mm, params.thickening_mm);
    apices_.push_back(std::move(trunk));
    sprout(mesh_, apices_, 0);
    // The seed is all as it will be after its first remeshing: edges within T_s from the start.
    remesh(mesh_, apices_, {params.split_mm, params.merge_mm, 0, params.flips, {}});
    mesh_.last = mesh_.position;
    of_faces_ = face_normals(mesh_);
    normals_ = vertex_normals(mesh_, of_faces_);
}

void SurfaceGrowth::order_apices() {
    for (std::uint32_t branch = 0; branch < apices_.size(); ++branch) {
        if (apices_[branch].sprouts > 0 && apices_[branch].sprouts == steps_)
            sprout(mesh_, apices_, branch);
        if (!apices_[branch].grows) continue;
        std::vector<Bud> buds = advance(*rules_, apices_[branch].state, random_, steps_);
        if (apices_[branch].state.stopped) stop_apex(mesh_, apices_[branch]);
        place_buds(branch, std::move(buds));
    }
}

void SurfaceGrowth::place_buds(std::uint32_t branch, std::vector<Bud> buds) {
    for (Bud& bud : buds) {
        const auto v = bud_vertex(mesh_, normals_, apices_[branch].vertex, bud.direction);
        if (!v) continue;
        Apex apex;
        apex.vertex = *v;
        apex.state = std::move(bud.state);
        apex.parent = static_cast<std::int32_t>(branch);
        apex.order = apices_[branch].order + 1;
        // At the earliest a step later: this step's orders have been given.
        apex.sprouts = steps_ + std::max<std::int64_t>(bud.delay, 1);
        mesh_.is_bud[*v] = 1;
        apices_.push_back(std::move(apex));
    }
}

// v of eq. 1: eq. 3 at apices.
std::vector<Vec3> SurfaceGrowth::growth_vectors() const {
    std::vector<Vec3> moves = fields_.moves(mesh_, apices_, normals_);
    for (const Apex& apex : apices_)
        if (apex.grows) moves[apex.vertex] = apex.state.speed_mm * apex.state.frame[0];
    return moves;
}

// What runs into the tree itself merges with it (5.3).
void SurfaceGrowth::fuse() {
    const BarsFace is_barred = [this](const Vec3& a, const Vec3& b, const Vec3& c) {
        return fields_.is_barred(a, b, c);
    };
    for (int round = 0; round <= kFusionRounds; ++round) {
        facing_ = facing_pairs(mesh_, of_faces_, normals_, growth_vectors(),
                               {kMeeting * params_.merge_mm, 2 * params_.split_mm, suspects_});
        if (round == kFusionRounds) return;
        const Fusions fusions =
            fuse_facing(mesh_, apices_, facing_.pairs, normals_, {is_barred, &*facing_.grid});
        report_.fusions += fusions.sewn;
        report_.pins = fusions.pinned;
        if (fusions.sewn == 0) return;
        of_faces_ = face_normals(mesh_);
        normals_ = vertex_normals(mesh_, of_faces_);
    }
}

void SurfaceGrowth::stay_apart(std::vector<Vec3>& moves) {
    suspects_ = keep_apart(
        mesh_, facing_, normals_,
        {kApart * params_.merge_mm, 2 * params_.split_mm, kRetreat * params_.merge_mm}, moves);
}

// In as many equal parts as the fastest vertex needs to go T_m / 2 at most in each, so that no
// face is passed through unseen.
void SurfaceGrowth::move_all() {
    std::vector<Vec3> moves = growth_vectors();
    double fastest = 0;
    for (const Vec3& move : moves)
        fastest = std::max(fastest, glm::dot(move, move));
    const double parts = std::max(1.0, std::ceil(2 * std::sqrt(fastest) / params_.merge_mm));
    for (Vec3& move : moves)
        move /= parts;
    for (int part = 0; part < static_cast<int>(parts); ++part) {
        if (part > 0) of_faces_ = face_normals(mesh_);
        std::vector<Vec3> now = moves;
        limit_moves(mesh_, of_faces_, now);
        fields_.stop_at_obstacles(mesh_, now);
        stay_apart(now);
        for_each_index(now.size(), kWorthThreads,
                       [&](std::size_t v) { mesh_.position[v] += now[v]; });
    }
}

void SurfaceGrowth::follow_apices() {
    for (Apex& apex : apices_) {
        if (!apex.grows) continue;
        apex.travel += glm::distance(mesh_.position[apex.vertex], apex.path.back());
        apex.path.push_back(mesh_.position[apex.vertex]);
        apex.travels.push_back(apex.travel);
        mesh_.travel[apex.vertex] = apex.travel;
    }
}

void SurfaceGrowth::smooth() {
    const std::vector<Vec3> before = mesh_.position;
    smooth_along(mesh_, normals_, params_.smoothing, fields_.near_obstacle());
    std::vector<Vec3> moves(before.size());
    for (std::size_t v = 0; v < moves.size(); ++v)
        moves[v] = mesh_.position[v] - before[v];
    mesh_.position = before;
    stay_apart(moves);
    for (std::size_t v = 0; v < moves.size(); ++v)
        mesh_.position[v] += moves[v];
}

void SurfaceGrowth::remesh_all() {
    RemeshParams how{.split_mm = params_.split_mm,
                     .merge_mm = params_.merge_mm,
                     .winding_rad = params_.winding_rad,
                     .flips = params_.flips};
    if (!params_.obstacles.empty()) {
        how.is_barred = [this](const Vec3& a, const Vec3& b, const Vec3& c) {
            return fields_.is_barred(a, b, c);
        };
    }
    remesh(mesh_, apices_, how);
    close_channels(mesh_, {params_.merge_mm});
    for (Apex& apex : apices_)  // what was in a bubble has gone
        apex.grows = apex.grows && mesh_.tissue[apex.vertex] == Tissue::apex;
}

void SurfaceGrowth::step() {
    ++steps_;
    order_apices();
    fuse();
    fields_.begin(steps_, mesh_, apices_, normals_);
    mesh_.last = mesh_.position;
    move_all();
    follow_apices();
    smooth();
    remesh_all();
    if (mesh_.faces() > static_cast<std::size_t>(params_.face_limit))
        throw IoError("the tree has more faces than the limit of " +
                      std::to_string(params_.face_limit));
    of_faces_ = face_normals(mesh_);
    normals_ = vertex_normals(mesh_, of_faces_);
}

}  // namespace edaha
