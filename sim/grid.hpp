// A regular grid of cells on the still water plane.
#pragma once

#include <cstddef>

namespace waterlight {

/// nx by ny cells of dx by dy metres; (x0_m, y0_m) is the outer corner of cell (0, 0), fields live at cell centres.
struct Grid {
    int nx = 1;
    int ny = 1;
    double dx_m = 1;
    double dy_m = 1;
    double x0_m = 0;
    double y0_m = 0;

    /// Centre of column i, row j; any integer is allowed, also outside the grid.
    double x_m(int i) const { return x0_m + (i + 0.5) * dx_m; }
    double y_m(int j) const { return y0_m + (j + 0.5) * dy_m; }

    double width_m() const { return nx * dx_m; }
    double height_m() const { return ny * dy_m; }
    double cell_area_m2() const { return dx_m * dy_m; }
    std::size_t cells() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }

    bool operator==(const Grid&) const = default;
};

/// The grid of nx by ny cells that covers [0, width] x [0, height].
inline Grid make_grid(int nx, int ny, double width_m, double height_m) {
    return {nx, ny, width_m / nx, height_m / ny, 0, 0};
}

}  // namespace waterlight
