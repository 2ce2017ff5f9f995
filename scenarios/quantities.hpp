// The numbers of a report that a [[check]] may judge.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace waterlight {

struct Scenario;

struct Quantity {
    std::string_view name;
    std::string_view unit;
    std::string_view meaning;
};

/// Those of the run as a whole; of the last frame unless their meaning says otherwise.
std::span<const Quantity> run_quantities();
/// Those of each probe; their full name is probe.NAME.quantity.
std::span<const Quantity> probe_quantities();
/// Whether only the model shallow-water has it.
bool is_of_shallow_water(std::string_view quantity);
/// Whether it is of the light on the floor or at a probe, if not of the run as a whole.
bool is_of_light(std::string_view quantity);
/// The full names that this scenario's checks may use.
std::vector<std::string> quantity_names(const Scenario& scenario);

}  // namespace waterlight
