// The devices of this machine in words.
#pragma once

#include <string>

namespace waterlight {

/// The processor and every Vulkan device, usable or not and why, and what --backend auto takes.
std::string devices_text();

}  // namespace waterlight
