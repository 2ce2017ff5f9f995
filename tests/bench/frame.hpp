// The benchmark of whole frames.
#pragma once

#include <memory>

#include "gpu/context.hpp"

namespace waterlight::bench {

/// Registers frame/vulkan/1280x720/... on this device. Waves run on the CPU; the floor map and beams where `--backend
/// auto` has them: on the device unless it is a CPU itself.
void register_frames(const std::shared_ptr<gpu::Context>& context);

}  // namespace waterlight::bench
