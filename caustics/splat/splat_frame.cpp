#include "caustics/splat/splat_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "caustics/floor_frame.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

void require(bool good, std::string_view what, double found, std::string_view allowed) {
    if (!good) throw InputError(fmt::format("splats: {} is {}; allowed: {}", what, found, allowed));
}

void validate(const Lamp& lamp, double level) {
    require(lamp.intensity_w_sr >= 0 && lamp.intensity_w_sr <= 1e30, "intensity of the lamp in W/sr",
            lamp.intensity_w_sr, ">= 0, at most 1e30");
    require(lamp.at_m.z > std::max(0.0, level), "height of the lamp in m", lamp.at_m.z, "above the water");
    if (lamp.type == Lamp::Type::point) return;
    require(lamp.half_angle_deg > 0 && lamp.half_angle_deg < 90, "half-angle of the lamp in degrees",
            lamp.half_angle_deg, "in (0, 90)");
    require(lamp.towards_m != lamp.at_m, "distance of what the lamp points at in m", 0, "> 0");
}

f64::SplatLight light_of(const SplatSettings& s) {
    const double level = image_level_m(s);
    if (!s.lamp) {
        const bool lit = s.floor.sun.elevation_deg > 0;
        const glm::dvec3 direction = lit ? s.floor.sun.direction() : glm::dvec3{0, 0, -1};
        return {{direction, 1, level}, lit ? s.floor.sun.irradiance_w_m2 : 0, {0, 0, -1}, -2};
    }
    constexpr double radian = std::numbers::pi / 180;
    const bool spot = s.lamp->type == Lamp::Type::spot;
    return {{s.lamp->at_m, 0, level},
            s.lamp->intensity_w_sr,
            spot ? glm::normalize(s.lamp->towards_m - s.lamp->at_m) : glm::dvec3{0, 0, -1},
            spot ? std::cos(s.lamp->half_angle_deg * radian) : -2};
}

/// How many vertices make an extent, of which the longer one has `grid`.
int vertices_along(double extent, double longest, int grid) {
    return std::max(1, static_cast<int>(std::lround(grid * extent / longest)));
}

}  // namespace

void validate(const SplatSettings& s) {
    validate(s.floor);
    const SplatOptions& o = s.options;
    require(o.grid >= 2 && o.grid <= 16384, "number of vertices along an axis", o.grid, "in [2, 16384]");
    require(o.iterations >= 1 && o.iterations <= 1000, "number of iterations", o.iterations, "in [1, 1000]");
    require(o.radius_pixels > 0 && o.radius_pixels <= 1e6, "radius in pixels", o.radius_pixels, "> 0, at most 1e6");
    require(o.bounces >= 1 && o.bounces <= 1000, "number of bounces", o.bounces, "in [1, 1000]");
    if (s.lamp) validate(*s.lamp, image_level_m(s));
}

double image_level_m(const SplatSettings& s) {
    return s.bed_m && !s.bed_m->empty() ? *std::ranges::min_element(s.bed_m->values()) : -s.floor.depth_m;
}

SplatFrame splat_frame(const SplatSettings& s, const Surface& surface) {
    const Grid& g = surface.grid;
    SplatFrame f;
    f.light = light_of(s);
    const glm::dvec2 size{g.width_m(), g.height_m()};
    const double longest = std::max(size.x, size.y);
    VertexLattice& l = f.lattice;
    l.domain = {vertices_along(size.x, longest, s.options.grid), vertices_along(size.y, longest, s.options.grid)};
    l.corner_m = {g.x0_m, g.y0_m};
    l.spacing_m = size / glm::dvec2(l.domain);
    l.count = l.domain;
    f.index = s.floor.optics.refractive_index;
    f.fresnel = s.floor.optics.fresnel ? 1 : 0;
    f.extinction_per_m = s.floor.optics.extinction_per_m();
    f.plan = s.floor.plan;
    const glm::dvec2 x = f.plan.axis_x() / f.plan.pitch_m.x, y = f.plan.axis_y() / f.plan.pitch_m.y;
    f.to_pixels = glm::transpose(glm::dmat2(x, y));
    f.pixel_area_m2 = f.plan.pitch_m.x * f.plan.pitch_m.y;
    f.pixel_m = std::min(f.plan.pitch_m.x, f.plan.pitch_m.y);
    f.period_m = {surface.boundary.x == Side::periodic ? size.x : 0, surface.boundary.y == Side::periodic ? size.y : 0};
    // Of a lamp no light comes in over periodic sides.
    const auto ends = [&](Side side) { return side == Side::wall || (side == Side::periodic && s.lamp); };
    f.ends = {ends(surface.boundary.x), ends(surface.boundary.y)};
    return f;
}

