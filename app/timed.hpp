// How long a piece of work takes.
#pragma once

#include <chrono>

namespace waterlight {

/// Does `work`, and adds the time it takes (s) to a stage's.
template <class Work>
void timed(double& stage_s, Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    stage_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace waterlight
