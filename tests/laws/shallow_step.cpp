// A long wave of small height passes from deep into shallow water: of its height 2 c1 / (c1 + c2) goes on and
// (c1 - c2) / (c1 + c2) comes back (Lamb, Hydrodynamics, art. 176).
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

constexpr double deep_m = 1, shallow_m = 0.25, length_m = 40, step_at_m = 20, height_m = 1e-4;

struct Shares {
    double passed = 0, returned = 0;
};

/// The heights of both waves over that of the first; the ground rises over `width_m`.
Shares over_step(int cells, double width_m) {
    ShallowWaterSettings settings = flume(cells, length_m);
    const Grid& grid = settings.grid;
    settings.bed_m = field_of(grid, [&](int i, int) {
        const double part = width_m > 0 ? (grid.x_m(i) - step_at_m) / width_m + 0.5 : grid.x_m(i) > step_at_m;
        return -deep_m + (deep_m - shallow_m) * std::clamp(part, 0.0, 1.0);
    });
    const auto elevation = [&](int i, int) {
        const double from = (grid.x_m(i) - 8) / 1.5;
        return height_m * std::exp(-from * from);
    };
    settings.depth_m = field_of(grid, [&](int i, int j) { return elevation(i, j) - settings.bed_m(i, j); });
    settings.velocity_x_m_s = field_of(grid, [&](int i, int j) { return elevation(i, j) * std::sqrt(g / deep_m); });
    const auto model = make_shallow_water<double>(settings);
    model->advance(6.3);
    Shares most;
    for (int i = 0; i < grid.nx; ++i) {
        const double elevated = model->state(i, 0).depth_m + settings.bed_m(i, 0);
        double& side = grid.x_m(i) > step_at_m + 1 ? most.passed : most.returned;
        side = std::max(side, elevated / height_m);
    }
    return most;
}

/// Of the energy, which goes with height squared and speed.
double energy(const Shares& shares) {
    return std::sqrt(shallow_m / deep_m) * shares.passed * shares.passed + shares.returned * shares.returned;
}

void print(const char* what, int cells, const Shares& shares) {
    std::printf("%s, %d cells: passed %.3f, returned %.3f, energy %.3f\n", what, cells, shares.passed, shares.returned,
                energy(shares));
}

TEST(ShallowStep, AStepThatIsResolvedPassesAndReturnsWhatTheoryHas) {
    double last = 1;
    for (const int cells : {800, 1600}) {
        const Shares shares = over_step(cells, 0.4);
        print("step of 0.4 m", cells, shares);
        const double error = std::abs(shares.passed - 4.0 / 3);
        EXPECT_LT(error, last / 3) << cells;
        EXPECT_NEAR(shares.returned, 1.0 / 3, 0.015) << cells;
        last = cells == 800 ? error : last;
    }
    EXPECT_LT(last, 0.04);
}

// The hydrostatic reconstruction sees of the deep side no more than the shallow one's depth: what it gets wrong is
// lost, never gained (docs/shallow-water.md).
TEST(ShallowStep, AStepBetweenTwoCellsLosesEnergyAndGainsNone) {
    for (const int cells : {400, 800, 1600}) {
        const Shares shares = over_step(cells, 0);
        print("step between two cells", cells, shares);
        EXPECT_LT(energy(shares), 1) << cells;
        EXPECT_GT(shares.passed, 1) << cells;
    }
}

}  // namespace
}  // namespace waterlight::testing
