// The energy of the linear model, in joules.
#pragma once

#include "sim/boundary.hpp"
#include "sim/field.hpp"
#include "sim/grid.hpp"
#include "sim/water.hpp"

namespace waterlight {

/// The state of the leapfrog scheme, on its own grid with margins.
struct LinearState {
    Grid grid;
    Boundary boundary;
    Water water;
    double dt_s = 0;  ///< length of the steps
    Field<double> elevation_m;
    Field<double> rate_m_s;  ///< at the time of the elevation
};

/// Potential and kinetic energy (J): what the linear waves of these amplitudes hold, the sum over the modes of the
/// sides of density g / 2 times their squared amplitude. It is a constant of the scheme between walls and periodic
/// sides. The modes are found by FFTW in double, which costs about as much as fifty steps.
double linear_energy(LinearState state);

}  // namespace waterlight
