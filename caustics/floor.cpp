#include "caustics/floor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "caustics/floor_frame.hpp"
#include "sim/error.hpp"

namespace waterlight {

glm::dvec2 FloorPlan::axis_x() const {
    const double angle = angle_deg * std::numbers::pi / 180;
    return angle_deg == 0 ? glm::dvec2{1, 0} : glm::dvec2{std::cos(angle), std::sin(angle)};
}

glm::dvec2 FloorPlan::axis_y() const {
    const glm::dvec2 x = axis_x();
    return {-x.y, x.x};
}

glm::dvec2 FloorPlan::position_m(glm::dvec2 pixel) const {
    return origin_m + pixel.x * pitch_m.x * axis_x() + pixel.y * pitch_m.y * axis_y();
}

glm::dvec2 FloorPlan::pixel(glm::dvec2 position_m) const {
    const glm::dvec2 from = position_m - origin_m;
    return {glm::dot(from, axis_x()) / pitch_m.x, glm::dot(from, axis_y()) / pitch_m.y};
}

FloorPlan cover(const Grid& grid, int width, int height) {
    return {width, height, {grid.x0_m, grid.y0_m}, {grid.width_m() / width, grid.height_m() / height}, 0};
}

double FloorLedger::closure() const {
    const double in = incident_w + entered_w;
    const double out = reflected_w + extinguished_w + floor_w + outside_w + lost_w + objects_w;
    return in == 0 && out == 0 ? 0 : std::abs(in - out) / in;
}

namespace {

void require(bool good, std::string_view what, double found, std::string_view allowed) {
    if (!good) throw InputError(fmt::format("floor map: {} is {}; allowed: {}", what, found, allowed));
}

}  // namespace

void validate(const FloorSettings& s) {
    constexpr double most = 1e30;  // what floats hold with room for what a focus makes of it
    require(s.plan.width >= 1 && s.plan.height >= 1, "number of pixels along a side",
            std::min(s.plan.width, s.plan.height), ">= 1");
    require(s.plan.pitch_m.x > 0 && s.plan.pitch_m.y > 0, "pixel pitch in m",
            std::min(s.plan.pitch_m.x, s.plan.pitch_m.y), "> 0");
    require(s.samples_per_pixel >= 1, "samples per pixel", s.samples_per_pixel, ">= 1");
    require(s.depth_m > 0 && s.depth_m <= most, "depth in m", s.depth_m, "> 0, at most 1e30");
    require(s.optics.refractive_index >= 1, "refractive index", s.optics.refractive_index, ">= 1");
    require(s.optics.extinction_per_m() >= 0, "extinction in 1/m", s.optics.extinction_per_m(), ">= 0");
    require(s.sun.irradiance_w_m2 >= 0 && s.sun.irradiance_w_m2 <= most, "irradiance in W/m2", s.sun.irradiance_w_m2,
            ">= 0, at most 1e30");
    require(s.sun.elevation_deg <= 90, "sun elevation in degrees", s.sun.elevation_deg, "<= 90");
    if (!s.window) return;
    require(s.window->samples >= 1 && s.window->samples % 2 == 1, "window samples", s.window->samples, "odd, >= 1");
    require(s.window->channels >= 1 && s.window->channels % 2 == 1, "window channels", s.window->channels, "odd, >= 1");
}

}  // namespace waterlight
