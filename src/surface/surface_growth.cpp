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
#include "surface/spatial_order.h"

namespace edaha {

namespace {

constexpr std::size_t kWorthThreads = 2000;
// Of T_m. Sheets are sewn as soon as they are nearer than that: before any edge of one, which are
// chords, could reach into the other, and so that the folds that are left round the seam, narrower
// than T_m, close by re-meshing. What can't be sewn stays apart by half of that.
constexpr double kMeeting = 0.5;
constexpr double kApart = 0.25;
constexpr double kRetreat = 0.05;  // of T_m in a step, until nothing passes through
// Of T_m. Boxes in the grid are that much wider than faces need within a step: with less more of
// them are put anew in each step, with more more are found in vain.
constexpr double kCreep = 0.1;
// Of T_m. What grows faster in a step never rests: the paper's S_c is just slower. What rests is
// further than the horizon from meeting anything: a longer one lets it rest for longer, and costs
// more to look round.
constexpr double kFast = 0.045;
constexpr double kHorizon = 0.5;
// Sewing brings new neighbours: what they meet is looked for again, this often a step.
constexpr int kFusionRounds = 1;

constexpr std::int64_t kStepsInOrder = 8;  // that the order in space is good enough for

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
      fields_(params, random),
      grid_(2 * params.split_mm, kCreep * params.merge_mm) {
    Apex trunk;
    trunk.vertex = only_apex(mesh_);
    trunk.state = first_apex(*rules_, params.speed_mm, params.thickening_mm);
    apices_.push_back(std::move(trunk));
    sprout(mesh_, apices_, 0);
    // The seed is all as it will be after its first remeshing: edges within T_s from the start.
    remesh(mesh_, apices_, {params.split_mm, params.merge_mm, 0, params.flips, {}});
    mesh_.last = mesh_.position;
    find_normals();
}

// An apex looks where it goes: its faces, as it turns, need not.
void SurfaceGrowth::find_normals() {
    of_faces_ = face_normals(mesh_);
    normals_ = vertex_normals(mesh_, of_faces_);
    for (const Apex& apex : apices_)
        if (apex.grows) normals_[apex.vertex] = apex.state.frame[0];
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

// What a step would bring if nothing were in the way. It goes in as many equal parts as the fastest
// vertex needs to go T_m / 2 at most in each, so that no face is passed through unseen.
void SurfaceGrowth::plan_moves() {
    moves_ = growth_vectors();
    stay_on_ground(mesh_, moves_);
    slides_ = slides(mesh_, normals_, params_.smoothing);
    double fastest = 0;
    for (const Vec3& move : moves_)
        fastest = std::max(fastest, glm::dot(move, move));
    parts_ = std::max(1, static_cast<int>(std::ceil(2 * std::sqrt(fastest) / params_.merge_mm)));
}

std::vector<std::uint32_t> SurfaceGrowth::growing_apices() const {
    std::vector<std::uint32_t> growing;
    for (const Apex& apex : apices_)
        if (apex.grows) growing.push_back(apex.vertex);
    return growing;
}

// What runs into the tree itself merges with it (5.3).
void SurfaceGrowth::fuse() {
    const BarsFace is_barred = [this](const Vec3& a, const Vec3& b, const Vec3& c) {
        return fields_.is_barred(a, b, c);
    };
    const RestParams rest{kFast * params_.merge_mm, kHorizon * params_.merge_mm};
    std::vector<FaceBox> boxes;
    for (int round = 0; round <= kFusionRounds; ++round) {
        plan_moves();
        wake_fast(mesh_, moves_, rest.fast_mm);
        const StepPlan plan{of_faces_, normals_, moves_, slides_};
        boxes = boxes_of_ways(mesh_, plan, kRetreat * params_.merge_mm);
        grid_.put_all(boxes);
        const std::vector<std::uint32_t> growing = growing_apices();
        const FacingParams how{kMeeting * params_.merge_mm, rest, growing};
        wake_before(mesh_, plan, grid_, how);
        facing_ = facing_pairs(mesh_, plan, grid_, how);
        mesh_.vertex_rest = facing_.rest;  // what is in a pair does not rest
        if (round == kFusionRounds) break;
        const Fusions fusions =
            fuse_facing(mesh_, apices_, facing_.pairs, normals_, {is_barred, &grid_});
        report_.fusions += fusions.sewn;
        report_.pins = fusions.pinned;
        if (fusions.sewn == 0) break;
        find_normals();
    }
    watch(boxes, rest);
}

// What could pass through each other in this step and has to be looked at as it moves.
void SurfaceGrowth::watch(std::span<const FaceBox> boxes, const RestParams& rest) {
    const std::vector<std::uint8_t> is_watched =
        watched_faces(mesh_, of_faces_, facing_.pairs, suspects_);
    close_ = close_faces(mesh_, {of_faces_, normals_, moves_, slides_}, grid_,
                         {rest, is_watched, boxes, close_});
    closest_ = closest(close_);
    suspects_.clear();
}

void SurfaceGrowth::stay_apart(std::vector<Vec3>& moves) {
    const std::vector<std::uint32_t> back =
        keep_apart(mesh_, normals_, grid_,
                   {kApart * params_.merge_mm, kRetreat * params_.merge_mm / (parts_ + 1),
                    facing_.pairs, closest_, suspects_},
                   moves);
    suspects_.insert(suspects_.end(), back.begin(), back.end());
}

void SurfaceGrowth::move_all() {
    for (Vec3& move : moves_)
        move /= parts_;
    for (int part = 0; part < parts_; ++part) {
        if (part > 0) of_faces_ = face_normals(mesh_);
        std::vector<Vec3> now = moves_;
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

void SurfaceGrowth::slide_all() {
    const std::span<const std::uint8_t> still = fields_.near_obstacle();
    for (std::size_t v = 0; v < still.size(); ++v)
        if (still[v] != 0) slides_[v] = Vec3(0);
    stay_apart(slides_);
    for (std::size_t v = 0; v < slides_.size(); ++v)
        mesh_.position[v] += slides_[v];
}

void SurfaceGrowth::remesh_all() {
    RemeshParams how{.split_mm = params_.split_mm,
                     .merge_mm = params_.merge_mm,
                     .winding_rad = params_.winding_rad,
                     .flips = params_.flips,
                     .grid = &grid_};
    if (!params_.obstacles.empty()) {
        how.is_barred = [this](const Vec3& a, const Vec3& b, const Vec3& c) {
            return fields_.is_barred(a, b, c);
        };
    }
    remesh(mesh_, apices_, how);
    close_channels(mesh_, {.narrow_mm = params_.merge_mm, .grid = &grid_});
    for (Apex& apex : apices_)  // what was in a bubble has gone
        apex.grows = apex.grows && mesh_.tissue[apex.vertex] == Tissue::apex;
}

void SurfaceGrowth::renumber() {
    const Renumbering numbers = sort_in_space(mesh_, params_.merge_mm);
    for (Apex& apex : apices_) {
        const std::uint32_t v = numbers.vertex[apex.vertex];
        apex.vertex = v == kNone ? 0 : v;  // of one that has ended
    }
    fields_.renumber(numbers.vertex);
    grid_.renumber(numbers.face);
    for (ClosePair& pair : close_)
        for (std::uint32_t& f : pair.faces)
            f = numbers.face[f];
    std::erase_if(close_, [](const ClosePair& pair) {
        return pair.faces[0] == kNone || pair.faces[1] == kNone;
    });
    for (std::uint32_t& v : suspects_)
        v = numbers.vertex[v];
    std::erase(suspects_, kNone);
}

void SurfaceGrowth::step() {
    ++steps_;
    order_apices();
    fields_.begin(steps_, mesh_, apices_, normals_);
    fuse();
    mesh_.last = mesh_.position;
    move_all();
    follow_apices();
    slide_all();
    remesh_all();
    if (mesh_.faces() > static_cast<std::size_t>(params_.face_limit))
        throw IoError("the tree has more faces than the limit of " +
                      std::to_string(params_.face_limit));
    if (steps_ % kStepsInOrder == 0) renumber();
    find_normals();
}

}  // namespace edaha
