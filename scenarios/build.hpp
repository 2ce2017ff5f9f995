// From a scenario to what runs: which model and boundary hold where it leaves the choice, and the settings of each
// part.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "caustics/floor.hpp"
#include "scenarios/scenario.hpp"
#include "sim/airy.hpp"
#include "sim/wave_model.hpp"

namespace waterlight {

/// A wave model and why it was taken.
struct ModelDecision {
    ModelChoice model = ModelChoice::airy;  ///< never automatic
    std::vector<std::string> reasons;
};

ModelDecision resolve_model(const Scenario& scenario);
/// The sides as stated; those left open are periodic for the model prescribed and for a spectrum or a buoy, else walls.
Boundary resolve_boundary(const Scenario& scenario);
Grid grid_of(const Scenario& scenario);

/// A wave model in its initial state, and the parts of its own interface that a report asks for.
struct BuiltModel {
    std::unique_ptr<WaveModel> model;
    const AiryModel* airy = nullptr;              ///< the same, where it is one
    const PrescribedModel* prescribed = nullptr;  ///< the same, where it is one
    std::string sea;                              ///< what a spectrum or a buoy says about itself
};

/// Throws InputError where a data file cannot be used.
BuiltModel build_model(const Scenario& scenario);

/// Of the floor's map. The scenario has one.
FloorSettings floor_settings(const Scenario& scenario);

}  // namespace waterlight
