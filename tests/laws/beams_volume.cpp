// Fields in the water: flux through every depth, the textbook focus, and the truth before and past it.
#include <gtest/gtest.h>

#include <algorithm>

#include "caustics/beam_point.hpp"
#include "caustics/beam_volume.hpp"
#include "caustics/kernels/optics.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

double mean(std::span<const float> values) {
    double sum = 0;
    for (const float v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

/// Flux per area at height z_m below a periodic surface [0, 2]^2, from its formula in double precision: E0 ci / Nz T
/// exp(-a L), averaged over the surface.
double transmitted(const Formula& wave, const BeamSettings& s, double z_m) {
    const int n = 200;
    double sum = 0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const SurfacePoint p = wave({2 * (i + .5) / n, 2 * (j + .5) / n});
            const f64::Refraction r = f64::refract_sun(s.sun.direction(), p.slope, s.optics.refractive_index, 1);
            sum += r.incident * r.transmittance *
                   f64::beer_lambert(s.optics.absorption_per_m, (p.elevation_m - z_m) * r.path);
        }
    }
    return sum / (n * n);
}

TEST(BeamVolume, EverySliceCarriesTheTransmittedFluxLessItsAbsorption) {
    const Grid grid = make_grid(256, 256, 2, 2);
    const Formula wave = sines({{.006, .5, 0}, {.004, 2 / std::sqrt(13.0), 33.690067525979785}});
    const Surface surface = sample(grid, periodic, wave);
    for (const double elevation : {90.0, 60.0, 30.0}) {
        for (const double absorption : {0.0, 0.2}) {
            BeamSettings s;
            s.depth_m = 8;  // the first focus lies at 3.3 m
            s.grid = {96, 80};
            s.sun = {elevation, 25, 1};
            s.optics.absorption_per_m = absorption;
            Beams beams;
            make_beams(s, surface, beams);
            BeamVolume volume;
            fill_volume(beams, {64, 48, 32}, volume);
            const double entered = beams.ledger.incident_w - beams.ledger.reflected_w;
            for (int k = 0; k < 32; ++k) {
                const double expected = transmitted(wave, s, volume.z_m(k));
                EXPECT_NEAR(mean(volume.plane(k)) / expected, 1, 1e-3) << elevation << " " << k;
                const SliceLedger& l = volume.ledger[k];
                EXPECT_NEAR(l.inside_w, 4 * mean(volume.plane(k)), 1e-6);
                EXPECT_NEAR(l.inside_w + l.outside_w, l.flux_w, 1e-9);
                if (absorption == 0) {
                    EXPECT_NEAR(l.flux_w, entered, 1e-5) << "no depth loses any";
                }
            }
        }
    }
}

TEST(BeamVolume, ScalarIrradianceOfFlatWaterIsThatAcrossTheLight) {
    const Surface surface = sample(make_grid(8, 8, 1, 1), periodic, flat);
    BeamSettings s;
    s.grid = {7, 5};
    s.sun = {35, 10, 1};
    Beams beams;
    make_beams(s, surface, beams);
    BeamVolume volume;
    fill_volume(beams, {9, 8, 4}, volume);
    const f64::Refraction r = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
    for (const float e : volume.plane_irradiance.values()) EXPECT_NEAR(e, r.incident * r.transmittance, 1e-5);
    for (const float e : volume.scalar_irradiance.values()) EXPECT_NEAR(e, r.incident * r.transmittance * r.path, 1e-5);
}

TEST(BeamVolume, BetweenCrestAndTroughOnlyTheWaterIsLit) {
    const Surface surface = sample(make_grid(64, 4, 1, 1), periodic, sines({{.1, 1, 0}}));
    BeamSettings s;
    s.grid = {256, 4};
    s.depth_m = .4;
    Beams beams;
    make_beams(s, surface, beams);
    BeamVolume volume;
    fill_volume(beams, {256, 2, 40}, volume);
    // At z = -0.005 water is where cos(2 pi x) > -0.05: a little more than half of it.
    const double wet = 2 * std::acos(-.05) / (2 * std::numbers::pi);
    const double transmitted = (beams.ledger.incident_w - beams.ledger.reflected_w) / beams.ledger.incident_w;
    EXPECT_NEAR(volume.ledger[39].flux_w / (beams.ledger.incident_w * transmitted), wet, 2e-3);
    EXPECT_EQ(volume.plane(39)[128], 0) << "air below the trough";
    EXPECT_GT(volume.plane(39)[0], 0);
}

