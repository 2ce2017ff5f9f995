// The truth against closed forms, and against itself at several resolutions.
#include <gtest/gtest.h>

#include "caustics/kernels/optics.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

using std::numbers::pi;

TruthSettings truth_settings(const Grid& grid, int width, int height, double elevation_deg) {
    TruthSettings t;
    t.floor.plan = cover(grid, width, height);
    t.floor.sun = {elevation_deg, 25, 1};
    return t;
}

double mean(const Field<double>& f) {
    double sum = 0;
    for (const double v : f.values()) sum += v;
    return sum / static_cast<double>(f.size());
}

TEST(Truth, FlatWaterIsUniform) {
    const Grid grid = make_grid(8, 8, 2, 2);
    const TruthSettings t = truth_settings(grid, 40, 30, 30);
    const TruthMap map = truth_map(t, as_truth(grid, periodic, flat));
    const f64::Refraction r = f64::refract_sun(t.floor.sun.direction(), {0, 0}, 4.0 / 3, 1);
    EXPECT_NEAR(r.incident, 0.5, 1e-12);
    for (const double e : map.irradiance.values()) EXPECT_NEAR(e, 0.5 * r.transmittance, 1e-9);
}

TEST(Truth, WithoutRefractionItIsTheSunsAloneEverywhere) {
    const Grid grid = make_grid(8, 8, 1, 1);
    TruthSettings t = truth_settings(grid, 64, 48, 45);
    t.floor.optics = {1, false, 0, 0};
    const TruthMap map = truth_map(t, as_truth(grid, periodic, sines({{.03, .5, 0}})));
    for (const double e : map.irradiance.values()) EXPECT_NEAR(e, std::sqrt(0.5), 1e-9);
}

TEST(Truth, FrozenSineAtCrestTroughAndMean) {
    const Grid grid = make_grid(128, 8, .5, .03125);
    TruthSettings t = truth_settings(grid, 2048, 2, 90);
    const TruthSurface surface = as_truth(grid, periodic, sines({{.01, .5, 0}}));
    EXPECT_NEAR(truth_at(t.floor, surface, {0, .01}, .01), 1.629210, 1e-6);
    EXPECT_NEAR(truth_at(t.floor, surface, {.25, .01}, .01), 0.704319, 1e-6);
    t.floor.plan.pitch_m.y = t.floor.plan.pitch_m.x;
    t.tolerance = 1e-6;
    const TruthMap map = truth_map(t, surface);
    EXPECT_NEAR(map.irradiance(0, 0), 1.629210, 1e-5);
    EXPECT_NEAR(map.irradiance(1024, 0), 0.704319, 1e-5);
    EXPECT_NEAR(mean(map.irradiance), 0.979591, 1e-6);
}

TEST(Truth, TiltedWater) {
    const Grid grid = make_grid(8, 8, 2, 2);
    TruthSettings t = truth_settings(grid, 16, 16, 60);
    const glm::dvec2 slope{0.1, -0.05};
    const f64::Refraction r = f64::refract_sun(t.floor.sun.direction(), slope, 4.0 / 3, 1);
    const double expected = r.incident * r.transmittance / (1 + glm::dot(slope, r.travel));
    const TruthSurface surface = as_truth(grid, periodic, tilted(slope));
    const TruthMap map = truth_map(t, surface);
    for (const double e : map.irradiance.values()) EXPECT_NEAR(e, expected, 1e-9);
    EXPECT_NEAR(truth_at(t.floor, surface, {.3, .4}, .05), expected, 1e-8);
}

TEST(Truth, BesselSeriesThroughTheFolds) {
    // Paraxial law of the frozen sine, valid past the focus: E / mean = 1 + 2 sum_p J_p(p m) cos(p k X), m = D q, each
    // mode times sinc(p k w / 2) for the average over pixels of width w. Small ka makes it paraxial.
    const double a = 1e-4, wavelength = .5, k = 2 * pi / wavelength, q = (1 - 1 / (4.0 / 3)) * a * k * k, m = 2;
    const int pixels = 64;
    const Grid grid = make_grid(64, 1, wavelength, wavelength / 64);
    TruthSettings t = truth_settings(grid, pixels, 1, 90);
    t.floor.depth_m = m / q;
    t.tolerance = 1e-4;
    const TruthMap map = truth_map(t, as_truth(grid, periodic, sines({{a, wavelength, 0}})));
    const double w = wavelength / pixels;
    std::vector<double> series(pixels, 1.0);
    for (int p = 1; p < 8000; ++p) {
        const double half = p * k * w / 2, mode = 2 * jn(p, p * m) * std::sin(half) / half;
        for (int i = 0; i < pixels; ++i) series[i] += mode * std::cos(p * k * (i + .5) * w);
    }
    double difference = 0, square = 0;
    for (int i = 0; i < pixels; ++i) {
        const double found = map.irradiance(i, 0) / mean(map.irradiance);
        difference += (found - series[i]) * (found - series[i]);
        square += series[i] * series[i];
    }
    EXPECT_LT(std::sqrt(difference / square), 5e-3);
}

TEST(Truth, ErrorEstimateFallsAndBoundsTheError) {
    const Grid grid = make_grid(64, 64, .5, .5);
    const TruthSurface surface = as_truth(grid, periodic, egg_crate(.006, .5));
    TruthSettings t = truth_settings(grid, 64, 64, 70);
    t.tolerance = 1e-12;
    t.subsamples = 32;
    t.most_subsamples = 64;
    const TruthMap finest = truth_map(t, surface);
    double last = 1;
    for (const int m : {1, 2, 4}) {
        t.subsamples = m;
        t.most_subsamples = 2 * m;
        const TruthMap map = truth_map(t, surface);
        double difference = 0, square = 0;
        for (std::size_t i = 0; i < map.irradiance.size(); ++i) {
            const double d = map.irradiance.data()[i] - finest.irradiance.data()[i];
            difference += d * d;
            square += finest.irradiance.data()[i] * finest.irradiance.data()[i];
        }
        const double error = std::sqrt(difference / square);
        EXPECT_LT(error, map.error_estimate);
        EXPECT_LT(error, 0.3 * last) << "second order before the focus";
        last = error;
        EXPECT_LT(map.ledger.closure(), 1e-12);
    }
}

TEST(Truth, InterpolatedSurfaceConvergesToItsFormula) {
    double last = 1;
    for (const int n : {16, 32, 64}) {
        const Grid grid = make_grid(n, n, 1, 1);
        const Formula wave = sines({{.01, .5, 0}, {.01, 1 / std::sqrt(2.0), 45}});
        const Surface s = sample(grid, periodic, wave);
        const TruthSurface between = interpolate(s);
        double worst = 0;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec2 at{-0.3 + 0.0091 * i, 1.7 - 0.013 * i};
            worst = std::max(worst, glm::length(between.at(at).slope - wave(at).slope));
        }
        EXPECT_LT(worst, last / 6) << "third order in slope";
        last = worst;
    }
}

TEST(Truth, WallsCutTheLight) {
    const Grid grid = make_grid(32, 32, 4, 4);
    TruthSettings t = truth_settings(grid, 32, 32, 30);
    t.floor.sun.azimuth_deg = 0;
    const TruthMap map = truth_map(t, as_truth(grid, {Side::wall, Side::wall}, flat));
    EXPECT_EQ(map.irradiance(31, 5), 0);
    EXPECT_NEAR(map.ledger.incident_w, 8, 1e-9);
    EXPECT_NEAR(map.ledger.floor_w + map.ledger.outside_w + map.ledger.reflected_w, 8, 1e-9);
}

}  // namespace
}  // namespace waterlight
