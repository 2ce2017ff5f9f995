// Where places of the world are in a picture: predictors of the tests, in double.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "caustics/camera.hpp"

namespace waterlight::test {

inline constexpr double n_water = 4.0 / 3.0;

/// The pixel, whole numbers at its centre, in which a straight ray shows a place before the camera.
inline glm::dvec2 pixel_of(const Camera& camera, glm::dvec3 place) {
    const Camera::Rays rays = camera.rays();
    const glm::dvec3 d = place - camera.position_m, r = d / glm::dot(d, rays.forward) - rays.corner;
    return {glm::dot(r, rays.right) / glm::dot(rays.right, rays.right),
            glm::dot(r, rays.up) / glm::dot(rays.up, rays.up)};
}

/// Where light from `place` in the water leaves it for an eye in the air, by Snell's law: sin(air) = n sin(water) for
/// the angles to the normal of the plane z = slope . (x, y). The way lies in the plane of the normal and both ends;
/// found by bisection on the line between their feet.
inline glm::dvec3 leaves_water(glm::dvec3 eye, glm::dvec3 place, double n, glm::dvec2 slope = {0, 0}) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3{-slope.x, -slope.y, 1});
    const double above = glm::dot(eye, normal), below = -glm::dot(place, normal);
    const glm::dvec3 from = eye - above * normal, to = place + below * normal;
    const double whole = glm::length(to - from);
    double low = 0, high = 1;
    for (int step = 0; step < 60; ++step) {
        const double part = 0.5 * (low + high), air = part * whole, water = whole - air;
        const bool too_far = air / std::hypot(air, above) > n * water / std::hypot(water, below);
        (too_far ? high : low) = part;
    }
    return from + 0.5 * (low + high) * (to - from);
}

/// Fresnel's reflectance of unpolarised light by its two amplitudes, from the sine of the angle on the side it comes
/// from; n is the index of the other side over that of this one. 1 where all is reflected.
inline double reflectance(double sine, double n) {
    if (sine >= n) return 1;
    const double in = std::sqrt(1 - sine * sine), out = std::sqrt(1 - sine * sine / (n * n));
    const double s = (in - n * out) / (in + n * out), p = (n * in - out) / (n * in + out);
    return 0.5 * (s * s + p * p);
}

}  // namespace waterlight::test
