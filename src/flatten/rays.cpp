// SPDX-License-Identifier: MIT
#include "flatten/rays.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/none.h"
#include "flatten/embree.h"

namespace edaha {
namespace {

// Depths of surfaces in one plane differ by rounding alone: an ulp of the farthest depth is one
// step.
constexpr float kTie = 2;
constexpr float kBeforeAll = -float(1 << 24);

RTCRay ray_at(Vec2 place, float far) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(place.x);
    ray.org_y = static_cast<float>(place.y);
    ray.org_z = kBeforeAll;
    ray.dir_z = 1;
    ray.tfar = far;
    ray.mask = ~0U;
    return ray;
}

float depth_of(float z) {
    return z - kBeforeAll;
}

// Rejects all hits, but remembers the lowest part's.
struct LowestPart : RTCIntersectContext {
    std::span<const std::uint32_t> part_of, shown;
    std::uint32_t triangle = kNone;
    float u = 0, v = 0;

    static void consider(const RTCFilterFunctionNArguments* args) {
        auto& self = *static_cast<LowestPart*>(args->context);
        args->valid[0] = 0;
        const std::uint32_t candidate = self.shown[RTCHitN_primID(args->hit, args->N, 0)];
        if (self.triangle != kNone && std::pair(self.part_of[self.triangle], self.triangle) <=
                                          std::pair(self.part_of[candidate], candidate))
            return;
        self.triangle = candidate;
        self.u = RTCHitN_u(args->hit, args->N, 0);
        self.v = RTCHitN_v(args->hit, args->N, 0);
    }
};

struct Strangers : RTCIntersectContext {
    std::span<const std::uint32_t> shown;
    std::array<std::uint32_t, 2> own{};

    static void consider(const RTCFilterFunctionNArguments* args) {
        const auto& self = *static_cast<const Strangers*>(args->context);
        const std::uint32_t candidate = self.shown[RTCHitN_primID(args->hit, args->N, 0)];
        if (candidate == self.own[0] || candidate == self.own[1]) args->valid[0] = 0;
    }
};

}  // namespace

struct RayScene::State {
    std::span<const std::uint32_t> part_of;
    std::vector<std::uint32_t> shown;  // the scene's triangles, as the mesh counts them
    std::vector<std::uint8_t> flush;
    EmbreeDevice device = embree_device();
    EmbreeScene scene;
};

RayScene::RayScene(const View& view, const Mesh& mesh, std::vector<std::uint8_t> flush)
    : state_(std::make_unique<State>()) {
    state_->part_of = mesh.part_of;
    state_->flush = std::move(flush);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (view.shown[i]) state_->shown.push_back(i);
    }
    EmbreeGeometry geometry(rtcNewGeometry(state_->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* points = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), view.at.size()));
    auto* corners = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(Triangle), state_->shown.size()));
    if (points == nullptr || (corners == nullptr && !state_->shown.empty())) throw std::bad_alloc();
    for (std::size_t i = 0; i < view.at.size(); ++i) {
        const ViewPoint p = view.at[i];
        points[3 * i] = float(p.x), points[3 * i + 1] = float(p.y), points[3 * i + 2] = float(p.z);
    }
    for (std::size_t i = 0; i < state_->shown.size(); ++i) {
        const Triangle& triangle = mesh.triangles[state_->shown[i]];
        std::copy(triangle.begin(), triangle.end(), corners + 3 * i);
    }
    state_->scene = embree_scene(state_->device.get(), std::move(geometry));
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;

std::optional<RayScene::Hit> RayScene::look(Vec2 place) const {
    RTCRayHit first{};
    first.ray = ray_at(place, HUGE_VALF);
    first.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(state_->scene.get(), &context, &first);
    if (first.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    LowestPart lowest;
    lowest.triangle = state_->shown[first.hit.primID];
    lowest.u = first.hit.u, lowest.v = first.hit.v;
    if (state_->flush[lowest.triangle]) {
        RTCRayHit again{};
        again.ray = ray_at(place, first.ray.tfar + kTie);
        again.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcInitIntersectContext(&lowest);
        lowest.filter = LowestPart::consider;
        lowest.part_of = state_->part_of;
        lowest.shown = state_->shown;
        rtcIntersect1(state_->scene.get(), &lowest, &again);
    }
    return Hit{lowest.triangle,
               first.ray.tfar + kBeforeAll,
               {1 - lowest.u - lowest.v, lowest.u, lowest.v}};
}

bool RayScene::is_hidden(Vec2 place, double z, std::array<std::uint32_t, 2> own) const {
    RTCRay ray = ray_at(place, depth_of(static_cast<float>(z)) - kNear);
    Strangers strangers;
    rtcInitIntersectContext(&strangers);
    strangers.filter = Strangers::consider;
    strangers.shown = state_->shown;
    strangers.own = own;
    rtcOccluded1(state_->scene.get(), &strangers, &ray);
    return ray.tfar < 0;
}

}  // namespace edaha
