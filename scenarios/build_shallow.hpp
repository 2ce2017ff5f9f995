// From a scenario to the settings of the model shallow-water.
#pragma once

#include "scenarios/scenario.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// With records kept. Throws InputError where a data file cannot be used.
ShallowWaterSettings shallow_settings(const Scenario& scenario);

/// Heights (m) of the ground that [domain] states: flat, or read from its file, and its shapes. Throws InputError where
/// the file cannot be used.
Field<double> stated_ground(const Scenario& scenario);

/// Depth (m) of the exact state that the scenario starts from, time_s after its start, as means over the cells; none
/// where it starts from no exact state.
std::optional<Field<double>> exact_depth(const Scenario& scenario, double time_s);

}  // namespace waterlight
