// Exact states on a grid.
#pragma once

#include "sim/shallow_exact.hpp"

namespace waterlight {

/// Means over the cells of a grid.
struct ShallowMeans {
    Field<double> depth_m;
    Field<double> discharge_x_m2_s;  ///< depth times velocity
    Field<double> discharge_y_m2_s;
};

/// Of a state at time_s: Gauss and Lobatto's rule, in cells that are halved until it agrees with itself to 1e-12,
/// seven times at most. So smooth flow is right to rounding; where a shore crosses a cell the mean is right to 1e-5 of
/// the depth at the cell's far side, where a shock does, to 2e-3 of the step.
ShallowMeans cell_means(const ShallowExact& state, const Grid& grid, double time_s);

/// The ground (m above level 0) at the centres of the cells.
Field<double> bed_at_centres(const ShallowExact& state, const Grid& grid);

}  // namespace waterlight
