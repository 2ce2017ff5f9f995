// From a scenario to its wave model.
#pragma once

#include <memory>
#include <string>

#include "scenarios/scenario.hpp"
#include "sim/airy.hpp"
#include "sim/wave_model.hpp"

namespace waterlight {

/// A wave model in its initial state, and the parts of its own interface that a report asks for.
struct BuiltModel {
    std::unique_ptr<WaveModel> model;
    const AiryModel* airy = nullptr;              ///< the same, where it is one
    const PrescribedModel* prescribed = nullptr;  ///< the same, where it is one
    std::string sea;                              ///< what a spectrum or a buoy says about itself
};

/// Throws InputError where a data file cannot be used.
BuiltModel build_model(const Scenario& scenario);

}  // namespace waterlight
