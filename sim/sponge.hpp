// The damped margin that stands for open water beyond an absorbing side.
#pragma once

#include <vector>

namespace waterlight {

/// A margin along one axis, the same on both sides of the domain. Its damping rate grows from 0 at the domain to
/// peak_rate at its far end as the cube of the way (sponge_rate in sim/kernels/linear.glsl); beyond it the elevation is
/// 0.
struct Sponge {
    int cells = 0;         ///< 0: none
    double cell_m = 1;     ///< size of a cell along the axis
    double peak_rate = 0;  ///< 1/s

    /// Damping rate (1/s) at the centre of cell n, 0 <= n < cells, counted from the domain outwards.
    double rate(int n) const;
};

/// The sponge of about width_m, or where that is 0 of a quarter of `domain_m`, but of at least `least_cells` cells.
/// Its peak rate is the one under which a wave that crosses it and comes back keeps 1e-3 of its amplitude. What comes
/// back from the slope of the rate is more for long waves: 25 % of waves twice as long as the margin is wide, 4 % of
/// those as long, 0.2 % of those half as long.
Sponge make_sponge(double width_m, double domain_m, double cell_m, double wave_speed);
inline constexpr int sponge_least_cells = 32;

/// Decay exp(-rate dt) at each cell along an axis of `domain_cells` cells with the sponge before and after them.
std::vector<double> sponge_decay(const Sponge& sponge, int domain_cells, double dt_s);

/// Amplitude of the wave that comes back, per amplitude sent in, for waves of angular frequency omega (rad/s) that run
/// along the axis under the leapfrog of sim/linear.hpp with steps of dt_s: found by solving that scheme's own
/// recurrence for one frequency through the margin. Holds for 0 < omega < the scheme's highest frequency.
double sponge_reflection(const Sponge& sponge, double wave_speed, double dt_s, double omega);

}  // namespace waterlight