/// The frozen sine a = .01, wavelength .5 under an overhead sun.
struct FrozenSine {
    Grid grid;
    Formula wave = sines({{.01, .5, 0}});
    Beams beams;
    BeamVolume volume;
    FrozenSine(int columns, int beam_columns, double depth_m, int slices) : grid(make_grid(columns, 4, .5, .1)) {
        const Surface surface = sample(grid, periodic, wave);
        BeamSettings s;
        s.grid = {beam_columns, 4};
        s.depth_m = depth_m;
        s.sun = {90, 0, 1};
        make_beams(s, surface, beams);
        fill_volume(beams, {columns, 4, slices}, volume);
    }
    /// Relative RMSE of slice k against the truth, in boxes of so many columns.
    double error(int k, int box) const {
        TruthSettings t;
        t.floor.plan = cover(grid, grid.nx, 1);
        t.floor.depth_m = -volume.z_m(k);
        t.floor.sun = {90, 0, 1};
        t.tolerance = 1e-4;
        const TruthMap truth = truth_map(t, as_truth(grid, periodic, wave));
        double difference = 0, square = 0;
        for (int i = 0; i < grid.nx; i += box) {
            double d = 0, e = 0;
            for (int a = i; a < i + box; ++a) {
                d += volume.plane(k)[a] - truth.irradiance(a, 0);
                e += truth.irradiance(a, 0);
            }
            difference += d * d;
            square += e * e;
        }
        return std::sqrt(difference / square);
    }
};

TEST(BeamPoint, AgreesWithTheTruthBeforeAndPastTheFocus) {
    const FrozenSine sine(512, 512, 6, 1);
    for (const double depth : {1.0, 2.0, 4.0}) {
        FloorSettings floor;
        floor.plan = cover(sine.grid, 1, 1);
        floor.depth_m = depth;
        floor.sun = {90, 0, 1};
        const TruthSurface truth = as_truth(sine.grid, periodic, sine.wave);
        for (const double x : {.013, .1, .251, .4}) {
            const PointIrradiance found = irradiance_at(sine.beams, {x, .031, -depth});
            EXPECT_NEAR(found.plane_w_m2 / truth_at(floor, truth, {x, .031}, .002), 1, 0.02) << x << " " << depth;
            EXPECT_GE(found.scalar_w_m2, found.plane_w_m2);
            EXPECT_EQ(found.beams % 2, 1) << "one ray, and two more inside each pair of folds";
        }
    }
    EXPECT_EQ(irradiance_at(sine.beams, {.25, .03, .0}).beams, 0) << "in the air over a trough";
}

TEST(BeamPoint, OnTheAxisTheAreaVanishesAtTheFocus) {
    const FrozenSine sine(2048, 2048, 4, 1);
    double brightest = 0, at = 0;
    for (double depth = 2.3; depth < 2.7; depth += .001) {
        // Off the axis it would be the folds, which leave it with the power 3/2 of the depth past the focus.
        const double e = irradiance_at(sine.beams, {1e-6, .031, -depth}).plane_w_m2;
        if (e > brightest) at = depth;
        brightest = std::max(brightest, e);
    }
    EXPECT_NEAR(at, 2.523, 2e-3);
    EXPECT_GT(brightest, 100);
}

TEST(BeamVolume, FrozenSineFocusesWhereTheTextbookSays) {
    // f - a with f = 1 / ((1 - 1/n) a k2).
    const int slices = 64;
    const double depth = 4, cell = depth / slices;
    const FrozenSine sine(4096, 4096, depth, slices);
    int brightest = 0;
    for (int k = 0; k < slices; ++k)
        if (sine.volume.plane(k)[0] > sine.volume.plane(brightest)[0]) brightest = k;
    EXPECT_NEAR(-sine.volume.z_m(brightest), 2.523, cell);
}

TEST(BeamVolume, SlicesBeforeTheFocusAgreeWithTheTruth) {
    const FrozenSine sine(128, 128, 2.4, 12);
    for (int k = 0; k < 12; ++k) {
        const double error = sine.error(k, 1);
        RecordProperty("rmse_percent_depth_" + std::to_string(-sine.volume.z_m(k)), std::to_string(100 * error));
        EXPECT_LT(error, 0.01) << -sine.volume.z_m(k);
    }
}

TEST(BeamVolume, PastTheFocusTheErrorFallsWithTheGrid) {
    // One slice at 5 m, with the beams of each grid on as many columns; pixel averages and boxes of four.
    double last = 1;
    for (const int n : {32, 64, 128, 256, 512}) {
        const FrozenSine sine(n, n, 10, 1);
        const double pixel = sine.error(0, 1), box = sine.error(0, 4);
        RecordProperty("rmse_percent_" + std::to_string(n), std::to_string(100 * pixel));
        RecordProperty("rmse_percent_boxes_" + std::to_string(n), std::to_string(100 * box));
        EXPECT_LT(pixel, 0.7 * last) << n;
        EXPECT_LT(box, 0.004) << n;
        last = pixel;
    }
    EXPECT_LT(last, 2e-3);
}

}  // namespace
}  // namespace waterlight
