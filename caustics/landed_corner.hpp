// Corners of a mesh of the surface whose light is landed in double precision, and the light of a triangle of them.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace waterlight {

struct LandedCorner {
    glm::dvec3 start_m{0, 0, 0};  ///< on the surface
    glm::dvec2 pixel{0, 0};       ///< of the map, where its light lands
    double transmittance = 0;     ///< Fresnel
    double remaining = 0;         ///< of what entered, where it lands
};

/// Powers of a triangle, W per W/m2 of the sun.
struct TrianglePower {
    double incident = 0;
    double entered = 0;  ///< through the surface
    double arrived = 0;
};

/// `direction` is the sun's. The incident power is that through the triangle's own plane, -s.A, so that without
/// refraction landed power over landed area is sin(elevation) to rounding.
inline TrianglePower triangle_power(const LandedCorner& a, const LandedCorner& b, const LandedCorner& c,
                                    glm::dvec3 direction) {
    const glm::dvec3 twice_area = glm::cross(b.start_m - a.start_m, c.start_m - a.start_m);
    const double incident = std::max(0.0, -0.5 * glm::dot(direction, twice_area));
    const double entered = incident * (a.transmittance + b.transmittance + c.transmittance) / 3;
    return {incident, entered, entered * (a.remaining + b.remaining + c.remaining) / 3};
}

}  // namespace waterlight
