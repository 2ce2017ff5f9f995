// The floor map's mapper with what the scenario asks of its light.
#pragma once

#include "caustics/spectral_floor.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

struct LitMapper {
    std::unique_ptr<FloorMapper> mapper;
    const SpectralFloor* spectral = nullptr;  ///< the same, where light is in colour
    /// What the back-end made for each wavelength, below the sun's disc; null before the first map.
    std::vector<std::shared_ptr<const FloorMapper*>> own;
};

/// `make` is the back-end: over it the sun's disc, and over that one map for each wavelength. Throws InputError where a
/// setting is out of its range.
LitMapper make_lit_mapper(const Scenario& scenario, const FloorSettings& settings, FloorMaker make);

}  // namespace waterlight
