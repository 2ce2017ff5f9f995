// Caustics mapping of water alone: even light, energy, convergence to the truth, sides of every kind, ground.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "caustics/kernels/splat.hpp"
#include "caustics/relief.hpp"
#include "caustics/spectral_floor.hpp"
#include "sim/error.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/splat_maps.hpp"

namespace waterlight {
namespace {

using namespace test;

double still_irradiance(const FloorSettings& s) {
    const f64::Refraction r = f64::refract_sun(s.sun.direction(), {0, 0}, s.optics.refractive_index, 1);
    return s.sun.irradiance_w_m2 * r.incident * r.transmittance *
           std::exp(-s.optics.extinction_per_m() * s.depth_m * r.path);
}

double largest_departure(const Field<float>& f, double from) {
    double most = 0;
    for (const float v : f.values()) most = std::max(most, std::abs(v - from) / from);
    return most;
}

TEST(Splat, StillWaterIsEvenWhateverTheGridAndThePixels) {
    const Grid grid = make_grid(16, 12, 4, 3);
    for (const Boundary sides : {periodic, open_sides})
        for (const double elevation : {90.0, 40.0, 8.0})
            for (const int vertices : {40, 64, 101, 190}) {
                SplatSettings s = splat_settings(grid, 64, 48, elevation);
                s.floor.optics.absorption_per_m = 0.1;
                s.options.grid = vertices;
                const FloorMap map = splat_map(s, sample(grid, sides, flat));
                EXPECT_LT(largest_departure(map.irradiance, still_irradiance(s.floor)), 1e-3)
                    << elevation << " " << vertices;
                EXPECT_LT(map.ledger.closure(), 1e-6);
            }
}

TEST(Splat, AMapThatIsTurnedOrAPartOrReachesBeyondAPeriodSeesTheSameLight) {
    const Grid grid = make_grid(16, 12, 4, 3);
    for (const FloorPlan& plan :
         {FloorPlan{50, 40, {1, 0.5}, {0.03, 0.04}, 33}, FloorPlan{20, 20, {1, 1}, {.05, .05}, 0},
          FloorPlan{100, 80, {-1, -2}, {.1, .1}, 0}}) {
        SplatSettings s = splat_settings(grid, 64, 48, 50);
        s.floor.plan = plan;
        const FloorMap map = splat_map(s, sample(grid, periodic, flat));
        EXPECT_LT(largest_departure(map.irradiance, still_irradiance(s.floor)), 1e-3);
        EXPECT_LT(map.ledger.closure(), 1e-6);
    }
}

// Both sides of a pool between walls: light that the wall keeps out is missing over a sharp edge, and no seam is dark.
TEST(Splat, TheShadowOfAWallIsSharpAndTheOtherWallHasNoSeam) {
    const Grid grid = make_grid(16, 16, 4, 4);
    SplatSettings s = splat_settings(grid, 128, 128, 30);
    s.floor.sun.azimuth_deg = 0;  // light travels towards -x
    const FloorMap map = splat_map(s, sample(grid, walls, flat));
    const f64::Refraction r = f64::refract_sun(s.floor.sun.direction(), {0, 0}, 4.0 / 3, 1);
    const double still = still_irradiance(s.floor), shadow = -r.travel.x, edge = (4 - shadow) / (4.0 / 128);
    for (int i = 0; i < 128; ++i) {
        const double lit = std::clamp(edge - i, 0.0, 1.0), away = std::abs(i + 0.5 - edge);
        const double tolerance = away < 1.5 ? 0.15 : (away < 3 ? 0.01 : 1e-3);
        for (const int j : {0, 1, 64, 127}) EXPECT_NEAR(map.irradiance(i, j) / still, lit, tolerance) << i << " " << j;
    }
    EXPECT_NEAR(map.ledger.outside_w, still * 4 * shadow, 1e-3 * still * 16);
    EXPECT_LT(map.ledger.closure(), 1e-6);
}

// The covariance of a splat is that of the landed Gaussian, cut off at its reach (1 % less), and of the pixels.
TEST(Splat, ASplatsPixelsHaveItsPowerItsMiddleAndItsCovariance) {
    using f64::real2;
    for (const auto& [a, b] : {std::pair{real2(1, 0), real2(0, 1)},
                               {real2(3, 1), real2(-1, 2)},
                               {real2(0.6, 2.5), real2(0.3, -1.5)},
                               {real2(2, 2), real2(1.8, 2.2)}}) {
        const f64::SplatShape shape = f64::landed_splat(a, b, real2(0, 0), real2(0, 0));
        const glm::dvec2 centre{0.31, 0.74};
        double power = 0, xx = 0, xy = 0, yy = 0;
        glm::dvec2 middle{0, 0};
        for (int j = -30; j <= 30; ++j)
            for (int i = -30; i <= 30; ++i) {
                const double share = f64::splat_in_pixel(shape, glm::dvec2(i, j) - centre);
                const glm::dvec2 at = glm::dvec2(i + .5, j + .5) - centre;
                power += share;
                middle += share * at;
                xx += share * at.x * at.x;
                xy += share * at.x * at.y;
                yy += share * at.y * at.y;
            }
        const double v = f64::splat_deviation * f64::splat_deviation;
        EXPECT_NEAR(power, 1, 1e-6);
        EXPECT_NEAR(glm::length(middle), 0, 0.01);
        EXPECT_NEAR(xx, v * (a.x * a.x + b.x * b.x) + 1. / 12, 0.02 * xx);
        EXPECT_NEAR(yy, v * (a.y * a.y + b.y * b.y) + 1. / 12, 0.02 * yy);
        EXPECT_NEAR(xy, v * (a.x * a.y + b.x * b.y), 0.02 * std::sqrt(xx * yy));
    }
}

struct Measured {
    double rmse, floor_over_light;
};

Measured measure(double depth_m, double elevation_deg, int pixels, SplatOptions::Size size, Boundary sides) {
    const Grid grid = make_grid(6 * pixels, 6 * pixels, .5, .5);
    const Formula waves = egg_crate(.006, .5);
    SplatSettings s = splat_settings(grid, pixels, pixels, elevation_deg);
    s.floor.depth_m = depth_m;
    s.floor.optics.absorption_per_m = 0.05;
    s.options.size = size;
    TruthSettings t;
    t.floor = s.floor;
    t.most_subsamples = 16;
    t.tolerance = 2e-5;
    const TruthMap truth = truth_map(t, as_truth(grid, sides, waves));
    const FloorMap map = splat_map(s, sample(grid, sides, waves));
    const FloorLedger& l = map.ledger;
    EXPECT_LT(l.closure(), 1e-6);
    EXPECT_EQ(l.lost_w, 0);
    const double light = l.incident_w - l.reflected_w - l.extinguished_w - l.outside_w + l.entered_w;
    const Measured m{relative_rmse(map.irradiance, truth.irradiance), l.floor_w / light};
    std::printf(
        "depth %g m, sun at %g, %s, %s, %d pixels: relative RMSE %.3g %% (truth to %.1g %%), floor/light %.6f\n",
        depth_m, elevation_deg, sides.x == Side::wall ? "walls" : "periodic",
        size == SplatOptions::Size::fixed ? "fixed" : "jacobian", pixels, 100 * m.rmse, 100 * truth.error_estimate,
        m.floor_over_light);
    return m;
}

// One vertex a pixel. With the centres moved by half the second difference the blur cancels to fourth order: the order
// is above 1.5 until what is left is the unevenness of the splats' own lattice, below 1e-4.
TEST(Splat, ConvergesToTheTruthBeforeTheFocus) {
    for (const double elevation : {90.0, 60.0}) {
        const double depth = elevation == 90 ? 3 : 2;  // under a slanting sun the focus is nearer
        const double coarse = measure(depth, elevation, 32, SplatOptions::Size::jacobian, periodic).rmse;
        const double middle = measure(depth, elevation, 64, SplatOptions::Size::jacobian, periodic).rmse;
        const double fine = measure(depth, elevation, 128, SplatOptions::Size::jacobian, periodic).rmse;
        EXPECT_LT(middle, coarse);
        EXPECT_LT(fine, middle);
        EXPECT_GT(std::log2(coarse / fine) / 2, 1.2) << elevation;
        EXPECT_LT(fine, 5e-4);
    }
    const double near = measure(1, 90, 32, SplatOptions::Size::jacobian, periodic).rmse,
                 nearer = measure(1, 90, 64, SplatOptions::Size::jacobian, periodic).rmse;
    EXPECT_LT(near, 2e-4);
    EXPECT_LT(nearer, 1e-4);
}

// Past the focus irradiance is without bound on folds, and pixel averages converge slowly: order one half to one.
TEST(Splat, ConvergesToTheTruthThroughFolds) {
    const double coarse = measure(8, 90, 64, SplatOptions::Size::jacobian, periodic).rmse;
    const double fine = measure(8, 90, 256, SplatOptions::Size::jacobian, periodic).rmse;
    EXPECT_GT(std::log2(coarse / fine) / 2, 0.5);
    EXPECT_LT(fine, 0.03);
}

TEST(Splat, ConvergesToTheTruthBetweenWalls) {
    const double coarse = measure(3, 90, 32, SplatOptions::Size::jacobian, walls).rmse;
    const double fine = measure(3, 90, 128, SplatOptions::Size::jacobian, walls).rmse;
    EXPECT_GT(std::log2(coarse / fine) / 2, 1.2);
    EXPECT_LT(fine, 2e-4);
}

// The paper's fixed splats leave ripples where vertices land farther apart than splats are wide, at any resolution.
TEST(Splat, FixedSplatsDoNotConverge) {
    const double coarse = measure(3, 90, 64, SplatOptions::Size::fixed, periodic).rmse;
    const double fine = measure(3, 90, 256, SplatOptions::Size::fixed, periodic).rmse;
    EXPECT_GT(fine, 0.015);
    EXPECT_GT(fine, 0.5 * coarse);
}

TEST(Splat, EnergyIsWhatComesInLessWhatIsReflectedAndExtinguished) {
    for (const double depth : {1.0, 3.0, 8.0})
        for (const auto size : {SplatOptions::Size::jacobian, SplatOptions::Size::fixed}) {
            const Measured m = measure(depth, 55, 48, size, periodic);
            EXPECT_NEAR(m.floor_over_light, 1, 1e-6);
        }
}

// On tilted water E = E0 T ci / (Nz (1 + g M)), M = t_x / -t_z, everywhere.
TEST(Splat, TiltedWaterIsUniformAndItsLightIsNotWrapped) {
    const Grid grid = make_grid(16, 16, 4, 4);
    const double g = 0.1;
    SplatSettings s = splat_settings(grid, 64, 64, 60);
    s.floor.sun.azimuth_deg = 0;
    s.floor.depth_m = 2;
    const f64::Refraction r = f64::refract_sun(s.floor.sun.direction(), {g, 0}, 4.0 / 3, 1);
    const FloorMap map = splat_map(s, sample(grid, periodic, tilted({g, 0}), {g, 0}));
    const double expected = 1000 * r.incident * r.transmittance / (1 + g * r.travel.x);
    EXPECT_LT(largest_departure(map.irradiance, expected), 1e-3);
    EXPECT_GT(map.ledger.entered_w, 0);
    EXPECT_LT(map.ledger.closure(), 1e-6);
}

// On a plane z = -d + g x light that travels M a metre is 1 + g M times as dense a horizontal metre.
TEST(Splat, OnAPlaneSlopeTheLightOfStillWaterHasTheClosedForm) {
    const Grid grid = make_grid(80, 60, 4, 3);
    for (const double g : {-.3, .2, .5}) {
        SplatSettings s = splat_settings(grid, 160, 120, 50);
        Field<float> bed(grid.nx, grid.ny);
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) bed(i, j) = static_cast<float>(-1.5 + g * (grid.x_m(i) - 2));
        s.bed_m = std::make_shared<Field<float>>(std::move(bed));
        const f64::Refraction r = f64::refract_sun(s.floor.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const double level = 1000 * r.incident * r.transmittance * (1 + g * r.travel.x);
        SplatReport report;
        const FloorMap sloping = splat_map(s, sample(grid, walls, flat), &report);
        EXPECT_EQ(report.not_converged, 0);
        s.per_ground_area = false;
        const FloorMap horizontal = splat_map(s, sample(grid, walls, flat));
        for (const int i : {60, 80, 100}) {
            EXPECT_NEAR(horizontal.irradiance(i, 60), level, 1e-3 * level) << g;
            EXPECT_NEAR(sloping.irradiance(i, 60), level / std::sqrt(1 + g * g), 1e-3 * level) << g;
        }
        EXPECT_LT(sloping.ledger.closure(), 1e-6);
    }
}

// On hills under waves: the map of relief, which lands each corner exactly.
TEST(Splat, OnHillsItIsTheMapOfExactLanding) {
    const Grid grid = make_grid(192, 192, 2, 2);
    const Surface surface = sample(grid, periodic, sines({{.004, 1, 0}, {.003, .5, 90}}));
    const double k = std::numbers::pi;
    Field<float> bed(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            bed(i, j) = static_cast<float>(-1.2 + .15 * std::sin(k * grid.x_m(i)) * std::cos(k * grid.y_m(j)));
    double last = 1;
    for (const int pixels : {24, 48, 96}) {
        SplatSettings s = splat_settings(grid, pixels, pixels, 60);
        s.bed_m = std::make_shared<Field<float>>(bed.clone());
        ReliefSettings fine;
        fine.floor = s.floor;
        fine.floor.plan = cover(grid, 4 * pixels, 4 * pixels);
        fine.bed_m = bed.clone();
        fine.per_ground_area = s.per_ground_area = false;
        FloorMap exact;
        make_relief_floor(std::move(fine))->compute(surface, exact);
        const FloorMap map = splat_map(s, surface);
        Field<double> averages(pixels, pixels);
        for (int j = 0; j < 4 * pixels; ++j)
            for (int i = 0; i < 4 * pixels; ++i) averages(i / 4, j / 4) += exact.irradiance(i, j) / 16.0;
        const double rmse = relative_rmse(map.irradiance, averages);
        std::printf("hills, %d pixels: relative RMSE %.3g %%\n", pixels, 100 * rmse);
        EXPECT_LT(rmse, 0.7 * last);
        last = rmse;
        EXPECT_NEAR(map.ledger.floor_w, exact.ledger.floor_w, 1e-4 * exact.ledger.floor_w);
        EXPECT_LT(map.ledger.closure(), 1e-6);
    }
    EXPECT_LT(last, 0.01);
}

// A lamp over still water, n = 1: I h / r^3 on the floor, and all that falls on the domain's rectangle.
TEST(Splat, ALampLightsAsTheInverseSquareSays) {
    const Grid grid = make_grid(32, 32, 4, 4);
    SplatSettings s = splat_settings(grid, 96, 96, 90);
    s.floor.optics.refractive_index = 1;
    s.lamp = Lamp{.at_m = {1.5, 2.2, 2}, .intensity_w_sr = 100};
    for (const Boundary sides : {open_sides, walls}) {
        const FloorMap map = splat_map(s, sample(grid, sides, flat));
        for (const glm::ivec2 pixel : {glm::ivec2{40, 50}, {20, 60}, {60, 40}}) {
            const glm::dvec2 at = s.floor.plan.position_m(glm::dvec2(pixel) + 0.5);
            const double r = glm::length(glm::dvec3{at, -1} - s.lamp->at_m);
            EXPECT_NEAR(map.irradiance(pixel.x, pixel.y), 100 * 3 / (r * r * r), 2e-3 * 100 * 3 / (r * r * r));
        }
        EXPECT_LT(map.ledger.closure(), 1e-6);
    }
    s.lamp = Lamp{Lamp::Type::spot, {2, 2, 2}, 100, {2, 2, 0}, 20};
    const FloorMap spot = splat_map(s, sample(grid, walls, flat));
    EXPECT_NEAR(spot.ledger.floor_w, s.lamp->power_w(), 0.01 * s.lamp->power_w());
}

TEST(Splat, SameBytesWhateverTheThreads) {
    const Grid grid = make_grid(100, 80, 2, 1.6);
    const Surface surface = sample(grid, walls, egg_crate(.008, .4));
    SplatSettings s = splat_settings(grid, 211, 157, 50);
    omp_set_num_threads(1);
    const FloorMap one = splat_map(s, surface);
    for (const int threads : {2, 3, 5}) {
        omp_set_num_threads(threads);
        const FloorMap many = splat_map(s, surface);
        EXPECT_EQ(0, std::memcmp(one.irradiance.data(), many.irradiance.data(), sizeof(float) * one.irradiance.size()));
        EXPECT_EQ(one.ledger.floor_w, many.ledger.floor_w);
        EXPECT_EQ(one.ledger.outside_w, many.ledger.outside_w);
    }
    omp_set_num_threads(omp_get_num_procs());
}

TEST(Splat, InColourItIsTheSumOfItsBands) {
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = sample(grid, periodic, egg_crate(.006, .5));
    const SplatSettings s = splat_settings(grid, 64, 64, 60);
    const FloorMaker make = [&](const FloorSettings& floor) -> std::unique_ptr<FloorMapper> {
        SplatSettings of_band = s;
        of_band.floor = floor;
        return make_splat_floor_cpu(of_band);
    };
    Band blue{450, 0.4, s.floor.optics}, red{650, 0.6, s.floor.optics};
    blue.optics.absorption_per_m = 0.0092;
    red.optics.absorption_per_m = 0.34;
    red.optics.refractive_index = 1.331;
    SpectralFloor colours(s.floor, {blue, red}, make);
    FloorMap sum;
    colours.compute(surface, sum);
    const FloorMap& b = colours.maps()[0].map;
    const FloorMap& r = colours.maps()[1].map;
    EXPECT_FLOAT_EQ(sum.irradiance(10, 20), b.irradiance(10, 20) + r.irradiance(10, 20));
    EXPECT_GT(b.ledger.floor_w / 0.4, 1.2 * r.ledger.floor_w / 0.6);
    EXPECT_LT(sum.ledger.closure(), 1e-6);
}

TEST(Splat, NoSunNoLightAndNoNaN) {
    const Grid grid = make_grid(32, 32, 1, 1);
    for (const double elevation : {0.0, -10.0, 1e-9}) {
        const SplatSettings s = splat_settings(grid, 32, 32, elevation);
        const FloorMap map = splat_map(s, sample(grid, walls, egg_crate(.001, .5)));
        for (const float v : map.irradiance.values()) EXPECT_TRUE(std::isfinite(v) && std::abs(v) < 1);
        EXPECT_LT(map.ledger.closure(), 1e-6);
    }
    SplatSettings s = splat_settings(grid, 32, 32, 5);
    s.floor.optics.refractive_index = 1;
    const FloorMap map = splat_map(s, sample(grid, periodic, egg_crate(.05, .5)));
    for (const float v : map.irradiance.values()) EXPECT_TRUE(std::isfinite(v));
    EXPECT_LT(map.ledger.closure(), 1e-5);
}

TEST(Splat, RefusesWhatIsOutOfRange) {
    const Grid grid = make_grid(8, 8, 1, 1);
    const auto refuses = [&](auto change) {
        SplatSettings s = splat_settings(grid, 8, 8, 90);
        change(s);
        EXPECT_THROW(make_splat_floor_cpu(s), InputError);
    };
    refuses([](SplatSettings& s) { s.options.grid = 1; });
    refuses([](SplatSettings& s) { s.options.grid = 16385; });
    refuses([](SplatSettings& s) { s.options.iterations = 0; });
    refuses([](SplatSettings& s) { s.options.radius_pixels = 0; });
    refuses([](SplatSettings& s) { s.options.bounces = 0; });
    refuses([](SplatSettings& s) { s.floor.depth_m = -1; });
    refuses([](SplatSettings& s) { s.lamp = Lamp{.at_m = {0, 0, -0.5}}; });
    refuses([](SplatSettings& s) { s.lamp = Lamp{.type = Lamp::Type::spot, .half_angle_deg = 90}; });
    SplatSettings s = splat_settings(grid, 8, 8, 90);
    s.bed_m = std::make_shared<Field<float>>(4, 8);
    EXPECT_THROW(splat_map(s, sample(grid, walls, flat)), InputError);
}

}  // namespace
}  // namespace waterlight
