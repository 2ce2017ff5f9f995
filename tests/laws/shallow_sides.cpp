// What the sides let in, let out and throw back.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

using std::numbers::pi;

/// How far water 1 m deep is from level.
double unrest_m(const ShallowState& s) { return std::abs(s.depth_m - 1); }

/// A hump of height a in the middle of a flume 1 m deep and 20 m long, which runs towards +x.
ShallowWaterSettings running_hump(double a, ShallowSide west, ShallowSide east) {
    ShallowWaterSettings settings = flume(400, 20, std::move(west), std::move(east));
    const Grid grid = settings.grid;
    settings.depth_m = field_of(grid, [&](int i, int) { return 1 + a * std::exp(-std::pow(grid.x_m(i) - 10, 2)); });
    settings.velocity_x_m_s =
        field_of(grid, [&](int i, int) { return 2 * (std::sqrt(g * settings.depth_m(i, 0)) - std::sqrt(g)); });
    return settings;
}

// Measured: 1.5e-6 of a small hump comes back, 0.25 % of one of 0.3 depths.
TEST(ShallowSides, WavesLeaveThroughOpenSides) {
    for (const auto& [a, share] : {std::pair{1e-4, 3e-6}, std::pair{0.3, 3e-3}}) {
        const ShallowWaterSettings settings = running_hump(a, OpenSide{}, OpenSide{});
        const auto model = make_shallow_water<double>(settings);
        model->advance(8);
        const double left = largest(*model, settings.grid, unrest_m);
        EXPECT_LT(left, share * a) << a;
    }
}

// Rings meet the sides at all angles. Measured: 9.3e-4 of the energy is left.
TEST(ShallowSides, RingsLeaveThroughOpenSides) {
    ShallowWaterSettings settings;
    settings.grid = make_grid(80, 80, 20, 20);
    settings.sides = {OpenSide{}, OpenSide{}, OpenSide{}, OpenSide{}};
    settings.depth_m = field_of(settings.grid, [&](int i, int j) {
        const double x = settings.grid.x_m(i) - 10, y = settings.grid.y_m(j) - 10;
        return 1 + 0.01 * std::exp(-0.5 * (x * x + y * y));
    });
    const auto model = make_shallow_water<double>(settings);
    const double before = model->totals().potential_j;
    model->advance(8);
    const double after = model->totals().potential_j + model->totals().kinetic_j;
    EXPECT_LT(after, 2e-3 * before);
}

// After 400 cells the limiter has taken 1.7 % of the crest.
TEST(ShallowSides, WallsThrowWavesBack) {
    const double a = 1e-5;
    const ShallowWaterSettings settings = running_hump(a, WallSide{}, WallSide{});
    const auto model = make_shallow_water<double>(settings);
    model->advance(20 / std::sqrt(g));
    for (int i = 0; i < settings.grid.nx; ++i) {
        EXPECT_NEAR(model->state(i, 0).depth_m, settings.depth_m(i, 0), 0.02 * a);
        EXPECT_NEAR(model->state(i, 0).velocity_m_s.x, -settings.velocity_x_m_s(i, 0), 0.02 * a * std::sqrt(g));
    }
}

/// A smooth start, then a sine.
TimeSeries sine(double amplitude_m, double period_s, double end_s) {
    TimeSeries series;
    for (double t = 0; t <= end_s; t += period_s / 200) {
        const double ramp = std::min({1.0, t / (2 * period_s), std::max(0.0, (end_s - t) / (2 * period_s))});
        series.time_s.push_back(t);
        series.value.push_back(amplitude_m * 0.5 * (1 - std::cos(pi * ramp)) * std::sin(2 * pi * t / period_s));
    }
    return series;
}

// Measured: 0.53 % of the amplitude off.
TEST(ShallowSides, IncidentWavesHaveTheElevationAskedFor) {
    const double a = 1e-5, period = 2, c = std::sqrt(g);
    const TimeSeries series = sine(a, period, 16);
    for (const bool from_west : {true, false}) {
        ShallowWaterSettings settings = flume(400, 20, OpenSide{}, OpenSide{});
        (from_west ? settings.sides.west : settings.sides.east) = IncidentSide{series};
        const auto model = make_shallow_water<double>(settings);
        const int gauge = from_west ? 100 : 299;
        const double way = 5 + 0.5 * settings.grid.dx_m;
        double worst = 0;
        watch(*model, 0.02, 14, [&](double t) {
            worst = std::max(worst, std::abs(model->state(gauge, 0).depth_m - 1 - series.at(t - way / c)));
        });
        EXPECT_LT(worst, 0.01 * a);
    }
}

