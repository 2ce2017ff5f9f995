// The linear model is stable up to a Courant number of 1, whatever the frames; its energy is an invariant.
#include <gtest/gtest.h>

#include "sim/error.hpp"
#include "sim/random.hpp"
#include "tests/support/linear_runs.hpp"
#include "tests/support/sides.hpp"

namespace waterlight {
namespace {

using testing::basin;

using test::walls;

LinearSettings splash(int nx, int ny, Boundary boundary) {
    LinearSettings settings = basin(nx, ny, 2.0, 2.0 * ny / nx, boundary);
    settings.sources = {Drop{{0.7, 0.6}, 0.1, 0.01, 0}, Drop{{1.5, 1.1}, 0.05, -0.02, 0}};
    settings.standing = {{0.01, 2, 4}};
    return settings;
}

TEST(LinearStability, HoldsAtACourantNumberOfOne) {
    LinearSettings settings = splash(64, 48, walls);
    settings.cfl = 1;
    const auto model = make_linear<double>(settings);
    const double dt = 1 / f64::leapfrog_courant(1, 1, settings.grid.dx_m, settings.grid.dy_m);
    model->advance(20000 * dt);
    EXPECT_EQ(model->steps(), 20000);
    EXPECT_LT(model->diagnostics().max_abs_elevation_m, 0.1);
}

TEST(LinearStability, RefusesMoreThanOne) {
    LinearSettings settings = splash(16, 16, walls);
    for (const double cfl : {1.0000001, 2.0, 0.0, -0.5}) {
        settings.cfl = cfl;
        EXPECT_THROW(make_linear<float>(settings), InputError) << cfl;
    }
}

TEST(LinearStability, HoldsInFramesOfAnyLength) {
    const auto model = make_linear<float>(splash(64, 48, walls));
    const double before = model->diagnostics().energy_j;
    RandomStream random(7, 0);
    for (int n = 0; n < 3000; ++n) model->advance(random.uniform(0.0005, 0.1));
    EXPECT_GT(model->steps(), 5000);
    EXPECT_NEAR(model->diagnostics().energy_j, before, 2e-5 * before);
}

class Energy : public ::testing::TestWithParam<Boundary> {};

TEST_P(Energy, IsConstant) {
    const auto exact = make_linear<double>(splash(60, 50, GetParam()));
    const auto single = make_linear<float>(splash(60, 50, GetParam()));
    const double before = exact->diagnostics().energy_j;
    const double single_before = single->diagnostics().energy_j;
    EXPECT_NEAR(single_before, before, 1e-6 * before);
    for (int n = 0; n < 400; ++n) {
        exact->advance(0.05);
        single->advance(0.05);
    }
    EXPECT_NEAR(exact->diagnostics().energy_j, before, 1e-12 * before);
    EXPECT_NEAR(single->diagnostics().energy_j, before, 1e-5 * before);
}

INSTANTIATE_TEST_SUITE_P(Sides, Energy,
                         ::testing::Values(walls, Boundary{Side::periodic, Side::periodic},
                                           Boundary{Side::wall, Side::periodic}));

TEST(LinearEnergy, IsThatOfTheWaveInJoules) {
    // A seiche holds density g a^2 / 4 per square metre.
    LinearSettings settings = basin(256, 8, 2.0, 0.0625, walls);
    settings.standing = {{0.01, 1, 0}};
    const auto model = make_linear<double>(settings);
    const double expected = 0.25 * 1000 * 10 * 1e-4 * 2.0 * 0.0625;
    for (int n = 0; n < 5; ++n) {
        EXPECT_NEAR(model->diagnostics().energy_j, expected, 1e-12 * expected) << n;
        model->advance(0.37);
    }
}

TEST(LinearEnergy, StaysUntilTheWavesLeaveThroughAbsorbingSides) {
    LinearSettings settings = basin(96, 96, 1.0, 1.0, {Side::absorbing, Side::absorbing});
    settings.sources = {Drop{{0.5, 0.5}, 0.03, 0.01, 0}};
    const auto model = make_linear<double>(settings);
    const double start = model->diagnostics().energy_j;
    model->advance(0.25);  // 0.19 m of drop and 0.25 m of way: still inside
    EXPECT_NEAR(model->diagnostics().energy_j, start, 1e-10 * start);
    model->advance(0.75);
    EXPECT_LT(model->diagnostics().energy_j, 0.1 * start);
    model->advance(3);
    EXPECT_LT(model->diagnostics().energy_j, 1e-5 * start);
}

}  // namespace
}  // namespace waterlight
