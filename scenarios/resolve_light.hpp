// The light that a scenario asks for.
#pragma once

#include "caustics/walls.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

/// Wavelengths with their shares and their water, in the scenario's order; none for light of one colour.
std::vector<Band> bands_of(const Scenario& scenario);
/// Of the walls, for light of one colour. The scenario has them.
WallSettings wall_settings(const Scenario& scenario);

/// Irradiance (W/m2) on the floor below flat water, over all wavelengths; of a lamp straight below it, through air.
double still_irradiance(const Scenario& scenario);

}  // namespace waterlight
