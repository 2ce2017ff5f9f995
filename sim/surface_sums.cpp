#include "sim/surface_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace waterlight {

namespace {

struct RowSums {
    double elevation = 0;
    double elevation2 = 0;
    double slope2 = 0;
    double highest = 0;
};

RowSums sums_of_row(const Surface& surface, int j) {
    const float* eta = surface.elevation.row(j);
    const float* sx = surface.slope_x.row(j);
    const float* sy = surface.slope_y.row(j);
    RowSums sums;
    for (int i = 0; i < surface.grid.nx; ++i) {
        const double e = eta[i];
        const double x = sx[i];
        const double y = sy[i];
        sums.elevation += e;
        sums.elevation2 += e * e;
        sums.slope2 += x * x + y * y;
        sums.highest = std::max(sums.highest, std::abs(e));
    }
    return sums;
}

}  // namespace

WaveDiagnostics surface_sums(const Surface& surface) {
    std::vector<RowSums> rows(static_cast<std::size_t>(surface.grid.ny));
#pragma omp parallel for schedule(static)
    for (int j = 0; j < surface.grid.ny; ++j) rows[static_cast<std::size_t>(j)] = sums_of_row(surface, j);
    RowSums all;
    for (const RowSums& row : rows) {
        all.elevation += row.elevation;
        all.elevation2 += row.elevation2;
        all.slope2 += row.slope2;
        all.highest = std::max(all.highest, row.highest);
    }
    const double cells = static_cast<double>(surface.grid.cells());
    const double mean = all.elevation / cells;
    WaveDiagnostics sums;
    sums.volume_m3 = all.elevation * surface.grid.cell_area_m2();
    sums.energy_j = std::numeric_limits<double>::quiet_NaN();
    sums.variance_m2 = all.elevation2 / cells - mean * mean;
    sums.slope_variance = all.slope2 / cells;
    sums.max_abs_elevation_m = all.highest;
    return sums;
}

}  // namespace waterlight
