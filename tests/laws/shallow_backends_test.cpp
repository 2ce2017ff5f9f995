// The cpu and vulkan back-ends of the shallow-water model take the same steps and come to the same water, within 1e-4
// of the height of its waves; and what must hold on one holds on the other.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "sim/error.hpp"
#include "sim/random.hpp"
#include "sim/shallow_water_vulkan.hpp"
#include "tests/support/gpu_fixture.hpp"

namespace waterlight {
namespace {

template <class At>
Field<double> field_of(const Grid& grid, At at) {
    Field<double> field(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) field(i, j) = at(grid.x_m(i), grid.y_m(j));
    return field;
}

TimeSeries swing(double height, double period_s) {
    TimeSeries series;
    for (double t = 0; t < 60; t += 0.1) {
        series.time_s.push_back(t);
        series.value.push_back(height * std::sin(2 * std::numbers::pi * t / period_s));
    }
    return series;
}

// A pool of 12 by 9 m over 1 m of water, walled, at rest.
ShallowWaterSettings pool(int nx = 60, int ny = 45) {
    ShallowWaterSettings s;
    s.grid = make_grid(nx, ny, 12, 9);
    s.water.depth_m = 1;
    s.bed_m = field_of(s.grid, [](double, double) { return -1; });
    s.depth_m = field_of(s.grid, [](double, double) { return 1; });
    return s;
}

// An island that stands out of uneven ground and a beach that rises to the east, under a hump of water.
ShallowWaterSettings shore(int nx = 60, int ny = 45) {
    ShallowWaterSettings s = pool(nx, ny);
    s.bed_m = field_of(s.grid, [](double x, double y) {
        const double island = 1.3 * std::exp(-((x - 6) * (x - 6) + (y - 5) * (y - 5)) / 2);
        return -1 + 0.15 * std::sin(1.7 * x) * std::cos(1.3 * y) + island + 0.25 * std::max(0.0, x - 7);
    });
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const double x = s.grid.x_m(i) - 3, y = s.grid.y_m(j) - 3;
            s.depth_m(i, j) = std::max(0.0, 0.3 * std::exp(-(x * x + y * y)) - s.bed_m(i, j));
            if (s.bed_m(i, j) > 0) s.depth_m(i, j) = 0;
        }
    }
    return s;
}

ShallowWaterSettings with_sides(ShallowWaterSettings s, ShallowSides sides) {
    s.sides = std::move(sides);
    return s;
}

// The side at all four places in turn: at the shore, and where the water is deep.
std::vector<ShallowWaterSettings> on_every_side(const ShallowSide& side) {
    std::vector<ShallowWaterSettings> runs;
    runs.push_back(with_sides(shore(), {side, {}, {}, {}}));
    runs.push_back(with_sides(shore(), {{}, side, {}, {}}));
    runs.push_back(with_sides(shore(), {{}, {}, side, {}}));
    runs.push_back(with_sides(shore(), {{}, {}, {}, side}));
    return runs;
}

ShallowWaterSettings plane_dam_break() {
    ShallowWaterSettings s = pool();
    s.depth_m = field_of(s.grid, [](double x, double) { return x < 5 ? 1.0 : 0.3; });
    return s;
}

ShallowWaterSettings circular_dam_break() {
    ShallowWaterSettings s = pool();
    s.depth_m = field_of(s.grid, [](double x, double y) { return std::hypot(x - 6, y - 4.5) < 2 ? 1.0 : 0.3; });
    return s;
}

ShallowWaterSettings rubbed(ShallowWaterSettings s) {
    s.manning = 0.03;
    return s;
}

ShallowWaterSettings with_sources(ShallowWaterSettings s) {
    s.sources = {Drop{{3, 3}, 0.8, 0.1, 0}, Drop{{8, 6}, 0.8, -0.1, 1}, Rain{.05, {.5, .9}, {-.05, .02}, 0, 3, 7},
                 Wavemaker{{1, 0}, {1, 9}, 0.02, 2}};
    return s;
}

ShallowWaterSettings deep_sea() {
    ShallowWaterSettings s;
    s.grid = make_grid(60, 45, 120e3, 90e3);
    s.water.depth_m = 4000;
    s.sides = {IncidentSide{constant_series(0.5)}, OpenSide{}, OpenSide{}, LevelSide{constant_series(0.2)}};
    return s;
}

