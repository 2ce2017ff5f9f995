// The keys of the light that a scenario may ask for: the sun's disc, colour, walls.
#pragma once

#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

/// Of [light].
void describe_sun(Visitor& v, SunSection& s);
/// Of [caustics.floor]: what the map lies on.
void describe_receiver(Visitor& v, ReceiverSection& s);
/// Of [caustics.walls].
void describe_walls(Visitor& v, WallsSection& s);
/// Of [water].
void describe_water_colour(Visitor& v, WaterColourSection& s);

}  // namespace waterlight
