// The quads' map and its ledger on all kinds of sides and maps: against the truth, against the two-pass map's account,
// and the same for any number of threads.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>
#include <ostream>

#include "caustics/quads.hpp"
#include "sim/error.hpp"
#include "tests/support/floor_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

/// Waves that are still at the sides of a pool of 2.4 m by 1.8 m, and periodic.
Formula calm_sides() {
    return [](glm::dvec2 at) {
        const Formula waves = sines({{.004, .6, 0}, {.003, .45, 90}, {.003, .5, 37}});
        const double kx = std::numbers::pi / 2.4, ky = std::numbers::pi / 1.8;
        const double sx = std::sin(kx * at.x), sy = std::sin(ky * at.y);
        const double fade = sx * sx * sy * sy;
        const glm::dvec2 of_fade{2 * kx * sx * std::cos(kx * at.x) * sy * sy,
                                 2 * ky * sy * std::cos(ky * at.y) * sx * sx};
        SurfacePoint p = waves(at);
        p.slope = fade * p.slope + p.elevation_m * of_fade;
        p.elevation_m *= fade;
        return p;
    };
}

const Grid grid = make_grid(240, 180, 2.4, 1.8);

struct MapCase {
    const char* name;
    Boundary boundary;
    FloorPlan plan;
};
std::ostream& operator<<(std::ostream& out, const MapCase& c) { return out << c.name; }

constexpr Side round = Side::periodic, wall = Side::wall, open = Side::absorbing;
const FloorPlan whole = cover(grid, 160, 120), part{60, 50, {.7, .5}, {.012, .01}, 0},
                turned{120, 110, {.7, -.2}, {.015, .013}, 33};

FloorSettings settings_of(const MapCase& c) {
    FloorSettings s;
    s.plan = c.plan;
    s.sun = {50, 205, 1000};
    s.optics.absorption_per_m = .2;
    s.optics.scattering_per_m = .1;
    return s;
}

Surface surface_of(const MapCase& c) { return sample(grid, c.boundary, calm_sides()); }

/// calm_sides() as it goes on beyond the sides.
TruthSurface truth_of(const MapCase& c) {
    return as_truth(grid, c.boundary, [b = c.boundary](glm::dvec2 at) {
        const glm::dvec2 size{2.4, 1.8};
        if (beyond(b.x, 0, size.x, at.x) || beyond(b.y, 0, size.y, at.y)) return SurfacePoint{};
        return calm_sides()(at - size * glm::floor(at / size));
    });
}

class QuadsOnMaps : public testing::TestWithParam<MapCase> {};

TEST_P(QuadsOnMaps, AreTheTruth) {
    const FloorSettings s = settings_of(GetParam());
    const TruthMap truth = truth_map({s, 4, 16, 5e-4}, truth_of(GetParam()));
    FloorMap map;
    make_floor_quads(s)->compute(surface_of(GetParam()), map);
    EXPECT_LT(relative_rmse(map.irradiance, truth.irradiance), 5e-3);
    EXPECT_NEAR(map.ledger.floor_w, truth.ledger.floor_w, 3e-4 * truth.ledger.floor_w);
}

TEST_P(QuadsOnMaps, HaveTheLedgerOfTheTwoPassMap) {
    const FloorSettings s = settings_of(GetParam());
    FloorMap quads, two_pass;
    make_floor_quads(s)->compute(surface_of(GetParam()), quads);
    make_floor_cpu(s)->compute(surface_of(GetParam()), two_pass);
    const FloorLedger &q = quads.ledger, &t = two_pass.ledger;
    EXPECT_LT(q.closure(), 1e-6);
    EXPECT_EQ(q.lost_w, 0);
    // Where the map covers the domain both follow all of it, else each as much as its window asks for: then what lands
    // beside the map differs, and the rest is compared by what reaches it.
    const bool same = GetParam().plan.width == whole.width || GetParam().boundary.x == round;
    const double light = t.floor_w;
    if (same) {
        EXPECT_NEAR(q.incident_w, t.incident_w, 2e-3 * light);
        EXPECT_NEAR(q.reflected_w, t.reflected_w, 2e-3 * light);
        EXPECT_NEAR(q.extinguished_w, t.extinguished_w, 2e-3 * light);
        EXPECT_NEAR(q.outside_w, t.outside_w, 2e-3 * light);
    }
    EXPECT_NEAR(q.floor_w, t.floor_w, 2e-3 * light);
    EXPECT_NEAR(q.entered_w, t.entered_w, 2e-3 * light);
}

