// How near the model comes to exact states, and how fast it converges.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

using std::numbers::pi;

TEST(ShallowOrders, TravellingVortex) {
    const auto error = [](int n) {
        return error_after(TravellingVortex{}, {n, n, 12.0 / n, 12.0 / n, -6, -6}, periodic_all, 0, 2);
    };
    const double coarse = error(64), fine = error(128);
    EXPECT_LE(coarse, 2.2e-5);
    EXPECT_LE(fine, 3.2e-6);
    EXPECT_GE(std::log2(coarse / fine), 1.9);
}

TEST(ShallowOrders, ThackersPlaneSurfaceAfterThreePeriods) {
    const ThackerPlanar bowl;
    const auto error = [&](int n) { return error_after(bowl, make_grid(n, n, 4, 4), walled, 0, 3 * bowl.period_s()); };
    EXPECT_LE(error(64), 4.9e-2);
    EXPECT_LE(error(128), 1.29e-2);
}

TEST(ShallowOrders, RittersDamBreak) { EXPECT_LE(error_after(ritter(), flume(401, 10).grid, walled, 1, 6), 4.3e-4); }

// Films a hundred times as fast as their own waves, against bores that are a few cells wide.
TEST(ShallowOrders, FastFlowsThatMeetPileUpNoHigherThanTheirBores) {
    const double fast = 100 * std::sqrt(g);
    const RiemannProblem rivers{1, 1, fast, -fast, {100, 0}};
    const ShallowSides sides{FlowSide{1, {fast, 0}}, FlowSide{1, {-fast, 0}}, PeriodicSide{}, PeriodicSide{}};
    for (const int cells : {400, 800, 1600, 2400})
        EXPECT_LE(error_after(rivers, flume(cells, 200).grid, sides, 0.05, 0.25), 0.1) << cells;
}

TEST(ShallowOrders, StokersMiddleState) {
    const RiemannProblem dam = stoker();
    const auto middle = dam.middle();
    const Grid grid = flume(800, 10).grid;
    const auto model = make_shallow_water<double>(settings_of(dam, grid, walled));
    model->advance(6);
    const double near = 5 + 6 * (middle.velocity_m_s - std::sqrt(g * middle.depth_m)),
                 far = 5 + 6 * middle.right_shock_m_s;
    int cells = 0;
    for (int i = 0; i < grid.nx; ++i) {
        if (grid.x_m(i) < 0.75 * near + 0.25 * far || grid.x_m(i) > 0.25 * near + 0.75 * far) continue;
        ++cells;
        EXPECT_NEAR(model->state(i, 0).depth_m, middle.depth_m, 5e-3 * middle.depth_m);
        EXPECT_NEAR(model->state(i, 0).velocity_m_s.x, middle.velocity_m_s, 5e-3 * middle.velocity_m_s);
    }
    EXPECT_GT(cells, 50);
}

/// Runs steady flow over a bump from still water and returns the error of its depth; the discharge is within
/// `spread` of the bump's, but for three cells round the jump.
double bump_error(const SteadyBump& bump, const ShallowSide& east, double run_s, double spread) {
    ShallowWaterSettings settings = flume(100, 25, DischargeSide{constant_series(bump.discharge_m2_s)}, east);
    const Grid grid = settings.grid;
    settings.bed_m = bed_at_centres(bump, grid);
    set_initial({StillWater{bump.downstream_depth_m}}, settings);
    const auto model = make_shallow_water<double>(settings);
    model->advance(run_s);
    const double jump = bump.flow().jump_m;
    for (int i = 0; i < grid.nx; ++i) {
        if (std::abs(grid.x_m(i) - jump) < 3 * grid.dx_m) continue;
        const ShallowState s = model->state(i, 0);
        EXPECT_NEAR(s.depth_m * s.velocity_m_s.x, bump.discharge_m2_s, spread * bump.discharge_m2_s) << grid.x_m(i);
    }
    return relative_l1(*model, grid, cell_means(bump, grid, 0).depth_m);
}

TEST(ShallowOrders, SteadyBumps) {
    EXPECT_LT(bump_error(subcritical_bump(), LevelSide{constant_series(2)}, 600, 0.01), 2.5e-4);
    EXPECT_LT(bump_error(transcritical_bump(), OpenSide{}, 150, 0.01), 2e-3);
    EXPECT_LT(bump_error(jump_bump(), LevelSide{constant_series(0.33)}, 600, 0.02), 4e-3);
}

/// Height at which the depth of column i falls through `level`, going up from the wall.
double crossing_m(const ShallowWaterModel& model, const Grid& grid, int i, double level) {
    for (int j = 0; j + 1 < grid.ny; ++j) {
        const double below = model.state(i, j).depth_m, above = model.state(i, j + 1).depth_m;
        if (below >= level && above < level) return grid.y_m(j) + grid.dy_m * (below - level) / (below - above);
    }
    return std::nan("");
}

