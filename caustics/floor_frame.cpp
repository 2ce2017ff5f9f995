#include "caustics/floor_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "caustics/kernels/surface_lookup.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

f32::FloorLight make_light(const FloorSettings& settings) {
    const bool lit = settings.sun.elevation_deg > 0;
    const glm::dvec3 s = lit ? settings.sun.direction() : glm::dvec3{0, 0, -1};
    const double n = settings.optics.refractive_index;
    const double fresnel = settings.optics.fresnel ? 1 : 0;
    const glm::dvec2 rest = f64::refract_sun(s, {0, 0}, n, fresnel).travel;
    const glm::dvec2 to_x = settings.plan.axis_x() / settings.plan.pitch_m.x;
    const glm::dvec2 to_y = settings.plan.axis_y() / settings.plan.pitch_m.y;
    return {.direction = glm::vec3(s),
            .irradiance = lit ? static_cast<float>(settings.sun.irradiance_w_m2) : 0.0F,
            .index = static_cast<float>(n),
            .fresnel = static_cast<float>(fresnel),
            .depth = static_cast<float>(settings.depth_m),
            .rest_travel = glm::vec2(rest),
            .pixel_x = glm::vec2(to_x),
            .pixel_y = glm::vec2(to_y)};
}

SplitPlace split(double place) {
    const double whole = std::floor(place);
    const float part = static_cast<float>(place - whole);
    return part >= 1 ? SplitPlace{static_cast<int>(whole) + 1, 0} : SplitPlace{static_cast<int>(whole), part};
}

/// Base pixels whose samples touch [low, high) along an axis of an aligned map; `at_first` is the position of the
/// centre of the sample of base pixel 0.
SampleRange touching(double low, double high, double at_first, double pitch) {
    constexpr double slack = 1e-6;  // of a pixel: a sample that merely abuts the domain is left out
    const int first = static_cast<int>(std::floor((low - at_first) / pitch - 0.5 + slack)) + 1;
    const int end = static_cast<int>(std::ceil((high - at_first) / pitch + 0.5 - slack));
    return {first, std::max(0, end - first)};
}

SampleRange united(SampleRange a, SampleRange b) {
    const int first = std::min(a.first, b.first);
    return {first, std::max(a.first + a.count, b.first + b.count) - first};
}

SampleRange intersected(SampleRange a, SampleRange b) {
    const int first = std::max(a.first, b.first);
    return {first, std::max(0, std::min(a.first + a.count, b.first + b.count) - first)};
}

/// The samples to follow along one axis of an aligned map of `size` pixels: all that can reach the map through the
/// window, and all of the domain where the map covers it, for then the ledger accounts for the whole pool.
SampleRange follow(int size, int half_window, Side side, SampleRange domain, bool covers_domain) {
    const SampleRange reach{-half_window, size + 2 * half_window};
    if (side == Side::periodic) return reach;
    const SampleRange all = covers_domain ? united(reach, domain) : reach;
    return side == Side::wall ? intersected(all, domain) : all;
}

/// A sample's slide grows with the square of the pixels' aspect: wide pixels ask for two strips.
int strips_for(const FloorPlan& plan) {
    constexpr double wide = 1.5;
    return plan.pitch_m.x > wide * plan.pitch_m.y ? 2 : 1;
}

bool covers(double origin, double length, double from, double extent) {
    const double slack = 1e-9 * extent;
    return origin <= from + slack && origin + length >= from + extent - slack;
}

