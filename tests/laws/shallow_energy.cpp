// Momentum and energy.
#include <gtest/gtest.h>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

constexpr double density = 1000;

double energy_j(const ShallowWaterModel& model) {
    const ShallowTotals t = model.totals();
    return t.potential_j + t.kinetic_j;
}

// As long as no wave has come to the walls the water is pushed by the difference of the forces of still water.
TEST(ShallowEnergy, MomentumOfADamBreakComesFromTheWalls) {
    for (const RiemannProblem& dam : {stoker(), ritter()}) {
        // The film at the front over dry ground is slowed down.
        const double lost = dam.right_depth_m > 0 ? 1e-10 : 2e-5;
        const Grid grid = flume(300, 10).grid;
        const auto model = make_shallow_water<double>(settings_of(dam, grid, walled));
        const double hl = dam.left_depth_m, hr = dam.right_depth_m;
        const double push_n = 0.5 * density * g * (hl * hl - hr * hr) * grid.height_m();
        watch(*model, 1, 6,
              [&](double t) { EXPECT_NEAR(model->totals().momentum_x_kg_m_s, push_n * t, lost * push_n * t); });
    }
}

// The bore of Stoker's dam break takes rho g m (h2 - h1)^3 / (4 h1 h2) of power, m the flow through it.
TEST(ShallowEnergy, BoreDissipatesWhatItsJumpLoses) {
    const RiemannProblem dam = stoker();
    const auto middle = dam.middle();
    const Grid grid = flume(800, 10).grid;
    const auto model = make_shallow_water<double>(settings_of(dam, grid, walled));
    const double h1 = dam.right_depth_m, h2 = middle.depth_m;
    const double power_w =
        density * g * h1 * middle.right_shock_m_s * std::pow(h2 - h1, 3) / (4 * h1 * h2) * grid.height_m();
    model->advance(2);
    const double before = energy_j(*model);
    model->advance(4);
    EXPECT_NEAR(before - energy_j(*model), 4 * power_w, 0.02 * 4 * power_w);
}

/// Largest gain of energy within `steps` steps, relative.
template <class Real>
double largest_gain(const ShallowWaterSettings& settings, int steps) {
    const auto model = make_shallow_water<Real>(settings);
    double least = energy_j(*model), gain = 0;
    const double before = least;
    for (int n = 0; n < steps; ++n) {
        take_steps(*model, 1);
        const double now = energy_j(*model);
        gain = std::max(gain, now - least);
        least = std::min(least, now);
    }
    return gain / before;
}

TEST(ShallowEnergy, NeverGrowsInClosedBasins) {
    const double rounding = 1e-12, single_rounding = 1e-6;
    ShallowWaterSettings dam = flume(200, 10);
    dam.bed_m = field_of(dam.grid, [&](int i, int) { return -0.5 + 0.03 * std::sin(0.7 * i); });
    dam.depth_m = field_of(dam.grid, [&](int i, int) { return (i < 80 ? 0.5 : 0) - dam.bed_m(i, 0); });
    EXPECT_LT(largest_gain<double>(dam, 3000), rounding) << "dam";
    const ThackerPlanar bowl;
    const ShallowWaterSettings swinging = settings_of(bowl, make_grid(50, 50, 4, 4), walled);
    EXPECT_LT(largest_gain<double>(swinging, 1000), rounding) << "bowl";
    ShallowWaterSettings round;
    round.grid = make_grid(40, 40, 4, 4);
    set_initial({CircularDam{{1.5, 1.8}, 1, 0.5, 0}}, round);
    EXPECT_LT(largest_gain<double>(round, 1000), rounding) << "round";
    EXPECT_LT(largest_gain<float>(round, 1000), single_rounding) << "round float";
}

}  // namespace
}  // namespace waterlight::testing