TEST(ShallowOrders, ObliqueJump) {
    const ObliqueJump jump;
    const auto behind = jump.behind();
    const double turn = jump.deflection_deg * pi / 180;
    const FlowSide inflow{jump.depth_m, jump.speed_m_s * glm::dvec2(std::cos(turn), -std::sin(turn))};
    ShallowWaterSettings settings;
    settings.grid = make_grid(100, 60, 10, 6);
    settings.sides = {inflow, OpenSide{}, WallSide{}, inflow};
    settings.bed_m = bed_at_centres(jump, settings.grid);
    const Grid& grid = settings.grid;
    settings.depth_m = field_of(grid, [&](int, int) { return jump.depth_m; });
    settings.velocity_x_m_s = field_of(grid, [&](int, int) { return inflow.velocity_m_s.x; });
    settings.velocity_y_m_s = field_of(grid, [&](int, int) { return inflow.velocity_m_s.y; });
    const auto model = make_shallow_water<double>(settings);
    model->advance(8);
    const double level = 0.5 * (jump.depth_m + behind.depth_m);
    const int near = 20, far = 90;
    const double rise = crossing_m(*model, grid, far, level) - crossing_m(*model, grid, near, level);
    const double from_wall_deg = std::atan2(rise, grid.x_m(far) - grid.x_m(near)) * 180 / pi;
    EXPECT_NEAR(from_wall_deg + jump.deflection_deg, behind.angle_deg, 0.3);
    for (int i = 50; i < 90; ++i) EXPECT_NEAR(model->state(i, 2).depth_m, behind.depth_m, 0.01 * behind.depth_m);
}

TEST(ShallowOrders, SolitaryWaveKeepsItsWaterAndMomentum) {
    ShallowWaterSettings settings = flume(400, 40, PeriodicSide{}, PeriodicSide{});
    const SolitaryWave wave{.crest_m = {20, 0}, .height_m = 0.1};
    set_initial({StillWater{}, wave}, settings);
    const auto model = make_shallow_water<double>(settings);
    const ShallowTotals before = model->totals();
    EXPECT_NEAR(before.volume_m3 / settings.grid.height_m() - 40, wave.volume_m2(), 1e-4 * wave.volume_m2());
    model->advance(12);
    const ShallowTotals after = model->totals();
    EXPECT_NEAR(after.volume_m3, before.volume_m3, 1e-12 * before.volume_m3);
    EXPECT_NEAR(after.momentum_x_kg_m_s, before.momentum_x_kg_m_s, 1e-12 * before.momentum_x_kg_m_s);
}

TEST(ShallowOrders, RoundDamBreakStaysSymmetric) {
    ShallowWaterSettings settings;
    const int n = 50;
    settings.grid = make_grid(n, n, 5, 5);
    settings.bed_m = field_of(settings.grid, [&](int i, int j) {
        const double x = settings.grid.x_m(i) - 2.5, y = settings.grid.y_m(j) - 2.5;
        return -0.2 + 0.1 * (x * x * x * x + y * y * y * y) / 8;
    });
    set_initial({CircularDam{{2.5, 2.5}, 1, 1, 0}}, settings);
    const auto model = make_shallow_water<double>(settings);
    model->advance(1.5);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const ShallowState s = model->state(i, j), mirrored = model->state(n - 1 - i, j),
                               swapped = model->state(j, i);
            ASSERT_NEAR(s.depth_m, mirrored.depth_m, 1e-12);
            ASSERT_NEAR(s.velocity_m_s.x, -mirrored.velocity_m_s.x, 1e-10);
            ASSERT_NEAR(s.depth_m, swapped.depth_m, 1e-12);
            ASSERT_NEAR(s.velocity_m_s.x, swapped.velocity_m_s.y, 1e-10);
        }
    }
}

/// Error of the elevation after a period, relative to the amplitude, of a small standing wave in a basin.
template <class Real>
double seiche_error(int n, double depth_m, double amplitude_m, double level_m = 0) {
    ShallowWaterSettings settings = flume(n, 10 * depth_m);
    const Grid grid = settings.grid;
    const double k = pi / grid.width_m(), half = 0.5 * k * grid.dx_m;
    const auto elevation = [&](int i, int) { return amplitude_m * std::sin(half) / half * std::cos(k * grid.x_m(i)); };
    settings.bed_m = field_of(grid, [&](int, int) { return level_m - depth_m; });
    settings.depth_m = field_of(grid, [&](int i, int j) { return depth_m + elevation(i, j); });
    const auto model = make_shallow_water<Real>(settings);
    model->advance(2 * pi / (k * std::sqrt(g * depth_m)));
    double error = 0;
    for (int i = 0; i < n; ++i) error += std::abs(elevation_m(*model, i, 0) - level_m - elevation(i, 0)) / n;
    return error / amplitude_m;
}

TEST(ShallowOrders, SeichesHaveThePeriodOfLinearTheory) {
    const double coarse = seiche_error<double>(32, 1, 1e-7), fine = seiche_error<double>(64, 1, 1e-7);
    EXPECT_LT(fine, 1e-4);
    EXPECT_GE(std::log2(coarse / fine), 1.9);
}

TEST(ShallowOrders, SinglePrecisionHoldsWavesFarBelowItsOwnSpacingInTheDepth) {
    // The spacing of float is 2.4e-4 m at 4000 m, and 1e-3 m at 10 000 m.
    EXPECT_LT(seiche_error<float>(64, 4000, 1e-4), 1e-3);
    EXPECT_LT(seiche_error<float>(64, 1, 1e-3, 10000.3), 1e-3);
}

}  // namespace
}  // namespace waterlight::testing
