#include "sim/disturbance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/sources.hpp"
#include "sim/round_spot.hpp"

namespace waterlight {

namespace {

void check(const Drop& drop) {
    if (!std::isfinite(drop.at_m.x) || !std::isfinite(drop.at_m.y)) throw InputError("drop: at_m must be two numbers");
    require_valid(Source(drop));
}

void check(const Push& push) {
    const bool holds = std::isfinite(push.at_m.x) && std::isfinite(push.at_m.y) && push.radius_m > 0 &&
                       std::isfinite(push.radius_m) && std::isfinite(push.volume_m3);
    if (!holds) throw InputError("push: at_m and volume_m3 must be numbers and radius_m above 0");
}

DropPatch patch(const Drop& drop, const Grid& grid, Boundary boundary) { return drop_patch(drop, grid, boundary); }

DropPatch patch(const Push& push, const Grid& grid, Boundary boundary) {
    check(push);
    const double height = push.volume_m3 / (std::numbers::pi * push.radius_m * push.radius_m);
    DropPatch patch{0, 0, Field<double>(grid.nx, grid.ny)};
    double sum = 0;
    RoundSpot(push.at_m, push.radius_m, grid, boundary).visit([&](int i, int j, double q) {
        const double gain = height * f64::push_profile(q);
        patch.elevation_m(i, j) += gain;
        sum += gain;
    });
    for (double& value : patch.elevation_m.values()) value -= sum / static_cast<double>(grid.cells());
    return patch;
}

}  // namespace

void require_valid(const Disturbance& disturbance) {
    std::visit([](const auto& d) { check(d); }, disturbance);
}

DropPatch patch_of(const Disturbance& disturbance, const Grid& grid, Boundary boundary) {
    return std::visit([&](const auto& d) { return patch(d, grid, boundary); }, disturbance);
}

double submerged_volume_m3(double centre_z_m, double radius_m) {
    // A cap of height d: pi d^2 (3 R - d) / 3.
    const double d = std::clamp(radius_m - centre_z_m, 0.0, 2 * radius_m);
    return std::numbers::pi * d * d * (3 * radius_m - d) / 3;
}

std::array<Push, 2> sphere_pushes(glm::dvec3 from_m, glm::dvec3 to_m, double radius_m) {
    return {Push{glm::dvec2(from_m), radius_m, -submerged_volume_m3(from_m.z, radius_m)},
            Push{glm::dvec2(to_m), radius_m, submerged_volume_m3(to_m.z, radius_m)}};
}

}  // namespace waterlight
