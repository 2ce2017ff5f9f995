// The laws of the floor map: closed forms, energy, and the paper's own error.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>
#include <numbers>

#include "caustics/kernels/optics.hpp"
#include "sim/error.hpp"
#include "tests/support/floor_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

FloorSettings settings_for(const Grid& grid, int width, int height, double elevation_deg) {
    FloorSettings s;
    s.plan = cover(grid, width, height);
    s.sun = {elevation_deg, 30, 1};
    return s;
}

double mean(const Field<float>& f) {
    double sum = 0;
    for (const float v : f.values()) sum += v;
    return sum / static_cast<double>(f.size());
}

double spread(const Field<float>& f, double about) {
    double most = 0;
    for (const float v : f.values()) most = std::max(most, std::abs(v - about));
    return most;
}

/// E0 T ci / Nz through a flat surface.
double transmitted(double elevation_deg, double index) {
    const Sun sun{elevation_deg, 0, 1};
    const f64::Refraction r = f64::refract_sun(sun.direction(), {0, 0}, index, 1);
    return r.incident * r.transmittance;
}

TEST(FloorMap, FlatWaterIsUniformAtAnyElevationAndOrientation) {
    const Grid grid = make_grid(64, 48, 4, 3);
    for (const double elevation : {90.0, 60.0, 30.0, 5.0}) {
        for (const double angle : {0.0, 33.0}) {
            FloorSettings s = settings_for(grid, 100, 70, elevation);
            s.plan.angle_deg = angle;
            const FloorMap map = map_of(s, sample(grid, periodic, flat));
            EXPECT_LT(spread(map.irradiance, transmitted(elevation, 4.0 / 3)), 1e-5) << elevation << " " << angle;
            EXPECT_LT(map.ledger.closure(), 1e-6);
        }
    }
}

TEST(FloorMap, FresnelAtNormalIncidence) { EXPECT_NEAR(transmitted(90, 4.0 / 3), 0.979592, 5e-7); }

TEST(FloorMap, FresnelFromBelowVanishesAtTheCriticalAngle) {
    // The same formula read from the water side: ct = 1/n-scaled sine.
    const double n = 4.0 / 3;
    const auto from_below = [&](double angle_deg) {
        const double in_water = angle_deg * std::numbers::pi / 180;
        const double sin_air = n * std::sin(in_water);
        if (sin_air >= 1) return 0.0;
        return f64::fresnel_transmittance(std::sqrt(1 - sin_air * sin_air), std::cos(in_water), n);
    };
    EXPECT_NEAR(from_below(45), 0.859939, 5e-7);
    EXPECT_LT(from_below(48.5903), 0.01);
    EXPECT_EQ(from_below(48.5904), 0);
}

TEST(FloorMap, WithoutRefractionTheMeanIsTheSunsAlone) {
    const Grid grid = make_grid(128, 128, 2, 2);
    FloorSettings s = settings_for(grid, 256, 256, 45);
    s.optics = {1, false, 0, 0};
    const FloorMap map = map_of(s, sample(grid, periodic, sines({{.03, .5, 0}})));
    EXPECT_NEAR(mean(map.irradiance), std::sqrt(0.5), 1e-4);
}

TEST(FloorMap, EnergyIsConservedOverAPeriodicDomain) {
    const Grid grid = make_grid(256, 256, 2, 2);
    const Surface surface =
        sample(grid, periodic, sines({{.006, .5, 0}, {.004, 2 / std::sqrt(13.0), 33.690067525979785}}));
    for (const double elevation : {90.0, 60.0, 30.0}) {
        for (const bool automatic : {true, false}) {
            FloorSettings s = settings_for(grid, 300, 280, elevation);
            if (!automatic) s.window = FloorWindow{7, 7};
            const FloorMap map = map_of(s, surface);
            const FloorLedger& l = map.ledger;
            const double flux = l.incident_w - l.reflected_w;
            EXPECT_NEAR((l.floor_w + l.lost_w) / flux, 1, 1e-4) << elevation;
            EXPECT_NEAR(l.floor_w, mean(map.irradiance) * 4, 1e-6 * flux);
            EXPECT_LT(l.closure(), 1e-5);
            if (automatic)
                EXPECT_LT(l.lost_w / flux, 1e-3);
            else
                EXPECT_GT(l.lost_w / flux, 1e-3) << "seven samples cannot hold this light";
        }
    }
}

