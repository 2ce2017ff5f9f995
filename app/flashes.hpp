// How light flickers at a place, as ocean optics reports it: Dera & Stramski, "Maximum effects of sunlight focusing
// under a wind-disturbed sea surface" (1986), Oceanologia 23, 15: a flash is irradiance above 1.5 times its mean.
#pragma once

#include <vector>

namespace waterlight {

constexpr double flash_level = 1.5;  ///< over the mean

/// Irradiance at a place over time.
struct LightSeries {
    std::vector<double> time_s;  ///< increasing
    std::vector<double> irradiance_w_m2;
};

struct Flicker {
    double mean = 0;  ///< over time, W/m2, as are the next two of values linear between times
    double cv = 0;
    double skewness = 0;         ///< 0 where the light is steady
    double flash_rate_hz = 0;    ///< up-crossings of the level of a flash
    double longest_flash_s = 0;  ///< above that level, from crossing to crossing, or as much of it as was seen
    double sampled_every_s = 0;  ///< the longest step in time: what is shorter goes unseen
};

/// All zero but the mean where there are fewer than two times. A value that is not a number makes the rest one.
Flicker flicker_of(const LightSeries& series);

}  // namespace waterlight
