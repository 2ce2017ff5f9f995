// The sun and the water's optics.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

namespace waterlight {

/// Half-angle of the sun's disc as seen from the earth, degrees.
inline constexpr double solar_radius_deg = 0.2665;

/// The sun: parallel light.
struct Sun {
    double elevation_deg = 90;      ///< above the horizon; at or below 0 gives no light
    double azimuth_deg = 0;         ///< counter-clockwise from +x, towards the sun
    double irradiance_w_m2 = 1000;  ///< E0, on a plane that faces the beam, >= 0

    /// s, the unit vector along which the light travels.
    glm::dvec3 direction() const {
        constexpr double radian = std::numbers::pi / 180;
        const double el = elevation_deg * radian, az = azimuth_deg * radian;
        return {-std::cos(el) * std::cos(az), -std::cos(el) * std::sin(az), -std::sin(el)};
    }
};

/// Where scattered light goes (kernels/phase.glsl).
struct Phase {
    enum class Type { henyey_greenstein, fournier_forand, pure_water };
    Type type = Type::henyey_greenstein;
    double g = 0.9;         ///< of Henyey & Greenstein, mean cosine, in (-1, 1)
    double index = 1.10;    ///< of Fournier & Forand: of the particles, relative to the water, in (1, 1.35]
    double slope = 3.5835;  ///< of Fournier & Forand: of the particles' sizes, in (3, 5); both as Petzold's average
};

/// The water as light feels it.
struct WaterOptics {
    double refractive_index = 4.0 / 3.0;  ///< n >= 1
    bool fresnel = true;                  ///< false: all light enters
    double absorption_per_m = 0;          ///< >= 0
    double scattering_per_m = 0;          ///< >= 0
    Phase phase{};

    double extinction_per_m() const { return absorption_per_m + scattering_per_m; }
};

}  // namespace waterlight
