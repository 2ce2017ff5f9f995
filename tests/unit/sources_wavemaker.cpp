// The wavemaker's shape and signal.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "sim/sources.hpp"

namespace waterlight {
namespace {

TEST(Wavemaker, HasTheTransformThatSendsItsAmplitude) {
    // The transform of the cross-section at k is 2 cg a, in any direction of the line.
    const Grid grid = make_grid(256, 256, 4.0, 4.0);
    const double k = 12;
    for (const double degrees : {0.0, 30.0, 90.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const glm::dvec2 along{std::cos(angle), std::sin(angle)};
        const glm::dvec2 across{-along.y, along.x};
        const Wavemaker maker{glm::dvec2(2, 2) - 0.8 * along, glm::dvec2(2, 2) + 0.8 * along, 0.01, 1};
        const Field<double> shape = inflow_shape(maker, grid, k, 0.7);
        std::complex<double> transform = 0;
        double volume = 0;
        for (int j = 0; j < grid.ny; ++j) {
            for (int i = 0; i < grid.nx; ++i) {
                const double x = (grid.x_m(i) - 2) * across.x + (grid.y_m(j) - 2) * across.y;
                transform += shape(i, j) * grid.cell_area_m2() * std::polar(1.0, -k * x);
                volume += shape(i, j);
            }
        }
        // Over the line's length of 1.6 m.
        EXPECT_NEAR(std::abs(transform) / 1.6, 2 * 0.7 * 0.01, 1e-5) << degrees;
        EXPECT_LT(std::abs(volume), 1e-12) << degrees;
    }
}

TEST(Wavemaker, FromSideToSideIsTheSameAllAlong) {
    const Grid grid = make_grid(64, 48, 4.0, 3.0);
    const Field<double> shape = inflow_shape({{1, 0}, {1, 3}, 0.01, 1}, grid, 5, 1);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) ASSERT_EQ(shape(i, j), shape(i, 0));
    }
}

TEST(Wavemaker, AgainstAWallHasNoVolumeEither) {
    const Grid grid = make_grid(64, 48, 4.0, 3.0);
    for (const double x : {0.0, 0.07, 0.2}) {
        const Field<double> shape = inflow_shape({{x, 0}, {x, 3}, 0.01, 1}, grid, 5, 1);
        double volume = 0;
        for (const double v : shape.values()) volume += v;
        EXPECT_LT(std::abs(volume), 1e-12) << x;
    }
}

TEST(Wavemaker, StartsSmoothlyAndThenOscillates) {
    const Wavemaker maker{{0, 0}, {0, 1}, 0.01, 2, 90, 3, 1.5};
    EXPECT_EQ(inflow_signal(maker, 2.999), 0);
    EXPECT_NEAR(inflow_signal(maker, 3 + 1e-6), 0, 1e-10);
    // Half-way up the ramp of 3 s.
    EXPECT_NEAR(inflow_signal(maker, 4.5), 0.5 * std::cos(1.5 * std::numbers::pi + std::numbers::pi / 2), 1e-12);
    for (const double t : {6.0, 6.4, 9.1}) {
        EXPECT_NEAR(inflow_signal(maker, t), std::cos(std::numbers::pi * (t - 3) + std::numbers::pi / 2), 1e-12);
    }
    EXPECT_EQ(inflow_signal({{0, 0}, {0, 1}, 0.01, 2, 0, 0, 0}, 0), 1);
}

}  // namespace
}  // namespace waterlight
