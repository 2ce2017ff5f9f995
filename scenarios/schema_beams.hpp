// The keys of light in the water.
#pragma once

#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

/// Of [water]: what light meets on its way.
void describe_optics(Visitor& v, WaterOptics& o);
/// Of [caustics.beams].
void describe_beams(Visitor& v, BeamsSection& s);
/// Of [camera].
void describe_camera(Visitor& v, CameraSection& s);

}  // namespace waterlight
