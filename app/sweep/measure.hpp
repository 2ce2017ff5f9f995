// One setting run and judged.
#pragma once

#include <filesystem>

#include "app/sweep/reference.hpp"
#include "app/sweep/result.hpp"

namespace waterlight {

/// Runs the setting options.repeats times without writing its files, and compares it at the times of the comparison
/// with the reference and with the truth of its own surface; the latter is kept as `truth` with the number of the time
/// and .vti appended. What fails in the run ends up in the result.
SettingResult measure(const SweepOptions& options, const Comparison& comparison, const Setting& setting,
                      const Reference& reference, const std::filesystem::path& truth);

}  // namespace waterlight
