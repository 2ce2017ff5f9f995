// What a picture of water must show, in closed form and double precision, without a word of the kernels: a pinhole,
// Snell's law at a plane, Fresnel's equations.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "caustics/camera.hpp"

namespace waterlight::test {

using std::numbers::pi;
inline constexpr double radian = pi / 180;

/// Where a pinhole sees a place, and the direction in which it sees a pixel. Pixel centres are whole numbers, y
/// upwards.
struct Pinhole {
    glm::dvec3 eye, forward, right, up;
    double pixel;  ///< width of a pixel, 1 along the view
    glm::dvec2 middle;

    explicit Pinhole(const Camera& camera)
        : eye(camera.position_m),
          forward(glm::normalize(camera.target_m - camera.position_m)),
          right(glm::normalize(std::hypot(forward.x, forward.y) < 1e-6
                                   ? glm::dvec3{1, 0, 0} * std::copysign(1.0, -forward.z)
                                   : glm::dvec3{forward.y, -forward.x, 0})),
          up(glm::cross(right, forward)),
          pixel(2 * std::tan(camera.fov_deg * radian / 2) / camera.size.y),
          middle(0.5 * glm::dvec2(camera.size) - 0.5) {}

    glm::dvec2 pixel_of(glm::dvec3 place) const {
        const glm::dvec3 to = place - eye;
        return middle + glm::dvec2{glm::dot(to, right), glm::dot(to, up)} / (glm::dot(to, forward) * pixel);
    }
    /// Towards a pixel, 1 along the view.
    glm::dvec3 ray(double i, double j) const {
        return forward + pixel * ((i - middle.x) * right + (j - middle.y) * up);
    }
    glm::dvec3 direction(double i, double j) const { return glm::normalize(ray(i, j)); }
    /// Solid angle of a pixel, sr, where it is small.
    double solid_angle(double i, double j) const { return pixel * pixel / std::pow(glm::length(ray(i, j)), 3); }
};

/// A plane of water, z = height + slope.(x, y), of index n.
struct WaterPlane {
    glm::dvec2 slope{0, 0};
    double n = 4.0 / 3.0;
    double height = 0;

    glm::dvec3 normal() const { return glm::normalize(glm::dvec3{-slope, 1}); }
    double above(glm::dvec3 place) const { return glm::dot(place - glm::dvec3{0, 0, height}, normal()); }

    /// The point of the surface through which an eye above it sees a place below it: Snell's quartic for the distance r
    /// of that point from the eye's foot, sin(angle above) = n sin(angle below), which rises with r, by bisection.
    glm::dvec3 crossing(glm::dvec3 eye, glm::dvec3 place) const {
        const double h = above(eye), d = -above(place);
        const glm::dvec3 foot = eye - h * normal(), to = place + d * normal() - foot;
        const double all = glm::length(to);
        double low = 0, high = all;
        for (int k = 0; k < 80; ++k) {
            const double r = 0.5 * (low + high), rest = all - r;
            (r / std::hypot(r, h) < n * rest / std::hypot(rest, d) ? low : high) = r;
        }
        return all > 0 ? foot + to * (0.5 * (low + high) / all) : foot;
    }
    /// Where a mirror image of a place stands.
    glm::dvec3 mirrored(glm::dvec3 place) const { return place - 2 * above(place) * normal(); }
};

/// Part of unpolarised light that a plane reflects, incident at cos_i in index n1 before index n2: mean of the squares
/// of Fresnel's amplitudes for both polarisations; 1 where all is reflected.
inline double reflected_part(double cos_i, double n1, double n2) {
    const double sin_t = n1 / n2 * std::sqrt(1 - cos_i * cos_i);
    if (sin_t >= 1) return 1;
    const double cos_t = std::sqrt(1 - sin_t * sin_t);
    const double s = (n1 * cos_i - n2 * cos_t) / (n1 * cos_i + n2 * cos_t);
    const double p = (n1 * cos_t - n2 * cos_i) / (n1 * cos_t + n2 * cos_i);
    return 0.5 * (s * s + p * p);
}

/// The mean of it over a diffuse light from the side of n1, weighted by the cosine.
inline double diffusely_reflected_part(double n1, double n2) {
    constexpr int parts = 200000;
    double sum = 0;
    for (int k = 0; k < parts; ++k) sum += reflected_part(std::sqrt((k + 0.5) / parts), n1, n2);
    return sum / parts;
}

}  // namespace waterlight::test
