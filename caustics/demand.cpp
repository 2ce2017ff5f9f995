#include "caustics/demand.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <numbers>

#include "caustics/kernels/optics.hpp"

namespace waterlight {

double focusing(const Sun& sun, double refractive_index) {
    constexpr double step = 1e-5;
    constexpr double radian = std::numbers::pi / 180;
    const glm::dvec2 azimuth{std::cos(sun.azimuth_deg * radian), std::sin(sun.azimuth_deg * radian)};
    const auto travel = [&](double slope) {
        return f64::refract_sun(sun.direction(), slope * azimuth, refractive_index, 0).travel;
    };
    return glm::length(travel(step) - travel(-step)) / (2 * step);
}

double caustic_contrast(double k, double a, double depth_m, double focusing) { return depth_m * focusing * a * k * k; }

double focus_depth(double k, double a, double focusing) { return 1 / (focusing * a * k * k); }

glm::dvec2 landing_reach(double slope, double depth_m, double a, const Sun& sun, double refractive_index) {
    glm::dvec2 reach{0, 0};
    if (sun.elevation_deg <= 0) return reach;
    const glm::dvec3 s = sun.direction();
    const glm::dvec2 rest = depth_m * f64::refract_sun(s, {0, 0}, refractive_index, 0).travel;
    constexpr int directions = 32;
    for (int i = 0; i < directions; ++i) {
        const double angle = 2 * std::numbers::pi * i / directions;
        const glm::dvec2 facing = slope * glm::dvec2{std::cos(angle), std::sin(angle)};
        const f64::Refraction r = f64::refract_sun(s, facing, refractive_index, 0);
        if (!(r.incident > 0)) continue;
        for (const double elevation : {-a, a})
            reach = glm::max(reach, glm::abs((depth_m + elevation) * r.travel - rest));
    }
    return reach;
}

}  // namespace waterlight
