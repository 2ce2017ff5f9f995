// What the elevation at a gauge says about the waves there.
#pragma once

#include <span>

namespace waterlight {

/// Four standard deviations of the elevation (m).
double significant_height(std::span<const double> elevation_m);

/// Period (s) of the waves that carry most: the integral of S^4 over that of f S^4 (Young 1995, Ocean Eng. 22(7),
/// 669-686), which one bin of a periodogram does not decide; S is that of the elevation about its mean under Hann's
/// window. `every_s` is the time between elevations; NaN where there are fewer than four, or nothing moves.
double peak_period(std::span<const double> elevation_m, double every_s);

}  // namespace waterlight
