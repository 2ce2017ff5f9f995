// Pictures and fields of light in the water on a Vulkan device.
#pragma once

#include <memory>

#include "caustics/beam_renderer.hpp"
#include "gpu/context.hpp"

namespace waterlight {

/// Throws gpu::Error where the device fails, or cannot add up floats in a picture. Its functions throw InputError as
/// those of the CPU do, and gpu::Error.
std::unique_ptr<BeamRenderer> make_beam_renderer_vulkan(std::shared_ptr<gpu::Context> context);

}  // namespace waterlight
