// What sun and sky bring to a scene, by the formulas of render/kernels.
#pragma once

#include <glm/vec3.hpp>
#include <numbers>

#include "render/look.hpp"
#include "render/scene.hpp"

namespace waterlight {

/// Half-angle of the sun's disc as seen from the earth, radians.
inline constexpr double sun_radius = solar_radius_deg * std::numbers::pi / 180;

/// Hemispherical reflectance of flat water of index n for a uniform sky; 0 without Fresnel's. 0.0660 at n = 4/3.
double diffuse_reflectance(double n, bool fresnel);

struct SkyLight {
    double scale = 0;  ///< radiance where the pattern is 1, W/(m2 sr)
    glm::dvec3 irradiance{0, 0,
                          0};  ///< of the three colours on the horizontal plane, W/m2; their mean is what was asked for
};

/// E0 of the sun where it is above the horizon, else 0.
double sunlight(const Sun& sun);

SkyLight sky_light(const Sky& sky, const Sun& sun);

/// Radiance of a white diffuse plane in sun and sky, W/(m2 sr); 1 where there is no light.
double white_radiance(const Sky& sky, const Sun& sun);

}  // namespace waterlight
