// What each simplification of the water costs a wave: its speed, its form. Pure functions of wave number, amplitude and
// depth, by which a wave model can be chosen before anything is run.
//
// An error is given as a shift: the fraction of a wavelength by which a wave would have to be moved to differ as much,
// RMS(difference) = 2 sin(pi shift) RMS(wave), so that RMS(difference) / (2 pi RMS(wave)) is the shift where it is
// small. A wave that travels n wavelengths at a speed wrong by the fraction d is misplaced by n d.
//
// Third-order frequency and second-order form: G. G. Stokes (1847), as in J. D. Fenton (1985), "A fifth-order Stokes
// theory for steady waves", J. Waterway, Port, Coastal, Ocean Eng. 111, 216. Steepening in shallow water: E. Fubini
// (1935) and R. D. Fay (1931), harmonics of a sine before and after its front breaks. Breaking: A. Miche (1944).
#pragma once

#include "sim/water.hpp"

namespace waterlight {

/// |sum of two unrelated waves - wave| over 2 pi: the largest error there is any sense in stating.
constexpr double largest_shift = 0.31830988618379067;

/// RMS(difference) / (2 pi RMS(wave)) of a wave misplaced by `wavelengths` of either sign, at most largest_shift:
/// sin(pi w) / pi up to half a wavelength, then constant, since where it comes right again it does so by chance.
double shift_error(double wavelengths);

/// c / c_airy - 1 of a model that gives all waves the speed sqrt(g h): what dispersion is worth. (k h)^2 / 6 in shallow
/// water. k > 0 in rad/m.
double long_wave_excess(double k, const Water& water);

/// c / c_airy - 1 of a travelling wave of amplitude a (m) in water without a mean current, to third order: (k a)^2 / 2
/// in deep water, 9 (k a)^2 / (16 (k h)^4) in shallow. Holds once the bound harmonics are there.
double amplitude_excess(double k, double a, const Water& water);
/// The same of a standing wave of amplitude a at the antinodes (Tadjbakhsh & Keller 1960): -(k a)^2 / 8 in deep water.
double standing_excess(double k, double a, const Water& water);

/// Amplitude of the bound second harmonic over a: k a / 2 in deep water, 3 a / (4 k^2 h^3) in shallow.
double bound_harmonic(double k, double a, const Water& water);
/// How far a harmonic that starts from nothing has come after n wavelengths, over its bound amplitude: bound and free
/// harmonic of the same size drift apart by the phase (2 w(k) - w(2k)) t, the sum grows as 2 sin(phase / 2), and swings
/// between 0 and 2 from then on, of which the root mean square is taken. In shallow water it grows with n alone.
double harmonic_growth(double k, double wavelengths, const Water& water);

/// A wave as the terms need it.
struct WaveTrain {
    double wave_number = 1;  ///< rad/m, > 0
    double amplitude_m = 0;  ///< of its crests, at least 0
    double wavelengths = 0;  ///< n, that it travels
    bool stands = false;     ///< between its reflections
};

/// Shift from leaving out all nonlinearity, for a model whose speed is off by `speed_excess` (0: airy) already. The
/// speed of the true wave and its second harmonic count.
double linear_error(const WaveTrain& wave, double speed_excess, const Water& water);
/// Shift from leaving out dispersion alone, as shallow-water does: of the wave, and of each of the harmonics that
/// steepening makes of it.
double shallow_error(const WaveTrain& wave, const Water& water);

/// The way to the front breaking, sigma = 1: sigma = (3/2) (a/h) k x after the way x in shallow water.
double steepening(const WaveTrain& wave, const Water& water);
/// k a over what breaks, 0.44 tanh(k h) (Miche's 0.142 of a wavelength in height): from 1 on no model here holds.
double breaking_ratio(const WaveTrain& wave, const Water& water);
/// Of the water against long waves: a sqrt(g/h) / sqrt(g h) = a / h.
double froude_number(const WaveTrain& wave, const Water& water);

/// 1 - c / c_exact of leapfrog along an axis of cells dx at the Courant number S along that axis: (k dx)^2 (1 -
/// S^2)/24. 1 where a wave has fewer than two cells.
double leapfrog_lag(double k, double dx, double courant);
/// Error of the model shallow-water's grid after n wavelengths on cells of dx: what its limiter takes off the crests.
/// 0.19 n^(3/4) (k dx)^2 while it is small, fitted to small travelling waves: within 30 % from 8 to 64 cells a
/// wavelength and 1 to 10 wavelengths.
double finite_volume_error(double k, double dx, double wavelengths);

}  // namespace waterlight