/// Places the samples; that of base pixel (0, 0) lies at `first`.
void lay_out(FloorFrame& frame, const FloorPlan& plan, const Grid& grid, glm::dvec2 first) {
    // Place in cells of sample (i, j): (first + i step_x + j step_y - centre of cell 0) / cell size.
    const glm::dvec2 cell{grid.dx_m, grid.dy_m};
    const glm::dvec2 start = (first - glm::dvec2{grid.x_m(0), grid.y_m(0)}) / cell;
    const glm::dvec2 step_x = plan.pitch_m.x * plan.axis_x() / cell;
    const glm::dvec2 step_y = plan.pitch_m.y * plan.axis_y() / cell;
    for (std::vector<SplitPlace>* places : {&frame.column_x, &frame.column_y, &frame.row_x, &frame.row_y})
        places->clear();
    for (int i = 0; i < frame.columns.count; ++i) {
        const double base = frame.columns.first + i;
        frame.column_x.push_back(split(start.x + base * step_x.x));
        frame.column_y.push_back(split(base * step_x.y));
    }
    for (int j = 0; j < frame.rows.count; ++j) {
        const double base = frame.rows.first + j;
        frame.row_x.push_back(split(base * step_y.x));
        frame.row_y.push_back(split(start.y + base * step_y.y));
    }
    frame.half_width_x = static_cast<float>(0.5 * (std::abs(step_x.x) + std::abs(step_y.x)));
    frame.half_width_y = static_cast<float>(0.5 * (std::abs(step_x.y) + std::abs(step_y.y)));
}

}  // namespace

// P_C = P_G + h L' (paper eq. 1): from a pixel back along the refracted ray to the surface at rest.
glm::dvec2 entry_m(const FloorFrame& frame, const FloorSettings& settings, glm::dvec2 pixel) {
    return settings.plan.position_m(pixel) - settings.depth_m * glm::dvec2(frame.light.rest_travel);
}

FloorFrame corners_of(const FloorFrame& frame, const FloorSettings& settings, const Surface& surface) {
    FloorFrame corners = frame;
    ++corners.columns.count;
    ++corners.rows.count;
    lay_out(corners, settings.plan, surface.grid, entry_m(frame, settings, {0, 0}));
    return corners;
}

FloorFrame prepare(const FloorSettings& settings, const Surface& surface) {
    const FloorPlan& plan = settings.plan;
    const Grid& grid = surface.grid;
    FloorFrame frame;
    frame.map_width = plan.width;
    frame.map_height = plan.height;
    frame.adaptive = settings.footprint == Footprint::adaptive;
    frame.light = make_light(settings);
    frame.extinction_per_m = static_cast<float>(settings.optics.extinction_per_m());
    frame.strips = frame.adaptive ? strips_for(plan) : 1;
    frame.window = settings.window ? *settings.window : auto_window(frame, settings, surface);
    frame.aligned = plan.axis_x().y == 0;
    frame.pixel_area_m2 = plan.pitch_m.x * plan.pitch_m.y;
    const bool periodic_x = surface.boundary.x == Side::periodic, periodic_y = surface.boundary.y == Side::periodic;
    frame.count_base_x = periodic_x || (!frame.aligned && periodic_y);
    frame.count_base_y = periodic_y || (!frame.aligned && periodic_x);

    const glm::dvec2 first = entry_m(frame, settings, {0.5, 0.5});
    const int hx = frame.half_samples(), hy = frame.half_channels();
    if (frame.aligned) {
        const bool whole = covers(plan.origin_m.x, plan.width * plan.pitch_m.x, grid.x0_m, grid.width_m()) &&
                           covers(plan.origin_m.y, plan.height * plan.pitch_m.y, grid.y0_m, grid.height_m());
        frame.columns = follow(plan.width, hx, surface.boundary.x,
                               touching(grid.x0_m, grid.x0_m + grid.width_m(), first.x, plan.pitch_m.x), whole);
        frame.rows = follow(plan.height, hy, surface.boundary.y,
                            touching(grid.y0_m, grid.y0_m + grid.height_m(), first.y, plan.pitch_m.y), whole);
    } else {
        frame.columns = {-hx, plan.width + 2 * hx};
        frame.rows = {-hy, plan.height + 2 * hy};
    }
    const std::int64_t samples = static_cast<std::int64_t>(frame.columns.count) * frame.rows.count;
    if (samples > (std::int64_t{1} << 30))
        throw InputError(
            fmt::format("floor map: the window of {} x {} samples makes {} samples a frame; allowed: at most "
                        "2^30. Give a smaller window or fewer, larger pixels",
                        frame.window.samples, frame.window.channels, samples));

    lay_out(frame, plan, grid, first);
    return frame;
}

}  // namespace waterlight