// The shore of a lake 2 km up; its west side is held at a level of its own, through the east it flows out.
ShallowWaterSettings mountain_lake() {
    ShallowWaterSettings s =
        with_sides(shore(), {LevelSide{swing(0.1, 2)}, OpenSide{}, FlowSide{2000.1, {0, 0.5}}, {}});
    for (double& height : s.bed_m.values()) height += 2000;
    for (double& level : std::get<LevelSide>(s.sides.west).elevation_m.value) level += 2000;
    return s;
}

// Water 0.3 m above the level that an open side and the waves through it are measured from.
ShallowWaterSettings high_water(const ShallowSide& west) {
    ShallowWaterSettings s = with_sides(pool(), {west, OpenSide{}, {}, {}});
    for (double& depth : s.depth_m.values()) depth += 0.3;
    return s;
}

// Water of any depth, and none, strewn over ground with cliffs: cells drain within a step.
ShallowWaterSettings cliffs() {
    RandomStream random(1, 0);
    ShallowWaterSettings s = pool();
    s.bed_m =
        field_of(s.grid, [&](double, double) { return (random.uniform() < 0.2 ? 30 : 1) * random.uniform(-1, 1); });
    s.depth_m = field_of(
        s.grid, [&](double, double) { return random.uniform() < 0.3 ? 0 : std::pow(10, random.uniform(-8, 0)); });
    return s;
}

struct Scene {
    const char* name;
    std::vector<ShallowWaterSettings> runs;
    double height_m;
    int steps;
    double frame_s = 0.25;
};

template <class... Settings>
std::vector<ShallowWaterSettings> runs(Settings... settings) {
    std::vector<ShallowWaterSettings> all;
    (all.push_back(std::move(settings)), ...);
    return all;
}

const PeriodicSide round;

std::vector<Scene> scenes() {
    std::vector<Scene> all;
    const auto add = [&](const char* name, std::vector<ShallowWaterSettings> what, double height_m, int steps,
                         double frame_s = 0.25) {
        all.push_back({name, std::move(what), height_m, steps, frame_s});
    };
    add("plane_dam_break", runs(plane_dam_break()), 0.7, 1000);
    add("circular_dam_break", runs(circular_dam_break()), 0.7, 1000);
    add("shore", runs(shore()), 0.3, 1000);
    add("rubbed_shore", runs(rubbed(shore())), 0.3, 1000);
    add("periodic",
        runs(with_sides(circular_dam_break(), {round, round, round, round}),
             with_sides(shore(), {{}, {}, round, round})),
        0.3, 300);
    add("open", on_every_side(OpenSide{}), 0.3, 300);
    add("incident", on_every_side(IncidentSide{swing(0.1, 2)}), 0.3, 300);
    add("discharge", on_every_side(DischargeSide{constant_series(0.4)}), 0.3, 300);
    add("no_discharge", on_every_side(DischargeSide{constant_series(0)}), 0.3, 300);
    add("level", on_every_side(LevelSide{swing(0.15, 3)}), 0.3, 300);
    add("flow", on_every_side(FlowSide{0.2, {1.5, -2}}), 1, 300);
    add("piston", on_every_side(PistonSide{swing(0.1, 2)}), 0.3, 300);
    add("sources", runs(with_sources(pool()), with_sources(shore())), 0.1, 200);
    add("flumes",
        runs(pool(60, 1), pool(1, 60), shore(60, 1), shore(1, 60),
             with_sides(shore(60, 1), {OpenSide{}, PistonSide{swing(.1, 2)}, round, round}),
             with_sides(shore(1, 60), {round, round, LevelSide{swing(.1, 2)}, OpenSide{}}),
             with_sides(shore(2, 60), {round, round, {}, {}}), shore(1, 1)),
        0.3, 300);
    add("high_water", runs(high_water(OpenSide{}), high_water(IncidentSide{swing(0.1, 2)})), 0.3, 300);
    add("cliffs", runs(cliffs()), 0.2, 50, 0.05);
    add("mountain_lake", runs(mountain_lake()), 0.3, 300);
    add("deep_sea", runs(deep_sea()), 0.5, 300, 60);
    return all;
}

