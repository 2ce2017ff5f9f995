// How the mouse and the keys move a camera: pure functions from one camera to the next. None rolls it, and none takes
// it over a pole: z stays up in the picture. Cameras are in the world, not mirrored.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "caustics/camera.hpp"

namespace waterlight {

/// The view never comes nearer to the vertical than this.
constexpr double pole_gap_deg = 1;

/// Goes round its target at the same distance: so many degrees counter-clockwise seen from above, and upwards.
Camera orbited(const Camera& camera, double azimuth_deg, double elevation_deg);

/// Shifts place and target in the picture's plane, so that what is at the target moves by `pixels`, y upwards.
Camera panned(const Camera& camera, glm::dvec2 pixels);

/// Goes nearer to its target by a tenth of the way for each notch, away for notches < 0; never nearer than
/// `nearest_m` > 0, nor farther than 1e6 m.
Camera zoomed(const Camera& camera, double notches, double nearest_m = 0.05);

/// Moves place and target: along the picture's right, along the view, and straight up, m.
Camera flown(const Camera& camera, glm::dvec3 right_forward_up_m);

/// Looks elsewhere from where it is: so many degrees counter-clockwise seen from above, and upwards.
Camera turned(const Camera& camera, double azimuth_deg, double elevation_deg);

}  // namespace waterlight