// What a wall throws back leaves through the side, while the series runs and after its end.
TEST(ShallowSides, IncidentSidesLetWavesOut) {
    const double a = 1e-5, period = 2, c = std::sqrt(g);
    const TimeSeries series = sine(a, period, 16);
    ShallowWaterSettings settings = flume(400, 20, IncidentSide{series}, WallSide{});
    const auto model = make_shallow_water<double>(settings);
    const double there = 5 + 0.5 * settings.grid.dx_m, back = 40 - there;
    double worst = 0;
    watch(*model, 0.02, 16, [&](double t) {
        const double expected = series.at(t - there / c) + series.at(t - back / c);
        worst = std::max(worst, std::abs(model->state(100, 0).depth_m - 1 - expected));
    });
    EXPECT_LT(worst, 0.01 * a);
    model->advance(3 * 20 / c);
    EXPECT_LT(largest(*model, settings.grid, unrest_m), 0.01 * a);
}

TEST(ShallowSides, RiversGiveTheirDischarge) {
    const TimeSeries rising{{0, 5, 10, 20}, {0, 0.3, 0.3, 0.1}};
    const double given_m2 = 0.75 + 1.5 + 2;
    for (const double depth : {0.0, 0.5}) {
        for (const bool along_x : {true, false}) {
            ShallowWaterSettings settings;
            settings.grid = along_x ? Grid{100, 3, 1, 2, 0, 0} : Grid{3, 100, 2, 1, 0, 0};
            settings.depth_m = field_of(settings.grid, [&](int, int) { return depth; });
            (along_x ? settings.sides.west : settings.sides.north) = DischargeSide{rising};
            const auto model = make_shallow_water<double>(settings);
            const double before = model->totals().volume_m3;
            model->advance(20);
            EXPECT_NEAR(model->totals().volume_m3 - before, given_m2 * 6, 2e-3 * given_m2 * 6) << depth;
            const glm::dvec2 v = along_x ? model->state(0, 1).velocity_m_s : model->state(1, 99).velocity_m_s;
            EXPECT_GT(along_x ? v.x : -v.y, 0);
        }
    }
}

TEST(ShallowSides, LevelsAreHeld) {
    ShallowWaterSettings settings = flume(60, 30, LevelSide{constant_series(0.1)}, WallSide{});
    settings.water.depth_m = 0.5;
    settings.manning = 0.1;
    const auto model = make_shallow_water<double>(settings);
    model->advance(4000);
    for (int i = 0; i < 60; ++i) EXPECT_NEAR(elevation_m(*model, i, 0), 0.1, 1e-3);
    EXPECT_LT(fastest_m_s(*model, settings.grid), 2e-3);
}

// eta = u h / c ahead of the piston, and all the water that it has pushed away.
TEST(ShallowSides, PistonsMakeTheWaveOfLinearTheory) {
    const double c = std::sqrt(g), stroke = 1e-5, lasts = 3;
    TimeSeries way;
    for (double t = 0; t <= lasts; t += 0.01) {
        way.time_s.push_back(t);
        way.value.push_back(stroke * 0.5 * (1 - std::cos(pi * t / lasts)));
    }
    way.time_s.push_back(lasts + 1e-3);
    way.value.push_back(stroke);
    for (const bool from_west : {true, false}) {
        ShallowWaterSettings settings = flume(400, 20);
        (from_west ? settings.sides.west : settings.sides.east) = PistonSide{way};
        const auto model = make_shallow_water<double>(settings);
        const double before = model->totals().volume_m3, highest = stroke * pi / (2 * lasts) / c;
        double worst = 0;
        watch(*model, 0.02, 5, [&](double t) {
            const double s = t - (5 + 0.5 * settings.grid.dx_m) / c;
            const double speed = s > 0 && s < lasts ? stroke * 0.5 * pi / lasts * std::sin(pi * s / lasts) : 0;
            const ShallowState at = model->state(from_west ? 100 : 299, 0);
            worst = std::max(worst, std::abs(at.depth_m - 1 - speed / c));
            worst = std::max(worst, std::abs((from_west ? 1 : -1) * at.velocity_m_s.x - speed) / c);
        });
        EXPECT_LT(worst, 0.01 * highest);
        EXPECT_NEAR(model->totals().volume_m3 - before, stroke * settings.grid.height_m(),
                    1e-3 * stroke * settings.grid.height_m());
    }
}

TEST(ShallowSides, FastFlowPassesUnchanged) {
    const glm::dvec2 velocity{6, -4};
    ShallowWaterSettings settings;
    settings.grid = {30, 20, 1, 1, 0, 0};
    settings.water.depth_m = 0.7;
    const FlowSide inflow{0.1, velocity};
    settings.sides = {inflow, OpenSide{}, OpenSide{}, inflow};
    const auto model = make_shallow_water<double>(settings);
    model->advance(60);
    for (int j = 0; j < 20; ++j) {
        for (int i = 0; i < 30; ++i) {
            const ShallowState s = model->state(i, j);
            ASSERT_NEAR(s.depth_m, 0.8, 1e-3) << i << ", " << j;
            ASSERT_NEAR(s.velocity_m_s.x, velocity.x, 1e-2) << i << ", " << j;
            ASSERT_NEAR(s.velocity_m_s.y, velocity.y, 1e-2) << i << ", " << j;
        }
    }
}

}  // namespace
}  // namespace waterlight::testing
