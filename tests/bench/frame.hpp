// The benchmark of whole pictures.
#pragma once

#include <memory>

#include "gpu/context.hpp"

namespace waterlight::bench {

/// Registers frame/vulkan/1280x720/pool and frame/vulkan/1280x720/sea.
void register_frames(const std::shared_ptr<gpu::Context>& context);

}  // namespace waterlight::bench
