// What the state of the shallow-water model says: its surface, its sums, single cells.
#pragma once

#include <string>

#include "sim/shallow_rows.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// The state and what it needs to be read.
template <class Real>
struct ShallowView {
    const Grid& grid;
    const Water& water;
    const ShallowStart<Real>& start;
    const ShallowFields<Real>& now;
    double film_m;
};

template <class Real>
ShallowState state_of(const ShallowView<Real>& view, int i, int j);

/// Height of the ground, m.
template <class Real>
double ground_of(const ShallowStart<Real>& start, int i, int j);

template <class Real>
ShallowTotals shallow_totals(const ShallowView<Real>& view, double wet_m);

/// Elevation, slopes, velocity and depth; time and boundary are left alone. Where the ground is dry the elevation is
/// that of the ground. Slopes are central differences between wet cells, one-sided at the shore, 0 on dry ground. Needs
/// the frames of the state.
template <class Real>
void show_surface(const ShallowView<Real>& view, Surface& surface);

/// Volume of the water, energy, and statistics of the elevation over the wet cells.
WaveDiagnostics shallow_diagnostics(const Surface& surface, const ShallowTotals& totals);

/// "cell (3, 4): depth 0.1 m, velocity (2, 0) m/s, ground -1 m": the fastest cell, or the first that is not finite.
template <class Real>
std::string fastest_cell(const ShallowView<Real>& view);

}  // namespace waterlight
