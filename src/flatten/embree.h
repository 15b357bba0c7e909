// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <new>
#include <type_traits>

#include <embree3/rtcore.h>

namespace edaha {

// Embree's handles, released when they go out of scope.
template <auto release>
struct EmbreeRelease {
    template <typename Handle>
    void operator()(Handle* handle) const {
        release(handle);
    }
};

using EmbreeDevice =
    std::unique_ptr<std::remove_pointer_t<RTCDevice>, EmbreeRelease<rtcReleaseDevice>>;
using EmbreeScene =
    std::unique_ptr<std::remove_pointer_t<RTCScene>, EmbreeRelease<rtcReleaseScene>>;
using EmbreeGeometry =
    std::unique_ptr<std::remove_pointer_t<RTCGeometry>, EmbreeRelease<rtcReleaseGeometry>>;

inline EmbreeDevice embree_device() {
    EmbreeDevice device(rtcNewDevice(nullptr));
    if (!device) throw std::bad_alloc();
    return device;
}

// Builds the scene of one geometry. Errors: std::bad_alloc.
inline EmbreeScene embree_scene(RTCDevice device, EmbreeGeometry geometry) {
    EmbreeScene scene(rtcNewScene(device));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene.get(), geometry.get());
    rtcCommitScene(scene.get());
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::bad_alloc();
    return scene;
}

}  // namespace edaha
