// The error that a map is estimated to have is the error that it has, within a factor 1.5, whatever the waves, before
// and behind the focus, under any sun.
#include <gtest/gtest.h>

#include "app/floor_estimate.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight::test {
namespace {

struct Scene {
    const char* name;
    Formula formula;
    double depth_m;
    Sun sun{90, 0, 1000};
    glm::dvec2 size_m{0.5, 0.5};
    glm::ivec2 pixels{96, 96};
    Boundary boundary{Side::periodic, Side::periodic};
    glm::dvec2 tilt{0, 0};
};

/// A tilt and waves on it.
Formula on_slope(glm::dvec2 slope, Formula waves) {
    return [slope, waves = std::move(waves)](glm::dvec2 at) {
        SurfacePoint p = waves(at);
        p.elevation_m += glm::dot(slope, at);
        p.slope += slope;
        return p;
    };
}

/// A round hump of Gaussian shape.
Formula hump(double height_m, double radius_m, glm::dvec2 centre_m) {
    return [=](glm::dvec2 at) {
        const glm::dvec2 r = at - centre_m;
        const double e = height_m * std::exp(-glm::dot(r, r) / (radius_m * radius_m));
        return SurfacePoint{e, -2.0 * e / (radius_m * radius_m) * r, 0};
    };
}

std::vector<Scene> scenes() {
    const double diagonal = 0.5 / std::numbers::sqrt2;
    const Boundary walls{Side::wall, Side::wall};
    const std::vector<Sine> sea{{0.004, 0.5, 0, 10},
                                {0.003, 0.25, 90, 70},
                                {0.002, diagonal, 45, 200},
                                {0.001, 0.125, 0, 310},
                                {0.0015, diagonal, -45, 30}};
    return {
        {"SineBeforeItsFocus", sines({{0.01, 0.5}}), 1},
        {"SineBehindItsFocus", sines({{0.01, 0.5}}), 4},
        {"EggCrateBeforeItsFocus", egg_crate(0.006, 0.5), 1},
        {"EggCrateBehindItsFocus", egg_crate(0.006, 0.5), 3},
        {"CrossedDiagonals", sines({{0.005, diagonal, 45}, {0.004, diagonal, -45}}), 3},
        {"SkewWaveUnderASlantingSun",
         sines({{0.01, 0.5 * std::cos(std::numbers::pi / 6), 30}}),
         2,
         {45, 20, 1000},
         {0.5, 0.5 * std::sqrt(3.0)},
         {96, 192}},
        {"TiltedWater",
         on_slope({0.1, -0.05}, sines({{0.005, 0.5}})),
         2,
         {60, 30, 1000},
         {0.5, 0.5},
         {96, 96},
         {Side::periodic, Side::periodic},
         {0.1, -0.05}},
        {"LowSunBetweenWalls", sines({{0.01, 0.5}}), 0.4, {30, 70, 1000}, {1, 1}, {96, 96}, walls},
        {"SumOfFiveWaves", sines(sea), 1.5, {70, 200, 1000}},
        {"HumpBetweenWalls", hump(0.02, 0.12, {0.5, 0.4}), 2, {80, 120, 1000}, {1, 1}, {96, 96}, walls},
        {"GentleWavesOverDeepWater", sines({{0.001, 0.5}, {0.0008, 0.25, 90}}), 6, {50, 0, 1000}},
    };
}

class FloorErrorEstimate : public ::testing::TestWithParam<Scene> {};

TEST_P(FloorErrorEstimate, IsTheErrorWithinAFactorOfOneAndAHalf) {
    const Scene& scene = GetParam();
    const Grid grid = make_grid(128, 128, scene.size_m.x, scene.size_m.y);
    FloorSettings settings;
    settings.plan = cover(grid, scene.pixels.x, scene.pixels.y);
    settings.depth_m = scene.depth_m;
    settings.sun = scene.sun;
    const Surface surface = sample(grid, scene.boundary, scene.formula, scene.tilt);
    FloorMap map;
    make_floor_cpu(settings)->compute(surface, map);

    const TruthSurface exact = as_truth(grid, scene.boundary, scene.formula);
    FloorEstimate estimate(settings);
    estimate.compute(exact, map.irradiance);
    const TruthMap truth = truth_map({settings, 8, 32, 2e-3}, exact);
    const double error = relative_rmse(map.irradiance, truth.irradiance);
    ASSERT_LT(truth.error_estimate, 0.2 * error) << "the truth must be better than what it judges";
    RecordProperty("estimated", std::to_string(estimate.rmse()));
    RecordProperty("true", std::to_string(error));
    EXPECT_LT(estimate.rmse(), 1.5 * error);
    EXPECT_GT(estimate.rmse(), error / 1.5);

    // Place by place too: without its estimated error the map is much better.
    Field<float> mended = map.irradiance.clone();
    for (std::size_t n = 0; n < mended.size(); ++n) mended.data()[n] -= estimate.error().data()[n];
    EXPECT_LT(relative_rmse(mended, truth.irradiance), 0.5 * error);
}

INSTANTIATE_TEST_SUITE_P(Eleven, FloorErrorEstimate, ::testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace waterlight::test
