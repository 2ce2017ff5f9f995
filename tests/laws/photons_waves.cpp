// Photons through waves over a flat floor, against the truth and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "caustics/kernels/optics.hpp"
#include "caustics/relief.hpp"
#include "caustics/truth.hpp"
#include "tests/support/photon_maps.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;
using Start = PhotonOptions::Start;

constexpr Start both_starts[] = {Start::surface, Start::light};

/// Waves of .5 m, before their focus at this depth, finely sampled.
struct Waves {
    Grid grid = make_grid(256, 256, 1, 1);
    Formula formula = sines({{.006, .5, 0}, {.004, .5, 90}});
    Surface surface = sample(grid, periodic, formula);

    PhotonSettings settings(Start start, int map) const {
        PhotonSettings s = photons_over(grid, 64, 64, 70);
        s.options = {.start = start, .map = map};
        return s;
    }
    TruthMap truth(const PhotonSettings& s) const {
        return truth_map({.floor = s.floor, .tolerance = 2e-4}, as_truth(grid, periodic, formula));
    }
};

TEST(PhotonWaves, ConvergeToTheTruthFasterThanByChance) {
    const Waves waves;
    const TruthMap truth = waves.truth(waves.settings(Start::surface, 1));
    for (const Start start : both_starts) {
        std::vector<double> errors;
        for (const int map : {64, 128, 256, 512})
            errors.push_back(
                relative_rmse(photon_map(waves.settings(start, map), waves.surface).map.irradiance, truth.irradiance));
        // Photons within their own cells miscount only those whose landed cells a pixel's edge cuts: of m in a pixel,
        // about sqrt(m). So the error falls as m^(1/4) / m: with N^(-3/4), not with N^(-1/2) as of unordered ones.
        for (std::size_t k = 1; k < errors.size(); ++k) {
            const double order = std::log(errors[k - 1] / errors[k]) / std::log(4);
            EXPECT_NEAR(order, 0.75, 0.05) << int(start) << ' ' << k;
        }
        EXPECT_LT(errors.back(), 0.04);
    }
}

TEST(PhotonWaves, KeepTheLight) {
    const Waves waves;
    const TruthMap truth = waves.truth(waves.settings(Start::surface, 1));
    for (const Start start : both_starts) {
        const FloorLedger ledger = photon_map(waves.settings(start, 128), waves.surface).map.ledger;
        EXPECT_LT(ledger.closure(), 1e-12);
        EXPECT_NEAR(ledger.incident_w, 1000 * std::sin(70 * std::numbers::pi / 180), 1e-4 * ledger.incident_w);
        EXPECT_NEAR(ledger.floor_w, truth.ledger.floor_w, 1e-4 * ledger.floor_w);
        EXPECT_EQ(ledger.outside_w, 0);
        EXPECT_EQ(ledger.entered_w, 0);
    }
}

TEST(PhotonWaves, TellTheirOwnError) {
    const Waves waves;
    const TruthMap truth = waves.truth(waves.settings(Start::surface, 1));
    for (const Start start : both_starts)
        for (const int map : {48, 96, 192}) {
            PhotonSettings s = waves.settings(start, map);
            s.options.passes = 4;
            const PhotonResult found = photon_map(s, waves.surface);
            const double ratio = found.error / relative_rmse(found.map.irradiance, truth.irradiance);
            EXPECT_GT(ratio, 0.9) << map;
            EXPECT_LT(ratio, 1.1) << map;
        }
    EXPECT_TRUE(std::isnan(photon_map(waves.settings(Start::surface, 8), waves.surface).error));
}

TEST(PhotonWaves, EndAtTheTolerance) {
    const Waves waves;
    PhotonSettings s = waves.settings(Start::surface, 128);
    s.options.passes = 1000;
    s.options.tolerance = 0.05;
    const PhotonResult found = photon_map(s, waves.surface);
    EXPECT_LE(found.error, 0.05);
    EXPECT_LT(relative_rmse(found.map.irradiance, waves.truth(s).irradiance), 0.055);
    // One pass is .268 off, so that it takes about (.268 / .05)^2.
    EXPECT_NEAR(found.passes, 29, 4);
}

