#include "caustics/objects/embree.hpp"

#include <fmt/format.h>

#include "sim/error.hpp"

namespace waterlight::embree {

namespace {

const char* words(RTCError error) {
    switch (error) {
        case RTC_ERROR_OUT_OF_MEMORY:
            return "out of memory";
        case RTC_ERROR_UNSUPPORTED_CPU:
            return "this processor is not supported";
        case RTC_ERROR_INVALID_ARGUMENT:
            return "invalid argument";
        case RTC_ERROR_INVALID_OPERATION:
            return "invalid operation";
        default:
            return "unknown error";
    }
}

[[noreturn]] void fail(RTCError error) { throw WorldError(fmt::format("Embree: {}", words(error))); }

}  // namespace

Device make_device() {
    Device device(rtcNewDevice("threads=1,set_affinity=0"));
    if (!device) fail(rtcGetDeviceError(nullptr));
    return device;
}

void check(const Device& device) {
    const RTCError error = rtcGetDeviceError(device.get());
    if (error != RTC_ERROR_NONE) fail(error);
}

RTCRayHit ray_query(const Ray& ray) {
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(ray.from_m.x);
    query.ray.org_y = static_cast<float>(ray.from_m.y);
    query.ray.org_z = static_cast<float>(ray.from_m.z);
    query.ray.dir_x = static_cast<float>(ray.direction.x);
    query.ray.dir_y = static_cast<float>(ray.direction.y);
    query.ray.dir_z = static_cast<float>(ray.direction.z);
    query.ray.tfar = static_cast<float>(ray.farthest_m);
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return query;
}

}  // namespace waterlight::embree
