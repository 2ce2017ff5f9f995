// The initial state of the linear model and what its settings must satisfy.
#pragma once

#include "sim/linear.hpp"
#include "sim/linear_rows.hpp"

namespace waterlight {

/// Throws InputError naming the setting that is out of its range.
void check_linear(const LinearSettings& settings);

/// Sets the elevation (m) on `grid`, the domain with its margins, to the sum of sines and standing waves.
template <class Real>
void set_linear_elevation(const LinearSettings& settings, const Grid& grid, PaddedRows<Real>& elevation);

/// Sets the rate (m/s) at the time of the elevation to that of sines which travel as the scheme with steps of dt_s lets
/// them.
template <class Real>
void set_linear_rate(const LinearSettings& settings, const Grid& grid, double dt_s, PaddedRows<Real>& rate);

}  // namespace waterlight