TEST(PhotonWaves, OpenWaterIsTheSceneWithNothingInIt) {
    const Waves waves;
    PhotonSettings s = waves.settings(Start::surface, 96);
    s.floor.optics.absorption_per_m = 0.3;
    const FloorMap open = photon_map(s, waves.surface).map;
    s.floor.objects = objects({{.name = "buried", .shape = Sphere{0.01}, .centre_m = {0.5, 0.5, -9}}});
    const FloorMap scene = photon_map(s, waves.surface).map;
    // The same photons, but for the few that land within rounding of a pixel's edge.
    EXPECT_LT(relative_difference(open.irradiance, scene.irradiance), 1e-3);
    EXPECT_NEAR(open.ledger.floor_w, scene.ledger.floor_w, 1e-7 * open.ledger.floor_w);
    EXPECT_NEAR(open.ledger.extinguished_w, scene.ledger.extinguished_w, 1e-7 * open.ledger.floor_w);
}

TEST(PhotonWaves, WithoutRefractionTheirMeanIsTheSunsAlone) {
    const Waves waves;
    for (const Start start : both_starts) {
        PhotonSettings s = waves.settings(start, 256);
        s.floor.optics.refractive_index = 1;
        const FloorMap map = photon_map(s, waves.surface).map;
        const double alone = 1000 * std::sin(70 * std::numbers::pi / 180);
        EXPECT_NEAR(mean(map.irradiance), alone, 2e-5 * alone);
        EXPECT_NEAR(map.ledger.reflected_w, 0, 1e-9);
    }
}

TEST(PhotonWaves, TiltedWaterIsLitEvenlyAndClimbsFromPeriodToPeriod) {
    const Grid grid = make_grid(16, 16, 2, 2);
    const glm::dvec2 slope{0.1, -0.05};
    const Surface surface = sample(grid, periodic, tilted(slope), slope);
    for (const Start start : both_starts) {
        PhotonSettings s = photons_over(grid, 16, 16, 60);
        s.options = {.start = start, .map = 512};
        const f64::Refraction r = f64::refract_sun(s.floor.sun.direction(), slope, 4.0 / 3, 1);
        const double entered = 1000 * r.incident * r.transmittance;
        const FloorMap map = photon_map(s, surface).map;
        EXPECT_NEAR(map.ledger.floor_w / 4, entered, 1e-5 * entered) << "what one period lets in lands in one";
        // Where light of one period alone lands it is even, and thinner: it spreads with the slope.
        const double even = entered / (1 + glm::dot(slope, r.travel));
        int within = 0;
        for (const float e : map.irradiance.values()) within += std::abs(e - even) < 0.02 * even ? 1 : 0;
        EXPECT_GT(within, 150) << "of 256 pixels";
    }
}

