#include "app/readings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waterlight {

namespace {

struct Neighbours {
    int low = 0;
    int high = 0;
    double weight = 0;  ///< of high
};

/// The two cells whose centres enclose `place` (in cells, 0.5 is the first centre).
Neighbours enclose(double place, int count, Side side) {
    const double below = std::floor(place - 0.5);
    const auto at = [&](double cell) {
        const int i = static_cast<int>(std::clamp(cell, -1.0, static_cast<double>(count)));
        return side == Side::periodic ? (i + count) % count : std::clamp(i, 0, count - 1);
    };
    return {at(below), at(below + 1), place - 0.5 - below};
}

}  // namespace

double elevation_at(const Surface& surface, glm::dvec2 at_m) {
    const Grid& grid = surface.grid;
    const Neighbours x = enclose((at_m.x - grid.x0_m) / grid.dx_m, grid.nx, surface.boundary.x);
    const Neighbours y = enclose((at_m.y - grid.y0_m) / grid.dy_m, grid.ny, surface.boundary.y);
    const auto along_x = [&](int j) {
        const float* row = surface.elevation.row(j);
        return row[x.low] * (1 - x.weight) + row[x.high] * x.weight;
    };
    return along_x(y.low) * (1 - y.weight) + along_x(y.high) * y.weight;
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
