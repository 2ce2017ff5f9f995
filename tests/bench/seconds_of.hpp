// How long a piece of work takes.
#pragma once

#include <chrono>

namespace waterlight {

/// Of the clock.
template <class Work>
double seconds_of(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace waterlight
