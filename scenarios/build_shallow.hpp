// From a scenario to the settings of the model shallow-water.
#pragma once

#include "scenarios/scenario.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// With records kept. Throws InputError where a data file cannot be used.
ShallowWaterSettings shallow_settings(const Scenario& scenario);

/// Depth (m) of the exact state that the scenario starts from, time_s after its start, as means over the cells; none
/// where it starts from no exact state.
std::optional<Field<double>> exact_depth(const Scenario& scenario, double time_s);

}  // namespace waterlight
