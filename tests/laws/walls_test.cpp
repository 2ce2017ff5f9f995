// The laws of light on walls: the closed form below flat water, the account of all light, and the floor map's own.
#include "caustics/walls.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>
#include <numeric>

#include "caustics/kernels/optics.hpp"
#include "sim/error.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

constexpr std::size_t west = 0, east = 1, south = 2, north = 3;

WallSettings settings_for(double elevation_deg, double azimuth_deg) {
    WallSettings s;
    s.pixel_m = .05;
    s.above_m = .05;
    s.depth_m = 2;
    s.sun = {elevation_deg, azimuth_deg, 1000};
    return s;
}

WallMaps maps_of(const WallSettings& settings, const Surface& surface) {
    WallMaps maps;
    light_walls(settings, surface, maps);
    return maps;
}

double mean(const Field<float>& f) {
    return std::accumulate(f.values().begin(), f.values().end(), 0.0) / static_cast<double>(f.size());
}

// Flat water: the beam's flux through the horizontal, times its slant, on a wall; from the waterline down to where the
// ray comes from the other side's edge; less what the way takes.
TEST(Walls, BelowFlatWaterTheyHaveTheClosedForm) {
    const Surface surface = sample(make_grid(120, 80, 1.5, 1), walls, flat);
    WallSettings s = settings_for(30, 0);  // the sun in the east lights the west wall
    s.optics.absorption_per_m = .3;
    s.depth_m = 3;
    const WallMaps maps = maps_of(s, surface);
    const f64::Refraction r = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
    const double slant = -r.travel.x, lit_m = 1.5 / slant;
    ASSERT_LT(lit_m, 2.8) << "the test needs a shadow on the wall";
    const WallPlan plan = wall_plan(s, surface.grid, west);
    const auto exact = [&](double depth_m) {
        return depth_m < 0 || depth_m > lit_m
                   ? 0.0
                   : 1000 * r.incident * r.transmittance * slant * std::exp(-.3 * depth_m * r.path);
    };
    for (int j = 0; j < plan.rows; ++j) {
        const double depth_m = 3 - (j + .5) * plan.pitch_m.y;
        if (std::abs(depth_m - lit_m) < plan.pitch_m.y) continue;
        EXPECT_NEAR(maps.irradiance[west](7, j), exact(depth_m), 2e-4 * exact(0)) << depth_m;
    }
    EXPECT_EQ(maps.power_w[east], 0);
    EXPECT_NEAR(maps.power_w[south], 0, 1e-9);
}

TEST(Walls, ACornerIsLitOnce) {
    const Surface surface = sample(make_grid(50, 40, 1.5, 1.2), walls, flat);
    const WallSettings s = settings_for(35, 215);
    const WallMaps maps = maps_of(s, surface);
    const f64::Refraction r = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
    ASSERT_GT(r.travel.x, 0);
    ASSERT_GT(r.travel.y, 0);
    // Of the block of light that enters, what lands inside, leaves first over x, and first over y.
    const double flux = 1000 * r.incident * r.transmittance, reach_x = 2 * r.travel.x, reach_y = 2 * r.travel.y;
    const double floor = flux * (1.5 - reach_x) * (1.2 - reach_y);
    const double over_x = flux * (reach_x * (1.2 - reach_y) + .5 * reach_x * reach_y);
    const double over_y = flux * (reach_y * (1.5 - reach_x) + .5 * reach_x * reach_y);
    EXPECT_NEAR(maps.ledger.floor_w, floor, 1e-6 * floor);
    EXPECT_NEAR(maps.power_w[east], over_x, 1e-6 * over_x);
    EXPECT_NEAR(maps.power_w[north], over_y, 1e-6 * over_y);
    EXPECT_EQ(maps.power_w[west], 0);
    EXPECT_EQ(maps.power_w[south], 0);
    EXPECT_LT(maps.ledger.closure(), 1e-9);
}