INSTANTIATE_TEST_SUITE_P(
    All, QuadsOnMaps,
    testing::Values(MapCase{"periodic", {round, round}, whole}, MapCase{"walls", {wall, wall}, whole},
                    MapCase{"absorbing", {open, open}, whole}, MapCase{"mixed", {wall, round}, whole},
                    MapCase{"mixed_too", {open, wall}, whole}, MapCase{"part_of_periodic", {round, round}, part},
                    MapCase{"part_of_walls", {wall, wall}, part}, MapCase{"turned_periodic", {round, round}, turned},
                    MapCase{"turned_walls", {wall, wall}, turned}, MapCase{"turned_absorbing", {open, open}, turned},
                    MapCase{"turned_mixed", {wall, open}, turned}),
    [](const testing::TestParamInfo<MapCase>& c) { return c.param.name; });

TEST(QuadsLedger, NoLightIsLostWhereQuadsFoldToLinesAndTurnOver) {
    for (const double depth : {2.523, 8.0, 30.0}) {
        for (const Formula& waves : {sines({{.01, .5, 0}}), sines({{.01, .5, 45}}), egg_crate(.006, .5)}) {
            const Grid square = make_grid(64, 64, .5 * root_two, .5 * root_two);
            for (const Side side : {wall, round}) {
                FloorSettings s;
                s.plan = cover(square, 70, 50);
                s.depth_m = depth;
                FloorMap map;
                make_floor_quads(s)->compute(sample(square, {side, side}, waves), map);
                EXPECT_LT(map.ledger.closure(), 1e-6) << depth;
                EXPECT_NEAR(map.ledger.incident_w, 1000 * .5, 1e-3) << depth;
                for (const float e : map.irradiance.values()) ASSERT_TRUE(e >= 0 && std::isfinite(e)) << e;
            }
        }
    }
}

TEST(QuadsLedger, ThereIsNoLightAtNight) {
    FloorSettings s;
    s.plan = whole;
    s.sun.elevation_deg = -3;
    FloorMap map;
    make_floor_quads(s)->compute(sample(grid, {}, calm_sides()), map);
    for (const float e : map.irradiance.values()) ASSERT_EQ(e, 0);
    EXPECT_EQ(map.ledger.closure(), 0);
}

TEST(QuadsLedger, TheMapDoesNotDependOnTheNumberOfThreads) {
    for (const double angle : {0.0, 28.0}) {
        const Surface surface =
            sample(make_grid(96, 80, 1.2, 1), {wall, round}, sines({{.008, .4, 25}, {.005, .3, 110}}));
        FloorSettings s;
        s.plan = cover(surface.grid, 611, 157);
        s.plan.angle_deg = angle;
        s.sun = {60, 10, 1000};
        s.depth_m = 3;
        const auto solve_on = [&](int threads) {
            omp_set_num_threads(threads);
            FloorMap map;
            make_floor_quads(s)->compute(surface, map);
            return map;
        };
        const FloorMap one = solve_on(1);
        for (const int threads : {2, 3, 5}) {
            const FloorMap many = solve_on(threads);
            EXPECT_EQ(
                0, std::memcmp(one.irradiance.data(), many.irradiance.data(), sizeof(float) * one.irradiance.size()));
            EXPECT_EQ(one.ledger.outside_w, many.ledger.outside_w);
            EXPECT_EQ(one.ledger.floor_w, many.ledger.floor_w);
        }
        omp_set_num_threads(omp_get_num_procs());
    }
}

TEST(QuadsLedger, NorWhereBandsBegin) {
    const Grid pool = make_grid(128, 96, 4, 3);
    const Surface surface = sample(pool, periodic, sines({{.02, 1, 0}, {.012, .5, 90}}));
    FloorSettings s;
    s.plan = cover(pool, 160, 120);
    s.depth_m = 2;
    s.sun = {50, 30, 1000};
    omp_set_num_threads(1);
    FloorMap one, many;
    make_floor_quads(s)->compute(surface, one);
    for (const int threads : {2, 3, 4, 7}) {
        omp_set_num_threads(threads);
        make_floor_quads(s)->compute(surface, many);
        EXPECT_TRUE(std::ranges::equal(one.irradiance.values(), many.irradiance.values())) << threads;
    }
    omp_set_num_threads(omp_get_num_procs());
}

TEST(QuadsLedger, WhatIsNoNumberShowsWhereItIs) {
    Surface surface = sample(grid, {}, calm_sides());
    surface.slope_x(100, 90) = std::numeric_limits<float>::quiet_NaN();
    FloorSettings s;
    s.plan = whole;
    FloorMap map;
    make_floor_quads(s)->compute(surface, map);
    EXPECT_TRUE(std::isnan(map.irradiance(67, 60)));
    EXPECT_TRUE(std::isfinite(map.irradiance(20, 20)));
}

TEST(QuadsLedger, SettingsOutOfRangeAreRefused) {
    FloorSettings s;
    s.depth_m = -1;
    EXPECT_THROW(make_floor_quads(s), InputError);
}

}  // namespace
}  // namespace waterlight
