// How long a piece of work takes.
#pragma once

#include <chrono>

namespace waterlight {

/// Seconds of the steady clock.
inline double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Does `work`, and adds the time it takes (s) to a stage's.
template <class Work>
void timed(double& stage_s, Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    stage_s += seconds_since(start);
}

}  // namespace waterlight
