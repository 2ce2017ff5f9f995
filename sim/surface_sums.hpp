// What can be said of any surface by adding it up.
#pragma once

#include "sim/wave_model.hpp"

namespace waterlight {

/// Volume, variance, slope variance and highest elevation of `surface`, added in double, row by row: the same for any
/// number of threads. energy_j is NaN.
WaveDiagnostics surface_sums(const Surface& surface);

}  // namespace waterlight
