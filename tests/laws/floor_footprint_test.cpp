// The adaptive footprint of the floor map converges: errors against the truth at one sample a pixel, their order, and
// that no light is lost however a footprint folds.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>

#include "tests/support/floor_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

/// Percent, of the adaptive footprint through its own window.
double error_of(const FloorScene& scene, int per_wave) {
    const SolvedFloor solved = solve(scene, per_wave);
    const FloorMap map = map_of(solved.settings, solved.surface);
    EXPECT_LT(map.ledger.closure(), 1e-6);
    EXPECT_LT(map.ledger.lost_w, 1e-6 * map.ledger.incident_w);
    const double error = relative_rmse(map.irradiance, solved.truth.irradiance);
    EXPECT_LT(solved.truth.error_estimate, 0.3 * error);
    return 100 * error;
}

TEST(AdaptiveFootprint, SineAt128PixelsAWave) {
    EXPECT_LT(error_of(sine(1), 128), 0.1);
    EXPECT_LT(error_of(sine(4), 128), 0.5);
}

TEST(AdaptiveFootprint, EggCrateAt128PixelsAWave) {
    EXPECT_LT(error_of(crate(1), 128), 0.1);
    EXPECT_LT(error_of(crate(3), 128), 0.4);
}

TEST(AdaptiveFootprint, CrossedDiagonalWavesAt128PixelsAWave) {
    EXPECT_LT(error_of(crossed(1), 128), 0.1);
    EXPECT_LT(error_of(crossed(3), 128), 0.2);
}

TEST(AdaptiveFootprint, SkewWaveUnderASlantingSunOnPixelsTwiceAsWideAsHigh) {
    EXPECT_LT(error_of(skew(0), 128), 1.2);
    for (const double azimuth : {0.0, 30.0, 60.0, 120.0, 150.0}) EXPECT_LT(error_of(skew(azimuth), 64), 1.2) << azimuth;
}

TEST(AdaptiveFootprint, ErrorFallsWithThePixel) {
    // First order: within a footprint light is even, so where footprints are not as wide as pixels a pixel's average is
    // off by a part of what irradiance changes over one. Before focus and beyond, in one dimension and in two.
    struct Case {
        const char* name;
        FloorScene scene;
        int finest;
    };
    for (const Case& c : {Case{"sine_1", sine(1), 512},
                          {"sine_4", sine(4), 512},
                          {"crossed_1", crossed(1), 128},
                          {"crossed_3", crossed(3), 128}}) {
        const double coarse = error_of(c.scene, 32);
        RecordProperty(std::string(c.name) + "_32", std::to_string(coarse));
        double fine = coarse;
        for (int per_wave = 64; per_wave <= c.finest; per_wave *= 2) {
            fine = error_of(c.scene, per_wave);
            RecordProperty(std::string(c.name) + "_" + std::to_string(per_wave), std::to_string(fine));
        }
        EXPECT_GT(std::log2(coarse / fine) / std::log2(c.finest / 32.0), 0.95) << c.name;
    }
}

TEST(AdaptiveFootprint, MoreSamplesAPixelAreMoreExact) {
    const SolvedFloor solved = solve(crossed(3), 32);
    double last = 1;
    for (const int samples : {1, 2, 4}) {
        FloorSettings s = solved.settings;
        s.samples_per_pixel = samples;
        // The water between the cells must be known better than the cells say.
        const Grid grid = make_grid(4 * s.plan.width, 4 * s.plan.height, .5 * root_two, .5 * root_two);
        const FloorMap map = map_of(s, sample(grid, periodic, crossed(3).waves));
        const double error = relative_rmse(map.irradiance, solved.truth.irradiance);
        EXPECT_LT(error, 0.5 * last) << samples;
        EXPECT_LT(map.ledger.closure(), 1e-6);
        last = error;
    }
}

TEST(AdaptiveFootprint, NoLightIsLostWhereFootprintsFoldToLinesAndTurnOver) {
    // At the cusp depth columns are lines; far beyond it samples are many pixels wide and lie the other way round.
    for (const double depth : {2.523, 8.0, 30.0}) {
        for (const Formula& waves : {sines({{.01, .5, 0}}), sines({{.01, .5, 45}}), egg_crate(.006, .5)}) {
            const Grid grid = make_grid(64, 64, .5 * root_two, .5 * root_two);
            FloorSettings s;
            s.plan = cover(grid, 70, 50);
            s.depth_m = depth;
            const FloorMap map = map_of(s, sample(grid, {Side::wall, Side::wall}, waves));
            const FloorLedger& l = map.ledger;
            EXPECT_LT(l.closure(), 1e-6) << depth;
            EXPECT_LT(l.lost_w, 1e-6 * l.incident_w) << depth;
            for (const float e : map.irradiance.values()) ASSERT_TRUE(e >= -1e-4F * 1000 && std::isfinite(e)) << e;
        }
    }
}

TEST(AdaptiveFootprint, ANarrowWindowLosesWhatItReports) {
    const Grid grid = make_grid(96, 96, 2, 2);
    const Surface surface = sample(grid, periodic, sines({{.006, .5, 0}, {.004, .6, 35}}));
    for (const double angle : {0.0, 33.0}) {
        FloorSettings s;
        s.plan = cover(grid, 120, 110);
        s.plan.angle_deg = angle;
        s.sun = {60, 20, 1000};
        s.window = FloorWindow{5, 3};
        const FloorMap map = map_of(s, surface);
        EXPECT_LT(map.ledger.closure(), 1e-5);
        EXPECT_GT(map.ledger.lost_w, 1e-3 * map.ledger.incident_w);
    }
}

TEST(AdaptiveFootprint, TheMapDoesNotDependOnTheNumberOfThreads) {
    const Grid grid = make_grid(96, 80, 1.2, 1);
    const Surface surface = sample(grid, periodic, sines({{.008, .4, 25}, {.005, .3, 110}}));
    FloorSettings s;
    s.plan = cover(grid, 211, 157);
    s.depth_m = 2;
    omp_set_num_threads(1);
    const FloorMap one = map_of(s, surface);
    for (const int threads : {2, 3, 5}) {
        omp_set_num_threads(threads);
        const FloorMap many = map_of(s, surface);
        EXPECT_EQ(0, std::memcmp(one.irradiance.data(), many.irradiance.data(), sizeof(float) * one.irradiance.size()));
        EXPECT_EQ(one.ledger.outside_w, many.ledger.outside_w);
    }
    omp_set_num_threads(omp_get_num_procs());
}

}  // namespace
}  // namespace waterlight