TEST(PhotonWaves, WaterTakesWhatTheWayIsLong) {
    const Grid grid = make_grid(8, 8, 2, 2);
    const Surface surface(grid, periodic);
    for (const Start start : both_starts) {
        PhotonSettings s = photons_over(grid, 8, 8, 40);
        s.options = {.start = start, .map = 64};
        s.floor.depth_m = 3;
        s.floor.optics.absorption_per_m = 0.2;
        s.floor.optics.scattering_per_m = 0.1;
        const f64::Refraction r = f64::refract_sun(s.floor.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const double entered = 4000 * r.incident * r.transmittance, left = std::exp(-0.3 * 3 * r.path);
        const FloorLedger ledger = photon_map(s, surface).map.ledger;
        EXPECT_NEAR(ledger.floor_w, entered * left, 1e-9 * entered);
        EXPECT_NEAR(ledger.extinguished_w, entered * (1 - left), 1e-9 * entered);
        EXPECT_NEAR(ledger.reflected_w, 4000 * r.incident - entered, 1e-9 * entered);
    }
}

/// A swelling that is level with still water at the sides of the unit square, so that no step lies there.
SurfacePoint swelling(glm::dvec2 at) {
    const double pi = std::numbers::pi, a = 0.02;
    const glm::dvec2 s{std::sin(pi * at.x), std::sin(pi * at.y)}, c{std::cos(pi * at.x), std::cos(pi * at.y)};
    return {a * s.x * s.x * s.y * s.y, 2 * pi * a * s.x * s.y * glm::dvec2{c.x * s.y, s.x * c.y}, 0};
}

TEST(PhotonWaves, WallsStopThemAndStillWaterLetsThemIn) {
    const Grid grid = make_grid(256, 256, 1, 1);
    for (const Side side : {Side::wall, Side::absorbing}) {
        const Surface surface = sample(grid, {side, side}, swelling);
        PhotonSettings s = photons_over(grid, 32, 32, 55);
        s.options.map = 512;
        const TruthMap truth = truth_map({.floor = s.floor, .tolerance = 2e-4}, interpolate(surface));
        for (const Start start : both_starts) {
            s.options.start = start;
            const FloorMap map = photon_map(s, surface).map;
            EXPECT_LT(map.ledger.closure(), 1e-12);
            EXPECT_LT(relative_rmse(map.irradiance, truth.irradiance), 0.025) << int(side) << int(start);
            EXPECT_NEAR(map.ledger.floor_w, truth.ledger.floor_w, 3e-4 * truth.ledger.floor_w);
            EXPECT_EQ(map.ledger.entered_w == 0, side == Side::wall);
            if (side == Side::wall) {
                EXPECT_NEAR(map.ledger.outside_w, truth.ledger.outside_w, 1e-3 * truth.ledger.outside_w);
            }
        }
    }
}

TEST(PhotonWaves, NoLightComesInThroughAWallBelowTheWater) {
    // Water that stands 5 cm high at walls all round, under a low sun: what would come in beneath its surface does not.
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = sample(grid, {Side::wall, Side::wall}, [](glm::dvec2) { return SurfacePoint{0.05}; });
    for (const Start start : both_starts) {
        PhotonSettings s = photons_over(grid, 8, 8, 30);
        s.options = {.start = start, .map = 256};
        EXPECT_NEAR(photon_map(s, surface).map.ledger.incident_w, 500, 0.1) << int(start);
    }
}

TEST(PhotonWaves, AMapOfTwoPeriodsShowsThemTwice) {
    const Waves waves;
    PhotonSettings s = waves.settings(Start::surface, 128);
    const FloorMap once = photon_map(s, waves.surface).map;
    s.floor.plan = {128, 64, {-0.25, 0}, {1.0 / 64, 1.0 / 64}, 0};
    const FloorMap twice = photon_map(s, waves.surface).map;
    EXPECT_LT(twice.ledger.closure(), 1e-12);
    EXPECT_NEAR(twice.ledger.entered_w, once.ledger.floor_w, 1e-9 * once.ledger.floor_w);
    for (int i = 0; i < 128; ++i) EXPECT_EQ(twice.irradiance(i, 7), once.irradiance((i + 48) % 64, 7)) << i;
}

TEST(PhotonWaves, WavesThatShadeEachOtherAreMetInOrder) {
    const Grid grid = make_grid(256, 4, 1, 1.0 / 64);
    const Surface surface = sample(grid, periodic, sines({{.02, .5, 0}}));
    PhotonSettings s = photons_over(grid, 64, 1, 8);
    s.floor.sun.azimuth_deg = 0;
    s.options.map = 256;
    const double falls = 1000 * std::sin(8 * std::numbers::pi / 180) / 64;
    EXPECT_NEAR(photon_map(s, surface).map.ledger.incident_w, falls, 1e-9) << "no light falls twice";
    s.options.start = Start::surface;
    EXPECT_GT(photon_map(s, surface).map.ledger.incident_w, 1.05 * falls) << "slopes alone know no shade";
}

TEST(PhotonWaves, OnGroundThatIsNotFlatTheyAreAsExactTrianglesAre) {
    const Waves waves;
    Field<float> bed(256, 256);
    for (int j = 0; j < 256; ++j)
        for (int i = 0; i < 256; ++i)
            bed(i, j) = static_cast<float>(-0.8 + 0.15 * std::cos(2 * std::numbers::pi * waves.grid.x_m(i)) *
                                                      std::sin(2 * std::numbers::pi * waves.grid.y_m(j)));
    for (const bool per_ground_area : {true, false}) {
        ReliefSettings relief{.floor = {}, .bed_m = bed.clone(), .per_ground_area = per_ground_area};
        relief.floor.plan = cover(waves.grid, 256, 256);
        relief.floor.sun = {70, 25, 1000};
        FloorMap expected;
        make_relief_floor(std::move(relief))->compute(waves.surface, expected);
        for (const Start start : both_starts) {
            PhotonSettings s = waves.settings(start, 512);
            s.bed_m = std::make_shared<const Field<float>>(bed.clone());
            s.per_ground_area = per_ground_area;
            const FloorMap map = photon_map(s, waves.surface).map;
            double difference = 0, square = 0, bias = 0;
            for (int j = 0; j < 64; ++j)
                for (int i = 0; i < 64; ++i) {
                    double sum = 0;
                    for (int b = 0; b < 4; ++b)
                        for (int a = 0; a < 4; ++a) sum += expected.irradiance(4 * i + a, 4 * j + b) / 16;
                    difference += (map.irradiance(i, j) - sum) * (map.irradiance(i, j) - sum);
                    bias += map.irradiance(i, j) - sum;
                    square += sum * sum;
                }
            EXPECT_LT(std::sqrt(difference / square), 0.045) << "noise of photons";
            EXPECT_LT(std::abs(bias) / std::sqrt(64 * 64 * square), 1e-3) << per_ground_area;
            EXPECT_NEAR(map.ledger.floor_w, expected.ledger.floor_w, 1e-3 * expected.ledger.floor_w);
            EXPECT_LT(map.ledger.closure(), 1e-12);
        }
    }
}

TEST(PhotonWaves, OnASlopeThatEndsAtOpenSidesTheyComeInAboveTheGroundOnly) {
    const Grid grid = make_grid(64, 64, 2, 2);
    const Surface surface(grid, {Side::absorbing, Side::wall});
    Field<float> bed(64, 64);
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i) bed(i, j) = static_cast<float>(-1 + 0.3 * grid.x_m(i));
    for (const double azimuth : {0.0, 180.0}) {
        ReliefSettings relief{.floor = {}, .bed_m = bed.clone()};
        relief.floor.plan = cover(grid, 64, 64);
        relief.floor.sun = {40, azimuth, 1000};
        PhotonSettings s;
        s.floor = relief.floor;
        s.bed_m = std::make_shared<const Field<float>>(bed.clone());
        FloorMap expected;
        make_relief_floor(std::move(relief))->compute(surface, expected);
        for (const Start start : both_starts) {
            s.options = {.start = start, .map = 512};
            const FloorMap map = photon_map(s, surface).map;
            EXPECT_NEAR(map.ledger.floor_w, expected.ledger.floor_w, 2e-3 * expected.ledger.floor_w);
            EXPECT_LT(relative_difference(map.irradiance, expected.irradiance), 0.06) << azimuth << int(start);
            EXPECT_LT(map.ledger.closure(), 1e-12);
        }
    }
}

TEST(PhotonWaves, DryGroundIsLitByTheSunAlone) {
    const Grid grid = make_grid(32, 32, 2, 2);
    const Surface surface(grid, {Side::wall, Side::wall});
    auto bed = std::make_shared<Field<float>>(32, 32);
    bed->fill(0.3F);
    for (const Start start : both_starts) {
        PhotonSettings s = photons_over(grid, 4, 4, 90);
        s.bed_m = bed;
        s.options = {.start = start, .map = 64};
        const FloorMap map = photon_map(s, surface).map;
        EXPECT_NEAR(map.ledger.floor_w, 4000, 1e-6);
        EXPECT_NEAR(map.ledger.reflected_w, 0, 1e-9);
    }
}

}  // namespace
}  // namespace waterlight
