// The ground as the light meets it.
#pragma once

#include "scenarios/build.hpp"

namespace waterlight {

/// Heights (m) in the middle of the domain's cells: of the model where it has ground, else as the scenario states it;
/// empty over a flat floor. Throws InputError where a file of the ground cannot be used.
Field<float> ground_heights(const Scenario& scenario, const BuiltModel& model);

}  // namespace waterlight
