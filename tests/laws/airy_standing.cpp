// A standing wave keeps its time and its energy over a thousand periods, in shallow, middling and deep water.
#include <gtest/gtest.h>

#include "tests/support/airy_runs.hpp"

namespace waterlight::testing {
namespace {

struct Case {
    double kh;
    Side side;
};

class StandingWaves : public ::testing::TestWithParam<Case> {};

/// Twice the mean of elevation cos(k x): the wave's coordinate.
double coordinate(const Surface& surface, double k) {
    double sum = 0;
    for (int j = 0; j < surface.grid.ny; ++j)
        for (int i = 0; i < surface.grid.nx; ++i) sum += surface.elevation(i, j) * std::cos(k * surface.grid.x_m(i));
    return 2 * sum / static_cast<double>(surface.grid.cells());
}

TEST_P(StandingWaves, KeepTimeAndEnergyForAThousandPeriods) {
    const double length = 3, a = 0.01, k = 4 * pi / length;
    AirySettings settings = tank(64, 8, length, 0.5, {GetParam().side, GetParam().side}, GetParam().kh / k);
    settings.standing = {{a, 4, 0}};
    const auto model = make_airy(settings);
    const double period = 2 * pi / textbook_omega(k, settings.water);
    const double tension = settings.water.surface_tension_n_m / settings.water.density_kg_m3;
    const double energy =
        0.25 * settings.water.density_kg_m3 * (settings.water.gravity_m_s2 + tension * k * k) * a * a * length * 0.5;
    EXPECT_NEAR(model->diagnostics().energy_j, energy, 1e-6 * energy);

    for (int n = 0; n < 1000; ++n) model->advance(period);
    const double now = coordinate(model->surface(), k);
    const double stored = model->diagnostics().energy_j;
    model->advance(0.25 * period);
    const double later = coordinate(model->surface(), k);
    EXPECT_NEAR(std::atan2(-later, now), 0, 2e-6);
    EXPECT_NEAR((now * now + later * later) / (a * a), 1, 2e-6);
    EXPECT_NEAR(stored, energy, 1e-6 * energy);
    EXPECT_EQ(model->steps(), 1001);
}

INSTANTIATE_TEST_SUITE_P(Depths, StandingWaves,
                         ::testing::Values(Case{0.3, Side::wall}, Case{3, Side::wall}, Case{30, Side::wall},
                                           Case{0.3, Side::periodic}, Case{3, Side::periodic},
                                           Case{30, Side::periodic}));

TEST(Airy, CrossedStandingWaveFollowsItsFormulaInEveryMixOfSides) {
    for (const Side x : {Side::periodic, Side::wall}) {
        for (const Side y : {Side::periodic, Side::wall}) {
            AirySettings settings = tank(37, 22, 2, 1.5, {x, y}, 0.4);
            settings.standing = {{0.01, 4, 2}};
            const auto model = make_airy(settings);
            model->advance(1.7);
            const double kx = 4 * pi / 2, ky = 2 * pi / 1.5;
            const double a = 0.01 * std::cos(textbook_omega(std::hypot(kx, ky), settings.water) * 1.7);
            const Surface& surface = model->surface();
            EXPECT_LT(largest_error(surface.elevation, settings.grid,
                                    [&](double u, double v) { return a * std::cos(kx * u) * std::cos(ky * v); }),
                      1e-8);
            EXPECT_LT(largest_error(surface.slope_x, settings.grid,
                                    [&](double u, double v) { return -a * kx * std::sin(kx * u) * std::cos(ky * v); }),
                      1e-7);
            EXPECT_LT(largest_error(surface.slope_y, settings.grid,
                                    [&](double u, double v) { return -a * ky * std::cos(kx * u) * std::sin(ky * v); }),
                      1e-7);
        }
    }
}

}  // namespace
}  // namespace waterlight::testing
