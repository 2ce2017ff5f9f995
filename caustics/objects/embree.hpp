// Embree's handles, released when they go. Not part of the public headers.
#pragma once

#include <embree3/rtcore.h>

#include <memory>

#include "caustics/objects/object_set.hpp"

namespace waterlight::embree {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using Scene = std::unique_ptr<RTCSceneTy, ReleaseScene>;
using Geometry = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

/// A device that builds on the calling thread. Throws WorldError.
Device make_device();
/// Throws WorldError with what the device says went wrong, if anything did.
void check(const Device& device);
/// For rtcIntersect1, from the ray's start: what is nearer than nearest_m the callbacks refuse.
RTCRayHit ray_query(const Ray& ray);

}  // namespace waterlight::embree
