// What a floor map asks of the waves above it and of its own pixels, from one wave at a time and before anything is
// run.
#pragma once

namespace waterlight {

/// Contrast of the light (relative amplitude of its first harmonic, far before the focus) that a wave of wave number k
/// (rad/m) and amplitude a (m) casts on a floor at depth D (m) under water of refractive index n: D (1 - 1/n) a k^2,
/// a quarter of D a k^2 in water. From 1 on the light comes to a focus above the floor.
double caustic_contrast(double k, double a, double depth_m, double refractive_index);

/// Depth (m) of the first focus below a wave: 1 / ((1 - 1/n) a k^2).
double focus_depth(double k, double a, double refractive_index);

/// How far (m) from where flat water would send it the light of a slope lands: (D + a) tan(delta) with Snell's exact
/// angle for the sun overhead.
double landing_distance(double slope, double depth_m, double a, double refractive_index);

}  // namespace waterlight
