// Frequency, wave number and group velocity of small waves on the given water. SI units, radians.
#pragma once

#include "sim/water.hpp"

namespace waterlight {

/// Angular frequency (rad/s) at wave number k >= 0 (rad/m).
double airy_omega(double k, const Water& water);
/// Group velocity (m/s) at k > 0.
double airy_group_velocity(double k, const Water& water);
/// The wave number k (rad/m) whose angular frequency is omega >= 0, to rounding.
double airy_wave_number(double omega, const Water& water);

}  // namespace waterlight
