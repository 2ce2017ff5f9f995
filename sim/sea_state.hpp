// A random sea on the modes of a periodic grid.
#pragma once

#include "sim/airy.hpp"
#include "sim/airy_modes.hpp"

namespace waterlight {

/// Each wave vector (i, j) of the grid gets the variance that the spectrum holds in its cell of wave-number space,
/// E(k) = S(f, theta) cg / (2 pi k), and a phase drawn from (seed, i, j) alone: a finer grid of the same size carries
/// the same long waves. Amplitudes are not random. The axes must be periodic.
SeaCoverage add_sea(const Sea& sea, const AiryModes& modes, AiryState& state);

}  // namespace waterlight
