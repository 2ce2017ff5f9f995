#include "sim/fft_axis.hpp"

#include <cmath>
#include <numbers>

namespace waterlight {

double AxisBasis::wave_step() const { return (kind == Kind::fourier ? 2 : 1) * std::numbers::pi / length_m(); }

int AxisBasis::partner_of(int wave) const {
    return kind == Kind::fourier && wave > 0 && 2 * wave != n ? n - wave : wave;
}

double AxisBasis::value(int slot, double x_m) const {
    const double phase = wave_number(wave_of(slot)) * (x_m - origin_m());
    return slot == wave_of(slot) ? std::cos(phase) : std::sin(phase);
}

double AxisBasis::mean_square(int slot) const {
    const bool highest = kind == Kind::fourier && 2 * slot == n;
    return slot == 0 || highest ? 1.0 : 0.5;
}

bool is_fast_length(int n) {
    for (const int prime : {2, 3, 5})
        while (n % prime == 0) n /= prime;
    return n == 1;
}

}  // namespace waterlight
