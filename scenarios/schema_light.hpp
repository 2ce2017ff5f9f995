// The keys of light in colour and of the sun's disc.
#pragma once

#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

/// Of [light].
void describe_sun(Visitor& v, SunSection& s);
/// Of [water].
void describe_water_colour(Visitor& v, WaterColourSection& s);

}  // namespace waterlight
