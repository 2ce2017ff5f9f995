// The parts of docs/methods.md.
#pragma once

#include <string>

#include "tests/bench/accuracy/report.hpp"

namespace waterlight::methods {

struct Options {
    accuracy::Options common{};
    std::string pictures{};   ///< the folder of docs/methods.md's pictures; empty: none are drawn
    std::string scenarios{};  ///< the folder of the shipped scenarios
};

/// Every method converges on water over a flat floor, or does not, and keeps the light.
void report_waves(const Options& options);
/// Error against time and memory on a pool, and who wins at equal error.
void report_pool(const Options& options);
/// What each can do, and which to choose.
void report_abilities();
/// Glass under photons of several numbers.
void report_cups(const Options& options);

}  // namespace waterlight::methods
