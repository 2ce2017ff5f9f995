// The floor map by landed quads converges to the truth, beside the two-pass map with its two footprints.
#include <gtest/gtest.h>

#include "caustics/kernels/optics.hpp"
#include "caustics/quads.hpp"
#include "tests/support/floor_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

FloorMap quads_of(const FloorSettings& settings, const Surface& surface) {
    FloorMap map;
    make_floor_quads(settings)->compute(surface, map);
    return map;
}

/// Percent.
struct Errors {
    double quads, adaptive, pixel;
};

Errors errors_of(const FloorScene& scene, int per_wave) {
    const SolvedFloor solved = solve(scene, per_wave);
    const FloorMap map = quads_of(solved.settings, solved.surface);
    const FloorLedger& l = map.ledger;
    EXPECT_LT(l.closure(), 1e-6);
    EXPECT_EQ(l.lost_w, 0);
    EXPECT_NEAR(l.floor_w, l.incident_w - l.reflected_w, 1e-6 * l.incident_w) << "what leaves a period comes in";
    const double error = relative_rmse(map.irradiance, solved.truth.irradiance);
    EXPECT_LT(solved.truth.error_estimate, 0.3 * error);
    Errors errors{100 * error, 0, 0};
    for (const Footprint footprint : {Footprint::adaptive, Footprint::pixel}) {
        FloorSettings s = solved.settings;
        s.footprint = footprint;
        FloorMap two_pass;
        make_floor_cpu(s)->compute(solved.surface, two_pass);
        (footprint == Footprint::adaptive ? errors.adaptive : errors.pixel) =
            100 * relative_rmse(two_pass.irradiance, solved.truth.irradiance);
    }
    return errors;
}

struct SceneCase {
    const char* name;
    FloorScene scene;
    double order;      ///< at least, from 32 to 128 pixels a wave
    double at_finest;  ///< percent, at most
};

TEST(Quads, ConvergeToTheTruthInEveryScene) {
    FloorScene deep = crate(8);
    deep.truth_tolerance = 1e-3;
    for (const SceneCase& c : {SceneCase{"crate_1", crate(1), 1.3, 0.05},
                               {"crate_3", crate(3), 1.2, 0.25},
                               {"crate_8", deep, 1.5, 3.5},
                               {"crossed_1", crossed(1), 1.4, 0.03},
                               {"crossed_3", crossed(3), 1.4, 0.15},
                               {"skew", skew(0), 1.0, 1.5}}) {
        double coarse = 0, fine = 0;
        for (const int per_wave : {32, 64, 128}) {
            const Errors e = errors_of(c.scene, per_wave);
            const std::string key = std::string(c.name) + "_" + std::to_string(per_wave);
            RecordProperty(key + "_quads", std::to_string(e.quads));
            RecordProperty(key + "_adaptive", std::to_string(e.adaptive));
            RecordProperty(key + "_pixel", std::to_string(e.pixel));
            EXPECT_LT(e.quads, e.pixel) << key;
            if (per_wave == 32) coarse = e.quads;
            fine = e.quads;
        }
        EXPECT_GT(std::log2(coarse / fine) / 2, c.order) << c.name;
        EXPECT_LT(fine, c.at_finest) << c.name;
    }
}

TEST(Quads, MoreSamplesAPixelAreMoreExact) {
    const SolvedFloor solved = solve(crossed(3), 32);
    const Grid grid =
        make_grid(4 * solved.settings.plan.width, 4 * solved.settings.plan.height, .5 * root_two, .5 * root_two);
    const Surface fine = sample(grid, periodic, crossed(3).waves);
    double last = 1;
    for (const int samples : {1, 2, 4}) {
        FloorSettings s = solved.settings;
        s.samples_per_pixel = samples;
        const double error = relative_rmse(quads_of(s, fine).irradiance, solved.truth.irradiance);
        EXPECT_LT(error, 0.5 * last) << samples;
        last = error;
    }
}

TEST(Quads, WithoutRefractionItIsTheSunsAloneEverywhere) {
    const Grid grid = make_grid(64, 48, 1, .75);
    FloorSettings s;
    s.plan = cover(grid, 70, 45);
    s.sun = {35, 25, 1};
    s.optics = {1, false, 0, 0};
    const Surface surface = sample(grid, periodic, sines({{.01, .5, 0}, {.005, .25, 90}}));
    const FloorMap map = quads_of(s, surface);
    for (const float e : map.irradiance.values()) EXPECT_NEAR(e, std::sin(35 * std::numbers::pi / 180), 2e-5);
}

TEST(Quads, TiltedWaterIsUniformAsTheClosedFormSays) {
    const Grid grid = make_grid(32, 32, 2, 2);
    const glm::dvec2 slope{0.1, -0.05};
    FloorSettings s;
    s.sun = {60, 25, 1};
    const f64::Refraction r = f64::refract_sun(s.sun.direction(), slope, 4.0 / 3, 1);
    const double expected = r.incident * r.transmittance / (1 + glm::dot(slope, r.travel));
    for (const double angle : {0.0, 33.0}) {
        s.plan = cover(grid, 40, 32);
        s.plan.angle_deg = angle;
        const FloorMap map = quads_of(s, sample(grid, periodic, tilted(slope), slope));
        for (const float e : map.irradiance.values()) EXPECT_NEAR(e, expected, 2e-5 * expected) << angle;
    }
}

TEST(Quads, FlatWaterBetweenWallsIsLitUpToTheExactEdge) {
    const Grid grid = make_grid(32, 32, 4, 4);
    FloorSettings s;
    s.plan = cover(grid, 32, 32);
    s.sun = {30, 0, 1};
    const f64::Refraction r = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
    const double even = r.incident * r.transmittance;
    const FloorMap map = quads_of(s, sample(grid, {Side::wall, Side::wall}, flat));
    const double edge = 32 + r.travel.x * 8;  // pixels: where light lands that enters at the wall towards the sun
    for (int i = 0; i < 32; ++i) EXPECT_NEAR(map.irradiance(i, 5), even * std::clamp(edge - i, 0.0, 1.0), 2e-6) << i;
    EXPECT_NEAR(map.ledger.incident_w, 8, 1e-5);
    EXPECT_NEAR(map.ledger.outside_w, even * -r.travel.x * 4, 1e-4);
    EXPECT_LT(map.ledger.closure(), 1e-6);
}

}  // namespace
}  // namespace waterlight
