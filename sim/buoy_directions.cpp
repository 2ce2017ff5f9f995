#include "sim/buoy_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace waterlight {

namespace {

constexpr double radian = std::numbers::pi / 180;

/// z, or the point on its ray where its modulus is `limit`.
std::complex<double> within(std::complex<double> z, double limit) {
    const double modulus = std::abs(z);
    return modulus > limit ? z * (limit / modulus) : z;
}

}  // namespace

CircularMoments buoy_moments(double r1, double alpha1_deg, double r2, double alpha2_deg) {
    const std::complex<double> c1 = within(std::polar(r1, (270 - alpha1_deg) * radian), 0.98);
    const std::complex<double> c2 = std::polar(r2, 2 * (270 - alpha2_deg) * radian);
    // A distribution exists where |c2 - c1^2| <= 1 - |c1|^2.
    return {c1, c1 * c1 + within(c2 - c1 * c1, 0.9 * (1 - std::norm(c1)))};
}

EntropyDistribution::EntropyDistribution(const CircularMoments& moments) {
    const auto [c1, c2] = moments;
    phi1_ = (c1 - c2 * std::conj(c1)) / (1 - std::norm(c1));
    phi2_ = c2 - c1 * phi1_;
    numerator_ = (1.0 - phi1_ * std::conj(c1) - phi2_ * std::conj(c2)).real() / (2 * std::numbers::pi);
}

double EntropyDistribution::operator()(double theta_rad) const {
    const std::complex<double> turn = std::polar(1.0, -theta_rad);
    return numerator_ / std::norm(1.0 - (phi1_ + phi2_ * turn) * turn);
}

}  // namespace waterlight
