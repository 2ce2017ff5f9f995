// The short waves that a buoy does not see.
//
// Y. Toba (1973), J. Oceanogr. Soc. Japan 29, 209: S = beta f^-4 above the peak of a wind sea; O. M. Phillips (1958),
// J. Fluid Mech. 4, 426: breaking limits S to a multiple of g^2 f^-5.
#pragma once

#include <vector>

#include "sim/water.hpp"

namespace waterlight {

/// The tail beyond bin `last_clear`: it takes over, linearly, between the centres of that bin and of the next.
struct BuoyTail {
    int last_clear = 0;    ///< index of the last bin that is kept
    int first_fitted = 0;  ///< beta is the mean of f^4 S over bins first_fitted to last_clear
    double begin_hz = 0;   ///< where the tail alone holds
    double end_hz = 0;     ///< the slowest wave's frequency; infinity without surface tension
    double beta = 0;       ///< m^2 Hz^3
    double gravity_m_s2 = Water{}.gravity_m_s2;

    /// S(f), m^2/Hz, at begin_hz <= f <= end_hz.
    double density(double f_hz) const;
    /// Integral of density() over its range, m^2.
    double variance_m2() const;
};

/// `density` (m^2/Hz) at the bins' centres `frequency_hz`. Files hold densities to a quantum, the smallest above zero:
/// bins count as clear from four quanta on, which leaves at most 12 % of rounding. beta is fitted to the last five
/// clear bins, or as many as there are above the peak. Throws InputError where no bin stands clear.
BuoyTail fit_tail(const std::vector<double>& frequency_hz, const std::vector<double>& density, const Water& water);

}  // namespace waterlight
