// Sines and standing waves as the start of shallow water.
#pragma once

#include <vector>

#include "sim/shallow_water.hpp"
#include "sim/sines.hpp"

namespace waterlight {

/// Adds the elevation of the waves at time 0 to the depth, which must be there as the velocity must, in wet cells only
/// and never below the ground. A sine gets the velocity of a simple wave that runs its way, 2 (sqrt(g (h + elevation))
/// - sqrt(g h)) with the still depth h of its cell: over a flat floor it sends nothing back. Standing waves start at
/// rest.
void add_waves(const std::vector<Sine>& sines, const std::vector<StandingWave>& standing,
               ShallowWaterSettings& settings);

}  // namespace waterlight
