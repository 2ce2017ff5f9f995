// The one way in which Vulkan fails.
#pragma once

#include <stdexcept>

namespace waterlight::gpu {

/// No loader, no driver, no fitting device, no memory, or a call that the driver refused. The text names which, and
/// what helps. A failure of the world, not of the input.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace waterlight::gpu
