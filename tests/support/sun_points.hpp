// A sun that is a disc, as many points: what the disc's maps are measured against.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "caustics/truth.hpp"

namespace waterlight::test {

/// `count` suns spread evenly over the disc of this half-angle about `centre` (Vogel's sunflower), each of its share.
inline std::vector<Sun> sun_points(const Sun& centre, double half_angle_deg, int count) {
    const double radian = std::numbers::pi / 180, golden = std::numbers::pi * (3 - std::sqrt(5.0));
    const glm::dvec3 to_sun = -centre.direction();
    const double az = centre.azimuth_deg * radian;
    const glm::dvec3 across{-std::sin(az), std::cos(az), 0}, up = glm::cross(to_sun, across);
    std::vector<Sun> suns;
    for (int i = 0; i < count; ++i) {
        const double r = std::tan(half_angle_deg * radian * std::sqrt((i + 0.5) / count)), turn = golden * i;
        const glm::dvec3 d = glm::normalize(to_sun + r * (std::cos(turn) * across + std::sin(turn) * up));
        suns.push_back({std::asin(d.z) / radian, std::atan2(d.y, d.x) / radian, centre.irradiance_w_m2 / count});
    }
    return suns;
}

/// `count` suns along the disc's diameter in the plane y = 0, of a sun overhead, each of the share of its chord: the
/// whole disc to waves that run along x.
inline std::vector<Sun> sun_chords(double half_angle_deg, int count) {
    std::vector<Sun> suns;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double u = 2 * (i + 0.5) / count - 1;
        suns.push_back({90 - std::abs(u) * half_angle_deg, u < 0 ? 180.0 : 0.0, std::sqrt(1 - u * u)});
        sum += suns.back().irradiance_w_m2;
    }
    for (Sun& sun : suns) sun.irradiance_w_m2 /= sum;
    return suns;
}

/// Sum of the truth over suns.
inline Field<double> truth_of(const std::vector<Sun>& suns, TruthSettings settings, const TruthSurface& surface) {
    Field<double> sum(settings.floor.plan.width, settings.floor.plan.height);
    for (const Sun& sun : suns) {
        settings.floor.sun = sun;
        const TruthMap map = truth_map(settings, surface);
        for (std::size_t k = 0; k < sum.size(); ++k) sum.data()[k] += map.irradiance.data()[k];
    }
    return sum;
}

}  // namespace waterlight::test
