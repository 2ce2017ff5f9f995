// From a scenario to its wave model.
#pragma once

#include <memory>
#include <string>

#include "scenarios/scenario.hpp"
#include "sim/airy.hpp"
#include "sim/shallow_water.hpp"
#include "sim/wave_model.hpp"

namespace waterlight {

namespace gpu {
class Context;
}

/// A wave model in its initial state, and the parts of its own interface that a report asks for.
struct BuiltModel {
    std::unique_ptr<WaveModel> model;
    const AiryModel* airy = nullptr;              ///< the same, where it is one
    const PrescribedModel* prescribed = nullptr;  ///< the same, where it is one
    const ShallowWaterModel* shallow = nullptr;   ///< the same, where it is one
    std::string sea;                              ///< what a spectrum or a buoy says about itself
};

/// Whether the scenario's wave model can compute on a Vulkan device.
bool has_vulkan_model(const Scenario& scenario);

/// Whether the method computes on one. One that does not leaves all to the CPU.
bool has_vulkan_method(FloorMethod method);

/// `context` is the device that was chosen, or null for the CPU: models that can then compute there. Throws InputError
/// where a data file cannot be used, gpu::Error where the device fails or cannot hold the model.
BuiltModel build_model(const Scenario& scenario, const std::shared_ptr<gpu::Context>& context = nullptr);

}  // namespace waterlight
