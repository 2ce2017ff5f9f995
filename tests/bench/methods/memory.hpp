// How much a work allocates: the program counts every `new`. What Embree and the threads' stacks take is not in it.
#pragma once

#include <cstdint>
#include <functional>

namespace waterlight::methods {

/// The most that was allocated at once during the work, beyond what was before, bytes.
std::int64_t peak_bytes(const std::function<void()>& work);

}  // namespace waterlight::methods
