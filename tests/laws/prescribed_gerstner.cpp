// One trochoidal wave against what is known of it in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/gerstner.hpp"
#include "sim/sincos.hpp"

namespace waterlight {
namespace {

using std::numbers::pi;

GerstnerSea one_wave(double k, double steepness) { return GerstnerSea({{{k, 0}, steepness / k, 3.0, 0.0}}); }

class Trochoid : public ::testing::TestWithParam<double> {};

TEST_P(Trochoid, HasItsCrestAndTroughAndNoMean) {
    const double k = 4;
    const double s = GetParam();
    const double a = s / k;
    const GerstnerSea sea = one_wave(k, s);
    EXPECT_NEAR(sea.at({0, 0}, 0).elevation_m, a + 0.5 * k * a * a, 1e-15);
    EXPECT_NEAR(sea.at({pi / k, 0}, 0).elevation_m, -a + 0.5 * k * a * a, 1e-15);
    // The mean over a wave by the trapezoidal rule, exact but for a term that falls exponentially with the points.
    const int points = 65536;
    double mean = 0;
    for (int i = 0; i < points; ++i) mean += sea.at({2 * pi / k * i / points, 0}, 0).elevation_m / points;
    EXPECT_NEAR(mean, 0, 1e-9 * a);
}

TEST_P(Trochoid, IsFoundAtFixedPlaces) {
    // Particles are known in closed form; the surface above where each of them is must pass through it.
    const double k = 4;
    const double s = GetParam();
    const double a = s / k;
    const GerstnerSea sea = one_wave(k, s);
    for (int n = 0; n < 200; ++n) {
        const double theta = 2 * pi * n / 200;
        const double t = 0.7;
        const double x = (theta + 3.0 * t) / k - a * std::sin(theta);
        const SurfacePoint point = sea.at({x, 5}, t);
        const double slope = -s * std::sin(theta) / (1 - s * std::cos(theta));
        EXPECT_NEAR(point.elevation_m, a * std::cos(theta) + 0.5 * k * a * a, 1e-12 * a / (1 - s));
        EXPECT_NEAR(point.slope.x, slope, 1e-11 / std::pow(1 - s, 3));
        EXPECT_NEAR(point.slope.y, 0, 1e-14);
        // The shape travels unchanged at w / k.
        EXPECT_NEAR(point.rate_m_s, -3.0 / k * slope, 1e-11 / std::pow(1 - s, 3));
    }
}

INSTANTIATE_TEST_SUITE_P(Steepness, Trochoid, ::testing::Values(0.05, 0.3, 0.6, 0.9, 0.99));

TEST(TrochoidAgainstStokes, AgreesToSecondOrder) {
    // Stokes' second harmonic in deep water has amplitude k a^2 / 2; what is left falls as the third power.
    const double k = 2;
    const auto left = [&](double s) {
        const GerstnerSea sea = one_wave(k, s);
        const double a = s / k;
        double worst = 0;
        for (int n = 0; n < 256; ++n) {
            const double phase = 2 * pi * n / 256;
            const double stokes = a * std::cos(phase) + 0.5 * k * a * a * std::cos(2 * phase);
            worst = std::max(worst, std::abs(sea.at({phase / k, 0}, 0).elevation_m - stokes));
        }
        return worst;
    };
    EXPECT_NEAR(std::log2(left(0.1) / left(0.05)), 3, 0.1);
    EXPECT_NEAR(std::log2(left(0.05) / left(0.025)), 3, 0.05);
}

TEST(SinCosOf, IsAsGoodAsFloatAllows) {
    double worst = 0;
    for (int n = -200000; n <= 200000; ++n) {
        const float x = 0.00037f * static_cast<float>(n);
        const SinCos both = sincos_of(x);
        worst = std::max({worst, std::abs(both.sine - std::sin(static_cast<double>(x))),
                          std::abs(both.cosine - std::cos(static_cast<double>(x)))});
    }
    EXPECT_LT(worst, 1.5e-7);
}

}  // namespace
}  // namespace waterlight
