// The exact state of scenarios that have one in closed form.
#pragma once

#include <optional>
#include <string_view>

#include "scenarios/scenario.hpp"
#include "sim/field.hpp"

namespace waterlight {

/// Whether exact_field() knows it. `field` is named as in scenarios/quantities.hpp.
bool has_exact(const Scenario& scenario, std::string_view field);

/// Values at the cells, time_s after the start, of
///   - surface.depth of an exact state in waves.initial: means over the cells;
///   - surface.elevation and its slopes of standing waves, and of sines between periodic sides, alone on still water:
///     at the cells' centres, with the frequency of the model's own equation, not of its grid.
/// The scenario has_exact().
Field<double> exact_field(const Scenario& scenario, std::string_view field, double time_s);

}  // namespace waterlight
