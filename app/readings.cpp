#include "app/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "caustics/truth.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// The cell that holds x, of n cells of width d from x0.
int cell_of(double x, double x0, double d, int n) { return std::clamp(static_cast<int>((x - x0) / d), 0, n - 1); }

/// Whether ground is dry among the cells about a place.
bool is_by_dry_ground(const Surface& surface, int i, int j) {
    if (!surface.depth) return false;
    const Grid& grid = surface.grid;
    for (int n = std::max(j - 1, 0); n <= std::min(j + 1, grid.ny - 1); ++n)
        for (int m = std::max(i - 1, 0); m <= std::min(i + 1, grid.nx - 1); ++m)
            if ((*surface.depth)(m, n) <= 0) return true;
    return false;
}

}  // namespace

double elevation_at(const Surface& surface, glm::dvec2 at_m) {
    const Grid& grid = surface.grid;
    const int i = cell_of(at_m.x, grid.x0_m, grid.dx_m, grid.nx), j = cell_of(at_m.y, grid.y0_m, grid.dy_m, grid.ny);
    if (is_by_dry_ground(surface, i, j)) return surface.elevation(i, j);
    return interpolate(surface).at(at_m).elevation_m;
}

void require_finite(std::string_view name, const Field<float>& field, const Instant& when) {
    for (int j = 0; j < field.ny(); ++j) {
        const float* row = field.row(j);
        // Zero but for what is not finite.
        float sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < field.nx(); ++i) sum += row[i] - row[i];
        if (sum == 0) continue;
        const auto i = std::find_if(row, row + field.nx(), [](float v) { return !std::isfinite(v); }) - row;
        throw WorldError(fmt::format("the {} is not finite: {} in cell ({}, {}) at t = {:.9g} s, step {}", name, row[i],
                                     i, j, when.time_s, when.step));
    }
}

void require_finite(const Surface& surface, std::int64_t step) {
    const Instant now{surface.time_s, step};
    require_finite("elevation", surface.elevation, now);
    require_finite("slope along x", surface.slope_x, now);
    require_finite("slope along y", surface.slope_y, now);
    if (surface.velocity_x) require_finite("velocity along x", *surface.velocity_x, now);
    if (surface.velocity_y) require_finite("velocity along y", *surface.velocity_y, now);
    if (surface.depth) require_finite("depth of the water", *surface.depth, now);
}

void require_finite(std::string_view who, const LightLedger& ledger, const Instant& when) {
    if (std::isfinite(ledger.closure())) return;
    throw WorldError(
        fmt::format("the light of {} is not accounted for at t = {:.6g} s, step {}: {} W came, of which {} W "
                    "on the floor",
                    who, when.time_s, when.step, ledger.incident_w + ledger.entered_w, ledger.floor_w));
}

double pixel_at(const FloorPlan& plan, const Field<float>& irradiance, glm::dvec2 at_m) {
    const glm::dvec2 pixel = plan.pixel(at_m);
    const bool on_map = pixel.x >= 0 && pixel.x <= plan.width && pixel.y >= 0 && pixel.y <= plan.height;
    if (!on_map) return std::numeric_limits<double>::quiet_NaN();
    return irradiance(std::min(static_cast<int>(pixel.x), plan.width - 1),
                      std::min(static_cast<int>(pixel.y), plan.height - 1));
}

FloorStatistics statistics_of(const Field<float>& irradiance) {
    double sum = 0, squares = 0;
    for (const float e : irradiance.values()) sum += e;
    const double count = static_cast<double>(irradiance.size());
    const double mean = sum / count;
    for (const float e : irradiance.values()) squares += (e - mean) * (e - mean);
    const auto [low, high] = std::minmax_element(irradiance.values().begin(), irradiance.values().end());
    return {mean, *low, *high, mean == 0 ? 0 : std::sqrt(squares / count) / std::abs(mean)};
}

}  // namespace waterlight
