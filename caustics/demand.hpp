// What a floor map asks of the waves above it and of its own pixels, from one wave at a time and before anything is
// run.
#pragma once

#include <glm/vec2.hpp>

#include "caustics/light.hpp"

namespace waterlight {

/// How far (m per m of depth and unit of slope) a small slope moves the light of this sun, which is above the horizon,
/// through water of refractive index n: the derivative of refract_sun() along the sun's azimuth, where it is largest.
/// (1 - cos i / (n cos t)) / cos^2 t; 1 - 1/n overhead.
double focusing(const Sun& sun, double refractive_index);

/// Contrast of the light (relative amplitude of its first harmonic, far before the focus) that a wave of wave number k
/// (rad/m) and amplitude a (m) casts on a floor at depth D (m) along the sun's azimuth: D a k^2 times focusing(). From
/// 1 on the light comes to a focus above the floor.
double caustic_contrast(double k, double a, double depth_m, double focusing);

/// Depth (m) of the first focus below a wave: 1 / (a k^2 times focusing()).
double focus_depth(double k, double a, double focusing);

/// How far (m, along x and y) from where water at rest would send it the light of slopes up to `slope`, whichever way
/// they face, lands at most on a floor at this depth below water raised or lowered by `a`: by refract_sun(), of what
/// the sun lights. 0 where it is not above the horizon.
glm::dvec2 landing_reach(double slope, double depth_m, double a, const Sun& sun, double refractive_index);

}  // namespace waterlight
