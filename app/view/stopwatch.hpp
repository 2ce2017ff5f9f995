// How long a part of a frame takes.
#pragma once

#include <chrono>

namespace waterlight {

/// Adds the wall time of its life to a number of milliseconds.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum_ms) : sum_ms_(sum_ms) {}
    ~Stopwatch() { sum_ms_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& sum_ms_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace waterlight
