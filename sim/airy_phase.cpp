// Sine and cosine by the polynomials of Moshier's Cephes library (sinf.c), on a quarter turn about zero. The compiler
// vectorises them; it would not vectorise the standard library's without giving up NaNs.
#include "sim/airy_phase.hpp"

#include <cmath>
#include <numbers>

namespace waterlight {

namespace {

/// |z| <= pi / 4
inline float sine_near_zero(float z) {
    const float z2 = z * z;
    return z + z * z2 * (-1.6666654611e-1f + z2 * (8.3321608736e-3f + z2 * -1.9515295891e-4f));
}

inline float cosine_near_zero(float z) {
    const float z2 = z * z;
    return 1.0f - 0.5f * z2 +
           z2 * z2 * (4.166664568298827e-2f + z2 * (-1.388731625493765e-3f + z2 * 2.443315711809948e-5f));
}

}  // namespace

void phase_row(const double* __restrict omega, int count, double elapsed_s, float* __restrict cosine,
               float* __restrict sine) {
    const double quarters_per_omega = elapsed_s * (2 / std::numbers::pi);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const double quarters = omega[i] * quarters_per_omega;
        const double whole = std::rint(quarters);
        const auto z = static_cast<float>((quarters - whole) * (std::numbers::pi / 2));
        const int quadrant = static_cast<int>(whole - 4 * std::floor(0.25 * whole));
        const float s = sine_near_zero(z), c = cosine_near_zero(z);
        const bool odd = quadrant & 1;
        const float cosine_sign = (quadrant + 1) & 2 ? -1.0f : 1.0f, sine_sign = quadrant & 2 ? -1.0f : 1.0f;
        cosine[i] = cosine_sign * (odd ? s : c);
        sine[i] = sine_sign * (odd ? c : s);
    }
}

}  // namespace waterlight