class Backends : public GpuTest {
  protected:
    std::unique_ptr<ShallowWaterModel> vulkan(const ShallowWaterSettings& s) const {
        return make_shallow_water_vulkan(s, context);
    }
};

// The largest differences over the cells.
struct Difference {
    double depth_m = 0;
    double flow_m2_s = 0;
};

Difference between(const Grid& grid, const ShallowWaterModel& a, const ShallowWaterModel& b) {
    Difference most;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const ShallowState at_a = a.state(i, j), at_b = b.state(i, j);
            const glm::dvec2 q = at_a.depth_m * at_a.velocity_m_s - at_b.depth_m * at_b.velocity_m_s;
            most.depth_m = std::max(most.depth_m, std::abs(at_a.depth_m - at_b.depth_m));
            most.flow_m2_s = std::max(most.flow_m2_s, std::hypot(q.x, q.y));
        }
    }
    return most;
}

class SameWater : public Backends, public testing::WithParamInterface<std::size_t> {};

// Where a film runs over dry ground, and where the water is so deep that the digits of a float end at a part of the
// wave, rounding decides more than 1e-4 of the height: there vulkan may be as far from cpu as twice what double
// precision is.
TEST_P(SameWater, OnBothBackends) {
    const std::vector<Scene> all = scenes();
    const Scene& scene = all[GetParam()];
    for (std::size_t n = 0; n < scene.runs.size(); ++n) {
        SCOPED_TRACE(scene.name + std::string(" ") + std::to_string(n));
        const ShallowWaterSettings& s = scene.runs[n];
        const auto cpu = make_shallow_water<float>(s), exact = make_shallow_water<double>(s), device = vulkan(s);
        while (cpu->steps() < scene.steps)
            for (const auto* model : {&cpu, &exact, &device}) (*model)->advance(scene.frame_s);
        EXPECT_EQ(cpu->steps(), device->steps());
        const Difference found = between(s.grid, *cpu, *device), rounding = between(s.grid, *cpu, *exact);
        const double speed = std::sqrt(s.water.gravity_m_s2 * s.water.depth_m);
        EXPECT_LT(found.depth_m, std::max(1e-4 * scene.height_m, 2 * rounding.depth_m));
        EXPECT_LT(found.flow_m2_s, std::max(1e-4 * scene.height_m * speed, 2 * rounding.flow_m2_s));
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameWater, testing::Range<std::size_t>(0, scenes().size()),
                         [](const auto& scene) { return scenes()[scene.param].name; });

// What is shown, summed and kept is that of the same water; also where host and device share no memory.
TEST_F(Backends, ShowTheSame) {
    ShallowWaterSettings s = with_sources(shore());
    s.keep_records = true;
    for (const bool staging : {false, true}) {
        open({.staging = staging, .validation = true});
        const auto cpu = make_shallow_water<float>(s), device = vulkan(s);
        for (int frame = 0; frame < 12; ++frame)
            for (const auto* model : {&cpu, &device}) (*model)->advance(0.25);
        const Surface &a = cpu->surface(), &b = device->surface();
        EXPECT_EQ(a.time_s, b.time_s);
        const auto expect_near = [](const Field<float>& x, const Field<float>& y, double tolerance) {
            ASSERT_EQ(x.size(), y.size());
            for (std::size_t k = 0; k < x.size(); ++k) {
                ASSERT_EQ(std::isnan(x.data()[k]), std::isnan(y.data()[k]));
                const bool both = !std::isnan(x.data()[k]);
                ASSERT_NEAR(both ? x.data()[k] : 0, both ? y.data()[k] : 0, tolerance);
            }
        };
        expect_near(a.elevation, b.elevation, 3e-5);
        expect_near(a.slope_x, b.slope_x, 3e-4);
        expect_near(a.slope_y, b.slope_y, 3e-4);
        expect_near(*a.depth, *b.depth, 3e-5);
        expect_near(cpu->records()->max_elevation_m, device->records()->max_elevation_m, 3e-5);
        expect_near(cpu->records()->max_speed_m_s, device->records()->max_speed_m_s, 1e-3);
        expect_near(cpu->records()->arrival_s, device->records()->arrival_s, 0.02);
        EXPECT_NEAR(cpu->totals().volume_m3, device->totals().volume_m3, 1e-6 * cpu->totals().volume_m3);
        EXPECT_NEAR(cpu->diagnostics().energy_j, device->diagnostics().energy_j, 1e-4 * cpu->diagnostics().energy_j);
        EXPECT_EQ(cpu->bed_m(30, 25), device->bed_m(30, 25));
    }
}

TEST_F(Backends, LakeAtRest) {
    for (const ShallowSide& side :
         std::vector<ShallowSide>{WallSide{}, PeriodicSide{}, OpenSide{}, LevelSide{constant_series(0)},
                                  PistonSide{swing(0, 1)}, DischargeSide{constant_series(0)}, FlowSide{}}) {
        ShallowWaterSettings s = with_sides(shore(), {side, side, side, side});
        s.depth_m = {};
        const auto device = vulkan(s);
        for (int frame = 0; frame < 20; ++frame) device->advance(0.25);
        double fastest = 0;
        for (int j = 0; j < s.grid.ny; ++j)
            for (int i = 0; i < s.grid.nx; ++i)
                fastest = std::max(fastest, glm::length(device->state(i, j).velocity_m_s));
        EXPECT_LT(fastest, 1e-6) << "side " << side.index();
        EXPECT_GT(device->steps(), 100);
    }
}

// Without the carry of the rise a thousand steps of the dam break would cost 1.6e-8.
TEST_F(Backends, NoWaterIsMadeOrLost) {
    for (const auto& s : runs(circular_dam_break(), rubbed(shore()), with_sides(shore(), {round, round, {}, {}}))) {
        const auto device = vulkan(s);
        const double before = device->totals().volume_m3;
        while (device->steps() < 1000) device->advance(0.5);
        EXPECT_NEAR(device->totals().volume_m3, before, 6e-9 * before);
    }
}

// Not even by rounding: a basin of one cell keeps its depth to the last digit.
TEST_F(Backends, NothingPassesWalls) {
    RandomStream random(6, 0);
    for (int n = 0; n < 30; ++n) {
        ShallowWaterSettings s = pool(1, 1);
        s.depth_m(0, 0) = std::pow(10, random.uniform(-12, 4));
        const double c = std::sqrt(s.water.gravity_m_s2 * s.depth_m(0, 0));
        s.velocity_x_m_s = field_of(s.grid, [&](double, double) { return c * random.uniform(-2, 2); });
        s.velocity_y_m_s = field_of(s.grid, [&](double, double) { return c * random.uniform(-2, 2); });
        const auto device = vulkan(s);
        const double before = device->state(0, 0).depth_m;
        while (device->steps() < 50) device->advance(10 * device->step_s());
        EXPECT_EQ(device->state(0, 0).depth_m, before);
    }
}

std::string failure_of(ShallowWaterModel& model) {
    try {
        for (int frame = 0; frame < 100; ++frame) model.advance(0.1);
    } catch (const WorldError& error) {
        return error.what();
    }
    return {};
}

// Both back-ends stop at the same step and name the same cell in the same state.
TEST_F(Backends, WhatIsNotFiniteStops) {
    const auto expect_stop = [&](const ShallowWaterSettings& s, const std::string& cause, const std::string& place) {
        const std::string on_device = failure_of(*vulkan(s));
        EXPECT_EQ(failure_of(*make_shallow_water<float>(s)), on_device);
        EXPECT_NE(on_device.find(cause), std::string::npos) << on_device;
        EXPECT_NE(on_device.find(place), std::string::npos) << on_device;
    };
    ShallowWaterSettings s = pool();
    s.velocity_x_m_s = field_of(s.grid, [](double, double) { return 0; });
    s.velocity_x_m_s(7, 11) = 1e12;
    expect_stop(s, "the time step fell to", "cell (7, 11)");
    s.velocity_x_m_s(7, 11) = 1e38;
    expect_stop(s, "a number is not finite", "cell (7, 11)");
    ShallowWaterSettings beyond_all = pool();
    beyond_all.sides.south = PistonSide{{{0, 1}, {0, std::numeric_limits<double>::max()}}};
    expect_stop(beyond_all, "a number is not finite", "cell (");
}

TEST_F(Backends, BadSettingsAreRefused) {
    ShallowWaterSettings s = pool();
    s.cfl = 1.5;
    EXPECT_THROW(vulkan(s), InputError);
}

}  // namespace
}  // namespace waterlight
