// The terms by which a wave model is chosen, against limits, published values and the models themselves.
#include "sim/wave_terms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/linear.hpp"
#include "sim/shallow_water.hpp"
#include "sim/shallow_waves.hpp"
#include "tests/support/linear_runs.hpp"

namespace waterlight {
namespace {

using std::numbers::pi;
const Water pure{.depth_m = 1, .surface_tension_n_m = 0};

TEST(WaveTerms, DispersionIgnoredCostsWhatTheDesignSays) {
    EXPECT_NEAR(long_wave_excess(0.078, pure), 0.001, 2e-5);
    EXPECT_NEAR(long_wave_excess(0.247, pure), 0.01, 1e-4);
    EXPECT_NEAR(long_wave_excess(0.56, pure), 0.05, 5e-4);
    EXPECT_NEAR(long_wave_excess(0.01, pure) / (1e-4 / 6), 1, 1e-3);
}

TEST(WaveTerms, AmplitudeTermsHaveStokesLimits) {
    EXPECT_NEAR(amplitude_excess(30, 0.1 / 30, pure), 0.005, 1e-8);
    EXPECT_NEAR(bound_harmonic(30, 0.1 / 30, pure), 0.05, 1e-8);
    EXPECT_NEAR(standing_excess(30, 0.1 / 30, pure), -0.01 / 8, 1e-8);
    const double k = 0.02, a = 1e-5;
    EXPECT_NEAR(amplitude_excess(k, a, pure) / (9 * k * a * k * a / (16 * std::pow(k, 4))), 1, 1e-3);
    EXPECT_NEAR(bound_harmonic(k, a, pure) / (3 * a / (4 * k * k)), 1, 1e-3);
}

/// Tadjbakhsh & Keller: standing waves of finite height are slower than small ones above k h = 1.058, faster below.
TEST(WaveTerms, StandingWavesChangeSignWhereTadjbakhshAndKellerHaveIt) {
    EXPECT_GT(standing_excess(1.055, 0.01, pure), 0);
    EXPECT_LT(standing_excess(1.061, 0.01, pure), 0);
}

/// In shallow water the second harmonic grows as Fubini's, 3/4 (a/h) k x, long before dispersion stops it.
TEST(WaveTerms, HarmonicGrowsWithTheWayInShallowWater) {
    const double k = 0.02, a = 1e-3, n = 2;
    const double grown = bound_harmonic(k, a, pure) * harmonic_growth(k, n, pure);
    EXPECT_NEAR(grown / (0.75 * a * 2 * pi * n), 1, 0.01);
    EXPECT_DOUBLE_EQ(harmonic_growth(20, 50, pure), std::numbers::sqrt2);
}

TEST(WaveTerms, ShiftErrorIsTheDifferenceOfTwoSines) {
    for (const double shift : {0.001, 0.05, 0.2, 0.4}) {
        double difference = 0, wave = 0;
        for (int i = 0; i < 100; ++i) {
            const double x = 2 * pi * i / 100;
            difference += std::pow(std::cos(x - 2 * pi * shift) - std::cos(x), 2);
            wave += std::pow(std::cos(x), 2);
        }
        EXPECT_NEAR(shift_error(shift), std::sqrt(difference / wave) / (2 * pi), 1e-12);
    }
    EXPECT_EQ(shift_error(7), largest_shift);
}

TEST(WaveTerms, LinearAndShallowErrorsMeetWhereTheyMust) {
    const WaveTrain ripple{.wave_number = 20, .amplitude_m = 1e-9, .wavelengths = 3};
    EXPECT_LT(linear_error(ripple, 0, pure), 1e-6);
    EXPECT_GT(shallow_error(ripple, pure), 0.3);
    const WaveTrain bore{.wave_number = 0.01, .amplitude_m = 0.1, .wavelengths = 1};
    EXPECT_LT(shallow_error(bore, pure), 0.001);
    EXPECT_GT(linear_error(bore, 0, pure), 0.03);
    EXPECT_NEAR(breaking_ratio({.wave_number = 20, .amplitude_m = 0.022}, pure), 1, 1e-6);
}

TEST(WaveTerms, LeapfrogLagIsThatOfItsDispersionRelation) {
    LinearSettings settings = testing::basin(40, 40, 1, 1, {Side::periodic, Side::periodic});
    const Grid& grid = settings.grid;
    const double courant = 0.6, k = 2 * pi * 4;
    const double w = testing::leapfrog_frequency({k, 0}, grid, courant * grid.dx_m);
    EXPECT_NEAR(leapfrog_lag(k, grid.dx_m, courant), 1 - w / k, 1e-9);
    EXPECT_NEAR(leapfrog_lag(k, grid.dx_m / 8, courant) / (std::pow(k * grid.dx_m / 8, 2) * (1 - 0.36) / 24), 1, 0.01);
    EXPECT_EQ(leapfrog_lag(k, 0.2, courant), 1);
}

/// Periodic, 100 m long, 1 m deep, of still water.
ShallowWaterSettings channel(int cells) {
    ShallowWaterSettings settings;
    settings.grid = make_grid(cells, 1, 100, 100);
    settings.sides = {PeriodicSide{}, PeriodicSide{}, PeriodicSide{}, PeriodicSide{}};
    settings.water = pure;
    settings.depth_m = Field<double>(cells, 1);
    settings.velocity_x_m_s = Field<double>(cells, 1);
    settings.velocity_y_m_s = Field<double>(cells, 1);
    for (double& depth : settings.depth_m.values()) depth = pure.depth_m;
    return settings;
}

/// RMS(difference) / (2 pi RMS(wave)) after a small sine has gone round n times on `cells` cells a wavelength.
double measured_shift(int cells, int n) {
    ShallowWaterSettings settings = channel(cells);
    const Sine sine{.amplitude_m = 1e-5, .wavelength_m = 100};
    add_waves({sine}, {}, settings);
    const auto model = make_shallow_water<double>(settings);
    model->advance(n * 100 / std::sqrt(pure.gravity_m_s2 * pure.depth_m));
    const Surface& surface = model->surface();
    double difference = 0;
    for (int i = 0; i < cells; ++i)
        difference +=
            std::pow(surface.elevation(i, 0) - evaluate(sine, 0, {settings.grid.x_m(i), 0}, 0).elevation_m, 2);
    return std::sqrt(2 * difference / cells) / (sine.amplitude_m * 2 * pi);
}

/// Riemann's simple wave: the elevation at x runs unchanged with the speed 3 sqrt(g (h + elevation)) - 2 sqrt(g h).
TEST(ShallowWaves, ASineSteepensAsASimpleWaveAndSendsNothingBack) {
    constexpr int cells = 2048;
    constexpr double amplitude = 0.05, length = 100, g = 9.81;
    ShallowWaterSettings settings = channel(cells);
    const Sine sine{.amplitude_m = amplitude, .wavelength_m = length};
    add_waves({sine}, {}, settings);
    const auto model = make_shallow_water<double>(settings);
    const double time = 0.5 * 2 * length / (2 * pi * 3 * amplitude) / std::sqrt(g);
    model->advance(time);
    const Surface& surface = model->surface();
    double difference = 0;
    for (int i = 0; i < cells; ++i) {
        double elevation = surface.elevation(i, 0);
        for (int n = 0; n < 100; ++n) {
            const double speed = 3 * std::sqrt(g * (1 + elevation)) - 2 * std::sqrt(g);
            elevation = evaluate(sine, 0, {settings.grid.x_m(i) - speed * time, 0}, 0).elevation_m;
        }
        difference = std::max(difference, std::abs(surface.elevation(i, 0) - elevation));
    }
    EXPECT_LT(difference, 1e-3 * amplitude);
}

TEST(WaveTerms, FiniteVolumeErrorIsThatOfTheModel) {
    for (const int cells : {8, 12, 16, 24, 32, 48, 64})
        for (const int n : {1, 3, 10}) {
            const double predicted = finite_volume_error(2 * pi / cells, 1, n), measured = measured_shift(cells, n);
            EXPECT_NEAR(measured / predicted, 1, 0.3) << cells << " cells, " << n << " wavelengths";
        }
}

}  // namespace
}  // namespace waterlight