TEST(FloorMap, TheIncidentLightIsThatOfTheHorizontalPlane) {
    const Grid grid = make_grid(128, 128, 2, 2);
    const FloorMap map = map_of(settings_for(grid, 200, 200, 40), sample(grid, periodic, egg_crate(.006, .5)));
    EXPECT_NEAR(map.ledger.incident_w, 4 * std::sin(40 * std::numbers::pi / 180), 1e-4);
}

TEST(FloorMap, TiltedWaterIsUniform) {
    // E = E0 T ci / (Nz (1 + g M)), M = t_x / -t_z.
    const Grid grid = make_grid(64, 64, 4, 4);
    const double g = 0.1;
    FloorSettings s = settings_for(grid, 1024, 4, 60);
    s.sun.azimuth_deg = 0;
    const f64::Refraction r = f64::refract_sun(s.sun.direction(), {g, 0}, 4.0 / 3, 1);
    const double expected = r.incident * r.transmittance / (1 + g * r.travel.x);
    const FloorMap map = map_of(s, sample(grid, periodic, tilted({g, 0}), {g, 0}));
    // The paper's pixel-wide footprint keeps the mean, to a sample at each end, and ripples about it: samples land
    // 1 + g M pixels apart.
    EXPECT_NEAR(mean(map.irradiance), expected, 1.0 / 1024);
}

TEST(FloorMap, AWallShadowsTheFloorBehindIt) {
    const Grid grid = make_grid(64, 64, 4, 4);
    FloorSettings s = settings_for(grid, 128, 128, 30);
    s.sun.azimuth_deg = 0;  // light travels towards -x: the strip along the +x wall stays dark
    s.optics.absorption_per_m = 0.05;
    const FloorMap map = map_of(s, sample(grid, walls, flat));
    const double sin_t = std::cos(30 * std::numbers::pi / 180) / (4.0 / 3),
                 shift = sin_t / std::sqrt(1 - sin_t * sin_t);
    const double expected = transmitted(30, 4.0 / 3) * std::exp(-0.05 * std::sqrt(1 + shift * shift));
    EXPECT_NEAR(map.irradiance(10, 64), expected, 1e-5);
    EXPECT_EQ(map.irradiance(127, 64), 0);
    EXPECT_NEAR(map.ledger.floor_w, expected * 4 * (4 - shift), 1e-4 * 16);
    EXPECT_NEAR(map.ledger.outside_w, expected * 4 * shift, 1e-4 * 16) << "what the wall takes";
    EXPECT_NEAR(map.ledger.incident_w, 16 * 0.5, 1e-4);
    EXPECT_LT(map.ledger.closure(), 1e-6);
}

TEST(FloorMap, NoLightIsUnaccountedForBetweenWallsWhereverTheSunStands) {
    // Slanting light shifts the samples against the map by more rows than a narrow window spans.
    const Grid grid = make_grid(64, 48, 4, 3);
    for (const Formula& water : {Formula(flat), egg_crate(.002, .5)}) {
        for (double azimuth = 0; azimuth < 360; azimuth += 20) {
            for (const Boundary sides : {walls, Boundary{Side::absorbing, Side::wall}, periodic}) {
                FloorSettings s = settings_for(grid, 128, 96, 30);
                s.sun.azimuth_deg = azimuth;
                const FloorMap map = map_of(s, sample(grid, sides, water));
                EXPECT_LT(map.ledger.closure(), 1e-6) << azimuth;
            }
        }
    }
}

