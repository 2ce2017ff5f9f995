// Walls reflect, periodic sides join, absorbing sides send back what is predicted.
#include <gtest/gtest.h>

#include <complex>

#include "sim/sponge.hpp"
#include "tests/support/linear_runs.hpp"

namespace waterlight {
namespace {

using testing::basin;

TEST(LinearSides, AWallIsAMirror) {
    // A basin with walls moves as one quarter of a periodic one that holds its mirror images.
    LinearSettings half = basin(40, 30, 1.0, 0.75, {Side::wall, Side::wall});
    half.sources = {Drop{{0.3, 0.2}, 0.06, 0.01, 0}};
    LinearSettings whole = basin(80, 60, 2.0, 1.5, {Side::periodic, Side::periodic});
    for (const double x : {0.3, 1.7}) {
        for (const double y : {0.2, 1.3}) whole.sources.push_back(Drop{{x, y}, 0.06, 0.01, 0});
    }
    const auto walled = make_linear<double>(half);
    const auto mirrored = make_linear<double>(whole);
    for (int n = 0; n < 20; ++n) {
        walled->advance(0.13);
        mirrored->advance(0.13);
    }
    double worst = 0;
    double highest = 0;
    for (int j = 0; j < 30; ++j) {
        for (int i = 0; i < 40; ++i) {
            worst = std::max(worst, std::abs(walled->elevation_m(i, j) - mirrored->elevation_m(i, j)));
            highest = std::max(highest, std::abs(walled->elevation_m(i, j)));
        }
    }
    EXPECT_GT(highest, 1e-4);
    EXPECT_LT(worst, 1e-13);
}

TEST(LinearSides, SlopesRespectTheSides) {
    LinearSettings settings = basin(50, 40, 1.0, 0.8, {Side::wall, Side::periodic});
    const StandingWave wave{0.01, 3, 2};
    settings.standing = {wave};
    const auto model = make_linear<double>(settings);
    const Surface& surface = model->surface();
    const Grid& grid = settings.grid;
    const glm::dvec2 k = wave_vector(wave, grid);
    // A central difference of a mode is its slope times sin(k d) / (k d).
    const glm::dvec2 seen{std::sin(k.x * grid.dx_m) / (k.x * grid.dx_m), std::sin(k.y * grid.dy_m) / (k.y * grid.dy_m)};
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const SurfacePoint exact = evaluate(wave, grid, 0, {grid.x_m(i), grid.y_m(j)}, 0);
            ASSERT_NEAR(surface.slope_x(i, j), exact.slope.x * seen.x, 1e-7);
            ASSERT_NEAR(surface.slope_y(i, j), exact.slope.y * seen.y, 1e-7);
        }
    }
}

// Sends waves of `period` along a channel into its sponge and fits what comes back.
double measured_reflection(LinearSettings settings, double period, double dt) {
    settings.sources = {Wavemaker{{0.4, -1}, {0.4, 1}, 0.01, period, 0, 0, 4}};
    const auto model = make_linear<double>(settings);
    const Grid& grid = settings.grid;
    const double w = 2 * std::numbers::pi / period;
    const int per_period = static_cast<int>(std::lround(period / dt));
    for (int n = 0; n < 60 * per_period; ++n) model->advance(dt);
    // Complex amplitude of the oscillation at each cell, over one period.
    std::vector<std::complex<double>> amplitude(static_cast<std::size_t>(grid.nx));
    for (int n = 0; n < per_period; ++n) {
        model->advance(dt);
        for (int i = 0; i < grid.nx; ++i) {
            amplitude[static_cast<std::size_t>(i)] += model->elevation_m(i, 0) * std::polar(1.0, w * dt * (n + 1));
        }
    }
    // Two cells well beyond the maker: A exp(i k x) + B exp(-i k x).
    const double k = 2 * std::asin(std::sin(0.5 * w * dt) * grid.dx_m / dt) / grid.dx_m;
    const std::size_t first = static_cast<std::size_t>(grid.nx * 3 / 4);
    const std::size_t cells = static_cast<std::size_t>(std::max(1L, std::lround(1.5 / (k * grid.dx_m))));
    const std::complex<double> turn = std::polar(1.0, k * grid.dx_m * static_cast<double>(cells));
    const std::complex<double> back = amplitude[first] * turn - amplitude[first + cells];
    const std::complex<double> out = amplitude[first + cells] - amplitude[first] / turn;
    return std::abs(back / out);
}

class SpongeLaw : public ::testing::TestWithParam<double> {};

TEST_P(SpongeLaw, ReflectsWhatIsPredicted) {
    // Period in terms of the margin's width: waves from a third of it to twice its width.
    const double width = 0.25;
    const double period = GetParam() * width;
    LinearSettings settings = basin(400, 1, 2.0, 0.005, {Side::absorbing, Side::periodic});
    settings.cfl = 1;
    settings.sponge_m = width;
    const double longest = 1 / f64::leapfrog_courant(1, 1, 0.005, 0.005);
    const double dt = period / std::ceil(period / longest);
    const double predicted = sponge_reflection(make_sponge(width, 2.0, 0.005, 1), 1, dt, 2 * std::numbers::pi / period);
    const double measured = measured_reflection(settings, period, dt);
    EXPECT_NEAR(measured, predicted, 1e-3 * predicted + 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Lengths, SpongeLaw, ::testing::Values(0.33, 0.5, 1.0, 2.0));

TEST(SpongeLaw, ReflectsLittleOfWavesShorterThanItself) {
    const Sponge sponge = make_sponge(0, 4, 0.01, 1);
    EXPECT_EQ(sponge.cells, 100);
    const auto reflection = [&](double wavelength) {
        return sponge_reflection(sponge, 1, 0.006, 2 * std::numbers::pi / wavelength);
    };
    EXPECT_LT(reflection(0.25), 2e-3);
    EXPECT_LT(reflection(0.5), 3e-3);
    EXPECT_LT(reflection(1), 0.05);
    EXPECT_LT(reflection(2), 0.26);
    EXPECT_GT(reflection(100), 0.9);
}

}  // namespace
}  // namespace waterlight
