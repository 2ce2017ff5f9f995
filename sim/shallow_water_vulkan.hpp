// The shallow-water model on a Vulkan device.
#pragma once

#include <memory>

#include "gpu/context.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// The same scheme as make_shallow_water<float>(), from the same kernel texts. A step is one submission, of which only
/// the largest crossing rate comes back; surface(), state(), totals(), records() and sources bring the whole state to
/// the host. Throws InputError as make_shallow_water() does, gpu::Error where the device fails or cannot hold 16 bytes
/// a cell in one buffer; advance() throws WorldError as there, and gpu::Error.
std::unique_ptr<ShallowWaterModel> make_shallow_water_vulkan(const ShallowWaterSettings& settings,
                                                             std::shared_ptr<gpu::Context> context);

}  // namespace waterlight