// Steep waves under a low sun: half of the water turns away from it.
TEST(FloorMap, WithoutRefractionShadedWaterIsDarkAndNotNaN) {
    const Grid grid = make_grid(64, 64, 1, 1);
    FloorSettings s = settings_for(grid, 64, 64, 5);
    s.optics.refractive_index = 1;
    const FloorMap map = map_of(s, sample(grid, periodic, egg_crate(.05, .5)));
    EXPECT_TRUE(std::isfinite(mean(map.irradiance)));
    EXPECT_LT(map.ledger.closure(), 1e-6);
}

// Within half a degree of the horizon two per cent of the light enters, and floats must still tell how much.
TEST(FloorMap, FresnelOfGrazingLightIsThatOfDoublePrecision) {
    for (const double elevation : {1e-4, 1e-3, 0.01, 0.1, 0.5}) {
        const double cos_i = std::sin(elevation * std::numbers::pi / 180), n = 4.0 / 3;
        const double cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (n * n));
        const double exact = f64::fresnel_transmittance(cos_i, cos_t, n);
        EXPECT_NEAR(exact, 2 * (n + 1 / n) * cos_i / std::sqrt(1 - 1 / (n * n)), 6 * cos_i * exact) << elevation;
        const f32::real3 along(float(-std::cos(std::asin(cos_i))), 0, float(-cos_i));
        EXPECT_NEAR(f32::refract_sun(along, {0, 0}, float(n), 1).transmittance, exact, 1e-6 * exact);
    }
}

TEST(FloorMap, RefusesWhatFloatsCannotHold) {
    const Grid grid = make_grid(16, 16, 1, 1);
    FloorSettings s = settings_for(grid, 16, 16, 90);
    const Surface surface = sample(grid, walls, egg_crate(.01, .5));
    s.depth_m = 1e15;
    EXPECT_THROW(map_of(s, surface), InputError) << "lands farther than floats tell pixels apart";
    s.depth_m = 1e39;
    EXPECT_THROW(map_of(s, surface), InputError);
    s.depth_m = 1;
    s.sun.irradiance_w_m2 = 1e39;
    EXPECT_THROW(map_of(s, surface), InputError);
}

TEST(FloorMap, NoSunNoLightAndNoNaN) {
    const Grid grid = make_grid(32, 32, 1, 1);
    for (const double elevation : {0.0, -10.0, 1e-9}) {
        FloorSettings s = settings_for(grid, 32, 32, elevation);
        s.window = FloorWindow{7, 7};
        const FloorMap map = map_of(s, sample(grid, walls, egg_crate(.001, .5)));
        EXPECT_LT(spread(map.irradiance, 0), elevation > 0 ? 1.0 : 1e-30);
        EXPECT_TRUE(std::isfinite(mean(map.irradiance)));
    }
}

TEST(FloorMap, SameBytesWhateverTheThreads) {
    const Grid grid = make_grid(100, 80, 2, 1.6);
    const Surface surface = sample(grid, walls, egg_crate(.008, .4));
    const FloorSettings s = settings_for(grid, 311, 257, 50);
    omp_set_num_threads(1);
    const FloorMap one = map_of(s, surface);
    for (const int threads : {2, 3, 5}) {
        omp_set_num_threads(threads);
        const FloorMap many = map_of(s, surface);
        EXPECT_EQ(0, std::memcmp(one.irradiance.data(), many.irradiance.data(), sizeof(float) * one.irradiance.size()));
        EXPECT_EQ(one.ledger.floor_w, many.ledger.floor_w);
        EXPECT_EQ(one.ledger.outside_w, many.ledger.outside_w);
    }
    omp_set_num_threads(omp_get_num_procs());
}

