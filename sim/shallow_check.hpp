// What the shallow-water model asks of its settings, and what follows from them.
#pragma once

#include "sim/shallow_rows.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// Throws InputError where a setting is out of its range or a field does not fit the grid.
void check_shallow(const ShallowWaterSettings& settings);

/// Of a cell, empty fields as ShallowWaterSettings takes them.
double initial_bed_m(const ShallowWaterSettings& settings, int i, int j);
double initial_depth_m(const ShallowWaterSettings& settings, int i, int j);

/// Depth (m) below which the velocity fades: 1e-5 of the deepest initial water, at most 1e-5 m.
double film_depth(const ShallowWaterSettings& settings);

/// Rate (1/s) at which waves of the deepest initial water, or of water as deep as a cell is wide where there is none,
/// cross a cell.
double still_rate(const ShallowWaterSettings& settings);

/// The initial surface, depth and discharge over a datum that is the level of water nearest to 0; no frames.
template <class Real>
void set_start(const ShallowWaterSettings& settings, ShallowStart<Real>& start, ShallowFields<Real>& fields);

extern template void set_start<float>(const ShallowWaterSettings&, ShallowStart<float>&, ShallowFields<float>&);
extern template void set_start<double>(const ShallowWaterSettings&, ShallowStart<double>&, ShallowFields<double>&);

}  // namespace waterlight
