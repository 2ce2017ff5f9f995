// Caustics mapping on a Vulkan device.
#pragma once

#include <memory>

#include "caustics/splat/splat.hpp"
#include "gpu/context.hpp"

namespace waterlight {

/// Water alone is done on the device; light among objects is followed by the host, and landed and splatted on the
/// device. Splats are boxes of fragments, added in order: the same map for the same frame. Throws InputError where a
/// setting is out of its range, gpu::Error where the device fails. compute() throws InputError where there are more
/// than 2^23 vertices, and gpu::Error.
std::unique_ptr<SplatFloor> make_splat_floor_vulkan(const SplatSettings& settings,
                                                    std::shared_ptr<gpu::Context> context);

}  // namespace waterlight