TEST(FloorMap, EqualsTheGatherOfThePaper) {
    // The paper's two loops, literally: each pixel asks N samples in each of M + 1 rows for their overlap.
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = sample(grid, periodic, egg_crate(.006, .5));
    FloorSettings s = settings_for(grid, 64, 64, 90);
    s.footprint = Footprint::pixel;
    s.window = FloorWindow{5, 3};
    const FloorMap map = map_of(s, surface);
    for (int y = 0; y < 64; y += 3) {
        for (int x = 0; x < 64; x += 3) {
            double sum = 0;
            for (int j = -1; j <= 1; ++j) {
                for (int i = -2; i <= 2; ++i) {
                    const int column = (x + i + 64) % 64, row = (y + j + 64) % 64;
                    const glm::dvec2 slope{surface.slope_x(column, row), surface.slope_y(column, row)};
                    const f64::Refraction r = f64::refract_sun({0, 0, -1}, slope, 4.0 / 3, 1);
                    const glm::dvec2 d = (1 + double(surface.elevation(column, row))) * r.travel * 64.0;
                    const double ax = std::max(0.0, 1 - std::abs(i + d.x)), ay = std::max(0.0, 1 - std::abs(j + d.y));
                    sum += ax * ay * r.incident * r.transmittance;
                }
            }
            EXPECT_NEAR(map.irradiance(x, y), sum, 2e-5) << x << " " << y;
        }
    }
}

TEST(FloorMap, ThePapersFootprintStaysNearEightPercent) {
    // DESIGN section 5: a pixel-wide footprint does not converge. Frozen sine a = .01, wavelength .5, D = 1.
    for (const int per_wave : {32, 128, 512}) {
        const Grid grid = make_grid(per_wave, 4, .5, 4 * .5 / per_wave);
        FloorSettings s = settings_for(grid, per_wave, 4, 90);
        s.footprint = Footprint::pixel;
        const Formula wave = sines({{.01, .5, 0}});
        const FloorMap map = map_of(s, sample(grid, periodic, wave));
        const TruthMap truth = truth_map({s, 4, 64, 1e-5}, as_truth(grid, periodic, wave));
        const double rmse = relative_rmse(map.irradiance, truth.irradiance);
        RecordProperty("rmse_percent_" + std::to_string(per_wave), std::to_string(100 * rmse));
        EXPECT_GT(rmse, 0.06) << per_wave;
        EXPECT_LT(rmse, 0.10) << per_wave;
        EXPECT_LT(truth.error_estimate, 1e-4);
    }
}

/// Every facet that faces the sun is lit, in the lee of a crest or not: E0 times the mean of max(0, sin el + cos el g
/// cos) over a wave of steepest slope g. Where the sun is higher than that slope, E0 sin el, which is all there is.
TEST(FloorMap, FacetsDoNotShadeEachOther) {
    constexpr int per_wave = 512;
    constexpr double amplitude = .02, wavelength = .5, slope = 2 * std::numbers::pi * amplitude / wavelength;
    const Grid grid = make_grid(per_wave, 4, wavelength, 4 * wavelength / per_wave);
    for (const double elevation : {2.0, 8.0, 20.0, 60.0}) {
        FloorSettings s = settings_for(grid, per_wave, 4, elevation);
        s.sun.azimuth_deg = 0;
        const FloorMap map = map_of(s, sample(grid, periodic, sines({{amplitude, wavelength, 0}})));
        const double sin_el = std::sin(elevation * std::numbers::pi / 180),
                     tilt = slope * std::sqrt(1 - sin_el * sin_el);
        const double lit = std::acos(-std::min(1.0, sin_el / tilt));  // of half a wave, in radians
        const double expected = (sin_el * lit + tilt * std::sin(lit)) / std::numbers::pi;
        const double incident = map.ledger.incident_w / (grid.width_m() * grid.height_m());
        EXPECT_NEAR(incident, expected, 2e-4 * expected) << elevation;
        if (sin_el > tilt) {
            EXPECT_NEAR(expected, sin_el, 1e-12);
        }
        RecordProperty("incident_over_horizontal_" + std::to_string(static_cast<int>(elevation)),
                       std::to_string(incident / sin_el));
    }
}

}  // namespace
}  // namespace waterlight
