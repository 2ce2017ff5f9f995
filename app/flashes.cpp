#include "app/flashes.hpp"

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

/// The integral over time of the p-th power of a series less `from`, exact for values linear between times.
double moment(const LightSeries& s, double from, int p) {
    double sum = 0;
    for (std::size_t i = 1; i < s.time_s.size(); ++i) {
        const double a = s.irradiance_w_m2[i - 1] - from, b = s.irradiance_w_m2[i] - from;
        double terms = 0;
        for (int k = 0; k <= p; ++k) terms += std::pow(a, k) * std::pow(b, p - k);
        sum += (s.time_s[i] - s.time_s[i - 1]) * terms / (p + 1);
    }
    return sum;
}

void find_flashes(const LightSeries& s, double level, Flicker& flicker) {
    int flashes = 0;
    double begin = s.time_s.front();
    for (std::size_t i = 1; i < s.time_s.size(); ++i) {
        const double before = s.irradiance_w_m2[i - 1] - level, after = s.irradiance_w_m2[i] - level;
        const double crossing = s.time_s[i - 1] + (s.time_s[i] - s.time_s[i - 1]) * before / (before - after);
        if (before <= 0 && after > 0) {
            ++flashes;
            begin = crossing;
        }
        if (before > 0) {
            const double end = after > 0 ? s.time_s[i] : crossing;
            flicker.longest_flash_s = std::max(flicker.longest_flash_s, end - begin);
        }
    }
    flicker.flash_rate_hz = flashes / (s.time_s.back() - s.time_s.front());
}

}  // namespace

Flicker flicker_of(const LightSeries& s) {
    Flicker flicker;
    if (s.time_s.empty()) return flicker;
    flicker.mean = s.irradiance_w_m2.front();
    if (s.time_s.size() < 2) return flicker;
    const double duration = s.time_s.back() - s.time_s.front();
    flicker.mean = moment(s, 0, 1) / duration;
    const double variance = moment(s, flicker.mean, 2) / duration, third = moment(s, flicker.mean, 3) / duration;
    flicker.cv = flicker.mean == 0 ? 0 : std::sqrt(variance) / flicker.mean;
    constexpr double steady = 1e-5;  // below which the skewness would be that of rounding
    if (!(flicker.cv <= steady)) flicker.skewness = third / std::pow(variance, 1.5);
    find_flashes(s, flash_level * flicker.mean, flicker);
    for (std::size_t i = 1; i < s.time_s.size(); ++i)
        flicker.sampled_every_s = std::max(flicker.sampled_every_s, s.time_s[i] - s.time_s[i - 1]);
    return flicker;
}

}  // namespace waterlight
