#include "sim/airy_dispersion.hpp"

#include <cmath>

#include "sim/kernels/dispersion.hpp"

namespace waterlight {

namespace {
double tension(const Water& water) { return water.surface_tension_n_m / water.density_kg_m3; }
}  // namespace

double airy_omega(double k, const Water& water) {
    return k > 0 ? std::sqrt(f64::airy_omega2(k, water.depth_m, water.gravity_m_s2, tension(water))) : 0;
}

double airy_group_velocity(double k, const Water& water) {
    const double slope = f64::airy_omega2_slope(k, water.depth_m, water.gravity_m_s2, tension(water));
    return slope / (2 * airy_omega(k, water));
}

double airy_wave_number(double omega, const Water& water) {
    if (omega <= 0) return 0;
    // Bracket the root, then Newton's steps on w(k), which rises with k; a step out of the bracket becomes a bisection.
    double low = 0, high = omega * omega / water.gravity_m_s2;
    while (airy_omega(high, water) < omega) high *= 2;
    double k = high;
    for (int step = 0; step < 200; ++step) {
        const double excess = airy_omega(k, water) - omega;
        (excess > 0 ? high : low) = k;
        double next = k - excess / airy_group_velocity(k, water);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const bool settled = std::abs(next - k) <= 1e-15 * k;
        k = next;
        if (settled) break;
    }
    return k;
}

}  // namespace waterlight