TEST(Walls, WithWavesAllLightIsAccountedForAndTheFloorsIsThatOfItsMap) {
    const Grid grid = make_grid(150, 120, 1.5, 1.2);
    // Half waves fit the walls: the slope is zero there, as of water.
    const Surface surface = sample(grid, walls, sines({{.006, 1.0, 0}, {.004, .8, 90}, {.003, .3, 0}}));
    WallSettings s = settings_for(50, 200);
    s.optics.absorption_per_m = .1;
    s.optics.scattering_per_m = .05;
    const WallMaps maps = maps_of(s, surface);
    EXPECT_LT(maps.ledger.closure(), 1e-6);
    EXPECT_GT(maps.ledger.walls_w, .05 * maps.ledger.incident_w);
    EXPECT_NEAR(maps.ledger.absorbed_w, 2 * maps.ledger.scattered_w, 1e-9 * maps.ledger.incident_w);
    EXPECT_NEAR(std::accumulate(maps.power_w.begin(), maps.power_w.end(), 0.0), maps.ledger.walls_w,
                1e-6 * maps.ledger.walls_w);
    FloorSettings f;
    f.plan = cover(grid, 300, 240);
    f.depth_m = s.depth_m;
    f.sun = s.sun;
    f.optics = s.optics;
    FloorMap map;
    make_floor_cpu(f)->compute(surface, map);
    EXPECT_NEAR(maps.ledger.incident_w, map.ledger.incident_w, 1e-4 * map.ledger.incident_w);
    EXPECT_NEAR(maps.ledger.reflected_w, map.ledger.reflected_w, 1e-3 * map.ledger.reflected_w);
    EXPECT_NEAR(maps.ledger.floor_w, map.ledger.floor_w, 2e-3 * map.ledger.floor_w);
    std::printf("floor of the walls' account %.3f W, of the floor map's %.3f W\n", maps.ledger.floor_w,
                map.ledger.floor_w);
}

TEST(Walls, BetweenPeriodicSidesAWallIsAsBrightAllAlong) {
    const Surface surface = sample(make_grid(40, 30, 1.5, 1), {Side::wall, Side::periodic}, flat);
    const WallMaps maps = maps_of(settings_for(40, 225), surface);
    EXPECT_TRUE(maps.irradiance[south].empty());
    const Field<float>& lit = maps.irradiance[east];
    ASSERT_GT(mean(lit), 1);
    for (int j = 0; j < 40; ++j)
        for (int i = 1; i < lit.nx(); ++i) ASSERT_NEAR(lit(i, j), lit(0, j), 1e-3);
    EXPECT_LT(maps.ledger.closure(), 1e-9);
    EXPECT_NEAR(maps.ledger.outside_w, 0, 1e-9);
}

TEST(Walls, ConvergeWithTheSurfacesCells) {
    WallSettings s = settings_for(40, 180);
    s.pixel_m = .02;
    const auto map = [&](int cells) {
        return maps_of(s, sample(make_grid(cells, 8, 1, .1), walls, sines({{.004, .5, 0}, {.002, .25, 0}})))
            .irradiance[east]
            .clone();
    };
    const Field<float> finest = map(1024);
    const auto error = [&](int cells) {
        const Field<float> f = map(cells);
        double d = 0, sum = 0;
        for (std::size_t k = 0; k < f.size(); ++k) {
            d += std::pow(f.data()[k] - finest.data()[k], 2);
            sum += std::pow(finest.data()[k], 2);
        }
        return std::sqrt(d / sum);
    };
    const double coarse = error(64), fine = error(128), finer = error(256);
    std::printf("relative RMSE on the wall: %.2g, %.2g, %.2g at 64, 128, 256 cells a metre\n", coarse, fine, finer);
    EXPECT_LT(fine, coarse / 2);
    EXPECT_LT(finer, fine / 2);
    EXPECT_LT(finer, .01);
}

TEST(Walls, AreTheSameOnAnyNumberOfThreads) {
    const Surface surface = sample(make_grid(60, 50, 1.5, 1.2), walls, sines({{.006, 1.0, 0}}));
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    const WallMaps one = maps_of(settings_for(40, 200), surface);
    omp_set_num_threads(3);
    const WallMaps three = maps_of(settings_for(40, 200), surface);
    omp_set_num_threads(threads);
    EXPECT_EQ(std::memcmp(one.irradiance[east].data(), three.irradiance[east].data(),
                          one.irradiance[east].size() * sizeof(float)),
              0);
    EXPECT_EQ(one.ledger.floor_w, three.ledger.floor_w);
}

TEST(Walls, RefuseWhatIsNoWallAndWhatIsOutOfRange) {
    const Surface open = sample(make_grid(8, 8, 1, 1), {Side::periodic, Side::absorbing}, flat);
    const Surface pool = sample(make_grid(8, 8, 1, 1), walls, flat);
    WallMaps maps;
    WallSettings s = settings_for(40, 0);
    EXPECT_THROW(light_walls(s, open, maps), InputError);
    s.pixel_m = 0;
    EXPECT_THROW(light_walls(s, pool, maps), InputError);
}

}  // namespace
}  // namespace waterlight
