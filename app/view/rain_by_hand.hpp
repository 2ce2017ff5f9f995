// Rain that a hand switches on and off: what it falls like, and how a scenario says so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.hpp"

namespace waterlight {

/// Overrides of `scenario` by which it rains so many drops a square metre and second, or not, from the start on. Its
/// first rain is changed and others end; where there is none, one is added whose drops the grid can carry. Throws
/// InputError where the rate is out of its range.
std::vector<std::string> rain_overrides(const Scenario& scenario, std::optional<double> drops_per_m2_s);

/// The rain among a scenario's sources that falls at any time.
std::vector<Rain> rain_of(const Scenario& scenario);

}  // namespace waterlight