BoxM box_about(const FloorPlan& plan) {
    glm::dvec2 low = plan.position_m({0, 0}), high = low;
    for (const glm::dvec2 corner : {glm::dvec2{plan.width, 0}, {plan.width, plan.height}, {0, plan.height}}) {
        const glm::dvec2 at = plan.position_m(corner);
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    return {low, high};
}

BoxM light_shifts(const SplatSettings& s, const SplatFrame& frame, const Surface& surface) {
    const double level = frame.light.image.level;
    const auto highest = static_cast<double>(*std::ranges::max_element(surface.elevation.values()));
    if (!s.lamp && surface.tilt == glm::dvec2{0, 0}) {
        const glm::dvec2 still =
            -level * f64::refract_sun(frame.light.image.source, {0, 0}, frame.index, frame.fresnel).travel;
        return {glm::min(still, glm::dvec2{0, 0}), glm::max(still, glm::dvec2{0, 0})};
    }
    // From the steepest water, or from where a lamp's light is most slanting.
    double most = 0;
    const auto consider = [&](glm::dvec3 direction, glm::dvec2 slope) {
        most = std::max(most, glm::length(f64::refract_sun(direction, slope, frame.index, frame.fresnel).travel));
    };
    const auto [low, high] = box_about(frame.plan);
    const auto light = [&](glm::dvec2 at) { return f64::light_at(frame.light, {at, 0}).direction; };
    for (const glm::dvec2 corner : {low, {high.x, low.y}, high, {low.x, high.y}}) consider(light(corner), {0, 0});
    if (surface.tilt != glm::dvec2{0, 0})
        for (std::size_t k = 0; k < surface.slope_x.size(); ++k)
            consider(light({0, 0}), {surface.slope_x.values()[k], surface.slope_y.values()[k]});
    const double reach = most * (highest - level);
    return {glm::dvec2{-reach, -reach}, glm::dvec2{reach, reach}};
}

void widen_lattice(SplatFrame& frame, const Surface& surface, const BoxM& shifts_m, const BoxM& lit_m) {
    constexpr int margin = 6;  // whose splats reach the map from beside it
    VertexLattice& l = frame.lattice;
    const auto [map_low, map_high] = box_about(frame.plan);
    std::int64_t vertices = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const Side side = axis == 0 ? surface.boundary.x : surface.boundary.y;
        const bool climbs = surface.tilt[axis] != 0;
        constexpr double rounding = 1e-6;  // of a vertex
        const auto vertex = [&](double at_m) { return (at_m - l.corner_m[axis]) / l.spacing_m[axis]; };
        double low = std::min(0.0, std::floor(vertex(lit_m.first[axis]) + rounding));
        double high = std::max<double>(l.domain[axis], std::ceil(vertex(lit_m.second[axis]) - rounding));
        if (side == Side::periodic && climbs && !frame.ends[axis]) frame.period_m[axis] = 0;
        if (side == Side::absorbing || (side == Side::periodic && climbs && !frame.ends[axis])) {
            low = std::min(low, std::floor(vertex(map_low[axis] - shifts_m.second[axis])) - margin);
            high = std::max(high, std::ceil(vertex(map_high[axis] - shifts_m.first[axis])) + margin);
        }
        constexpr double most = 1 << 20;  // along an axis
        if (!(low > -most && high < most))
            throw InputError(
                fmt::format("splats: light comes from {:.0f} vertices beside the domain; allowed: at most 2^20. Give a "
                            "smaller grid, or a map that is nearer to the domain",
                            std::max(-low, high - l.domain[axis])));
        l.first[axis] = static_cast<int>(low) - vertex_rim;
        l.count[axis] = static_cast<int>(high - low) + 2 * vertex_rim;
        vertices *= l.count[axis];
    }
    if (vertices > (std::int64_t{1} << 30))
        throw InputError(fmt::format("splats: {} vertices; allowed: at most 2^30. Give a smaller grid", vertices));
}

}  // namespace waterlight
