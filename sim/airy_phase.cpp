#include "sim/airy_phase.hpp"

#include <cmath>
#include <numbers>

#include "sim/sincos.hpp"

namespace waterlight {

void phase_row(const double* __restrict omega, int count, double elapsed_s, float* __restrict cosine,
               float* __restrict sine) {
    constexpr double turn = 2 * std::numbers::pi;
    const double turns_per_omega = elapsed_s / turn;
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const double turns = omega[i] * turns_per_omega;
        const SinCos phase = sincos_of(static_cast<float>((turns - std::rint(turns)) * turn));
        cosine[i] = phase.cosine;
        sine[i] = phase.sine;
    }
}

}  // namespace waterlight
