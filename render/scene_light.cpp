#include "render/scene_light.hpp"

#include <cmath>
#include <numbers>

#include "render/kernels/sky.hpp"
#include "render/kernels/view_ray.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

/// Irradiance of the clear sky's pattern where its radiance is 1 times the pattern: midpoints over the hemisphere.
glm::dvec3 pattern_irradiance(glm::dvec3 to_sun) {
    constexpr int rings = 48, sectors = 96;
    glm::dvec3 sum{0, 0, 0};
    for (int i = 0; i < rings; ++i) {
        const double z = std::sqrt((i + 0.5) / rings), across = std::sqrt(1 - z * z);
        for (int j = 0; j < sectors; ++j) {
            const double azimuth = 2 * pi * (j + 0.5) / sectors;
            const glm::dvec3 d{across * std::cos(azimuth), across * std::sin(azimuth), z};
            sum += f64::clear_sky(z, glm::dot(d, to_sun)) * f64::sky_tint(z);
        }
    }
    return sum * (pi / (rings * sectors));
}

double asked_irradiance(const Sky& sky, const Sun& sun) { return sky.irradiance_w_m2.value_or(sunlight(sun) / 6); }

}  // namespace

double diffuse_reflectance(double n, bool fresnel) {
    if (!fresnel || n <= 1) return 0;
    constexpr int parts = 512;
    double sum = 0;
    for (int k = 0; k < parts; ++k) {
        const double square = (k + 0.5) / parts, cos_i = std::sqrt(square);
        const double cos_t = std::sqrt(1 - (1 - square) / (n * n));
        sum += 1 - f64::fresnel_transmittance(cos_i, cos_t, n);
    }
    return sum / parts;
}

double sunlight(const Sun& sun) { return sun.elevation_deg > 0 ? sun.irradiance_w_m2 : 0; }

SkyLight sky_light(const Sky& sky, const Sun& sun) {
    const double asked = asked_irradiance(sky, sun);
    if (sky.type == Sky::Type::uniform) return {asked / pi, glm::dvec3(asked)};
    const glm::dvec3 irradiance = pattern_irradiance(-sun.direction());
    const double scale = 3 * asked / (irradiance.x + irradiance.y + irradiance.z);
    return {scale, scale * irradiance};
}

double white_radiance(const Sky& sky, const Sun& sun) {
    const double all = sunlight(sun) * std::max(0.0, -sun.direction().z) + asked_irradiance(sky, sun);
    return all > 0 ? all / pi : 1;
}

}  // namespace waterlight
