// The floor map on a Vulkan device.
#pragma once

#include <memory>

#include "caustics/floor.hpp"
#include "gpu/context.hpp"

namespace waterlight {

/// Throws InputError where a setting is out of its range, gpu::Error where the device fails. compute() throws
/// InputError where the window is so wide that one row of channels overflows the device's bound, and gpu::Error.
/// The device's memory in use stays below 300 MB beside the surface and the map, whatever the window.
std::unique_ptr<FloorMapper> make_floor_vulkan(const FloorSettings& settings, std::shared_ptr<gpu::Context> context);

}  // namespace waterlight
