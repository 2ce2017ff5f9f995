// The linear model obeys its own discrete dispersion relation, and tends to the wave equation with second order.
#include <gtest/gtest.h>

#include "tests/support/linear_runs.hpp"
#include "tests/support/sides.hpp"

namespace waterlight {
namespace {

using testing::basin;
using testing::largest_error;
using testing::leapfrog_frequency;

struct SeicheCase {
    int nx, ny;
    int half_waves_x, half_waves_y;
    Boundary boundary;
};

class Seiche : public ::testing::TestWithParam<SeicheCase> {};

TEST_P(Seiche, ObeysTheDiscreteDispersionRelation) {
    const SeicheCase& c = GetParam();
    LinearSettings settings = basin(c.nx, c.ny, 2.0, 1.5, c.boundary);
    const StandingWave wave{0.01, c.half_waves_x, c.half_waves_y};
    settings.standing = {wave};
    const auto model = make_linear<double>(settings);
    const double frame = 0.3;
    for (int n = 1; n <= 20; ++n) {
        model->advance(frame);
        const double w = leapfrog_frequency(wave_vector(wave, settings.grid), settings.grid, model->step_s());
        const double error = largest_error(*model, settings.grid, [&](double x, double y) {
            return evaluate(wave, settings.grid, w, {x, y}, n * frame).elevation_m;
        });
        ASSERT_LT(error, 1e-12 * wave.amplitude_m) << "frame " << n;
    }
}

using test::periodic;
using test::walls;
INSTANTIATE_TEST_SUITE_P(Modes, Seiche,
                         ::testing::Values(SeicheCase{32, 24, 1, 0, walls}, SeicheCase{64, 48, 3, 2, walls},
                                           SeicheCase{100, 37, 17, 9, walls}, SeicheCase{48, 64, 47, 63, walls},
                                           SeicheCase{40, 40, 2, 4, periodic}, SeicheCase{33, 70, 6, 20, periodic},
                                           SeicheCase{64, 50, 4, 7, {Side::periodic, Side::wall}},
                                           SeicheCase{64, 50, 5, 8, {Side::wall, Side::periodic}},
                                           SeicheCase{1, 200, 0, 3, walls}));

TEST(LinearDispersion, ASineThatFitsTravelsAtTheDiscretePhaseSpeed) {
    for (const int n : {16, 48, 96}) {
        LinearSettings settings = basin(n, n, 1.0, 1.0, periodic);
        Sine sine{0.01, 1 / std::sqrt(5.0), std::atan2(1, 2) * 180 / std::numbers::pi, 20, false};
        settings.sines = {sine};
        const auto model = make_linear<double>(settings);
        const double frame = 0.11;
        for (int k = 1; k <= 30; ++k) model->advance(frame);
        const double w = leapfrog_frequency(wave_vector(sine), settings.grid, model->step_s());
        const double error = largest_error(*model, settings.grid, [&](double x, double y) {
            return evaluate(sine, w, {x, y}, 30 * frame).elevation_m;
        });
        EXPECT_LT(error, 2e-12 * sine.amplitude_m) << n << " cells";
    }
}

// Error against the continuous solution at a fixed time, relative to the amplitude.
double error_against_continuum(int n, const std::vector<double>& frames) {
    LinearSettings settings = basin(n, n, 1.0, 1.0, walls);
    const StandingWave wave{0.01, 3, 2};
    settings.standing = {wave};
    const auto model = make_linear<double>(settings);
    double t = 0;
    for (const double frame : frames) {
        model->advance(frame);
        t += frame;
    }
    const double w = glm::length(wave_vector(wave, settings.grid));
    return largest_error(*model, settings.grid,
                         [&](double x, double y) {
                             return evaluate(wave, settings.grid, w, {x, y}, t).elevation_m;
                         }) /
           wave.amplitude_m;
}

TEST(LinearConvergence, IsOfSecondOrder) {
    // Frames of whole steps on each grid.
    const std::vector<double> frames(10, 6 * 0.9 / std::sqrt(2.0) / 32);
    const double coarse = error_against_continuum(32, frames);
    const double middle = error_against_continuum(64, frames);
    const double fine = error_against_continuum(128, frames);
    EXPECT_NEAR(std::log2(coarse / middle), 2, 0.2);
    EXPECT_NEAR(std::log2(middle / fine), 2, 0.1);
    EXPECT_LT(fine, 2e-3);
}

TEST(LinearConvergence, IsOfSecondOrderInFramesOfUnlikeLength) {
    // The first is one step of the coarsest grid, the others end anywhere between two.
    const std::vector<double> frames{0.9 / std::sqrt(2.0) / 64, 0.21, 0.0017, 0.123, 0.3, 0.0383, 0.087, 0.057, 0.2};
    const double coarse = error_against_continuum(64, frames);
    const double middle = error_against_continuum(128, frames);
    const double fine = error_against_continuum(256, frames);
    EXPECT_NEAR(std::log2(coarse / middle), 2, 0.4);
    EXPECT_NEAR(std::log2(middle / fine), 2, 0.3);
}

}  // namespace
}  // namespace waterlight
