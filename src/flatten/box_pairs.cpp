// SPDX-License-Identifier: MIT
#include "flatten/box_pairs.h"

#include <tbb/enumerable_thread_specific.h>

#include "flatten/embree.h"

namespace edaha {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;
using PairsByThread = tbb::enumerable_thread_specific<Pairs>;

void tell_bounds(const RTCBoundsFunctionArguments* args) {
    const ViewBox& box = static_cast<const ViewBox*>(args->geometryUserPtr)[args->primID];
    RTCBounds& bounds = *args->bounds_o;
    bounds.lower_x = box.min[0], bounds.lower_y = box.min[1], bounds.lower_z = box.min[2];
    bounds.upper_x = box.max[0], bounds.upper_y = box.max[1], bounds.upper_z = box.max[2];
}

// Each pair is reported both ways.
void keep(void* user, RTCCollision* collisions, unsigned count) {
    Pairs& pairs = static_cast<PairsByThread*>(user)->local();
    for (unsigned i = 0; i < count; ++i) {
        const auto& [unused0, a, unused1, b] = collisions[i];
        if (a < b) pairs.push_back({a, b});
    }
}

}  // namespace

Pairs overlapping_pairs(std::span<const ViewBox> boxes) {
    const EmbreeDevice device = embree_device();
    EmbreeGeometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes.size()));
    // Embree only hands it back to tell_bounds().
    rtcSetGeometryUserData(geometry.get(), const_cast<ViewBox*>(boxes.data()));
    rtcSetGeometryBoundsFunction(geometry.get(), tell_bounds, nullptr);
    const EmbreeScene scene = embree_scene(device.get(), std::move(geometry));
    PairsByThread found;
    rtcCollide(scene.get(), scene.get(), keep, &found);
    Pairs pairs;
    for (const Pairs& some : found)
        pairs.insert(pairs.end(), some.begin(), some.end());
    return pairs;
}

}  // namespace edaha
