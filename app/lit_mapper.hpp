// The floor map's mapper with what the scenario asks of its light.
#pragma once

#include "caustics/spectral_floor.hpp"
#include "scenarios/scenario.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

struct LitMapper {
    std::unique_ptr<FloorMapper> mapper;
    const SpectralFloor* spectral = nullptr;  ///< the same, where light is in colour
};

/// Makes mappers on the CPU for the ground of this model.
FloorMaker ground_maker(const Scenario& scenario, const ShallowWaterModel& model);

/// `make` is the back-end: over it the sun's disc, and over that one map for each wavelength. Throws InputError where a
/// setting is out of its range.
LitMapper make_lit_mapper(const Scenario& scenario, const FloorSettings& settings, FloorMaker make);

}  // namespace waterlight
