// Light among water, glass and mirrors: Snell's law, paths that return, media that are never mistaken.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "caustics/objects/water_scene.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using What = SceneHit::What;

std::shared_ptr<const ObjectSet> one(Object object) {
    return std::make_shared<ObjectSet>(std::vector<Object>{std::move(object)});
}

Surface wavy(Boundary boundary = {}) {
    return test::sample(make_grid(128, 96, 2, 1.5), boundary, test::egg_crate(0.01, 0.5));
}

TEST(WaterScene, LightEntersWavyWaterBySnellAndLandsWhereTheSurfaceSendsIt) {
    const Surface surface = wavy();
    const WaterScene scene({.depth_m = 1}, surface);
    const Traveller down{{{0.61, 0.47, 3}, {0, 0, -1}}};
    const SceneHit water = scene.first_hit(down);
    ASSERT_EQ(water.what, What::water);
    const SurfacePoint p = scene.surface_at({0.61, 0.47});
    EXPECT_NEAR(3 - water.distance_m, p.elevation_m, 1e-5) << "triangles against bilinear";
    const Branches ways = scene.branch(down, water);
    EXPECT_TRUE(ways.refracted.in_water);
    const double sine_in = std::sin(std::acos(water.normal.z));
    const double sine_out = glm::length(glm::cross(ways.refracted.ray.direction, water.normal));
    EXPECT_NEAR(sine_in, 4.0 / 3 * sine_out, 1e-12);
    const SceneHit floor = scene.first_hit(ways.refracted);
    ASSERT_EQ(floor.what, What::floor);
    EXPECT_NEAR(ways.refracted.ray.at(floor.distance_m).z, -1, 1e-12);
    // Backwards it takes the same way.
    Traveller back = ways.refracted;
    back.ray = {ways.refracted.ray.at(floor.distance_m), -ways.refracted.ray.direction};
    const Branches out = scene.branch(back, scene.first_hit(back));
    EXPECT_NEAR(glm::length(out.refracted.ray.direction - glm::dvec3{0, 0, 1}), 0, 1e-9);
    EXPECT_NEAR(out.transmittance, ways.transmittance, 1e-9);
}

TEST(WaterScene, LightFromBelowIsTotallyReflectedBeyondTheCriticalAngle) {
    const Surface surface(make_grid(8, 8, 10, 10), {});
    const WaterScene scene({.depth_m = 5}, surface);
    for (const double deg : {40.0, 48.0, 49.0, 70.0}) {
        const double angle = deg * std::numbers::pi / 180;
        const Traveller up{{{5, 5, -1}, {std::sin(angle), 0, std::cos(angle)}}, true};
        const Branches ways = scene.branch(up, scene.first_hit(up));
        EXPECT_EQ(ways.transmittance == 0, deg > 48.6) << deg;
        EXPECT_NEAR(ways.reflected.ray.direction.z, -std::cos(angle), 1e-12);
        EXPECT_TRUE(ways.reflected.in_water);
    }
}

TEST(WaterScene, LightGoesThroughAGlassPlateShiftedButNotTurned) {
    const Surface surface(make_grid(8, 8, 4, 4), {});
    const WaterScene scene({.depth_m = 2,
                            .objects = one({.name = "plate",
                                            .shape = Box{{3, 3, 0.2}},
                                            .material = {.type = Material::Type::glass, .index = 1.5},
                                            .centre_m = {2, 2, -1}})},
                           surface);
    const glm::dvec3 slanting = glm::normalize(glm::dvec3{0.4, 0.2, -1});
    Traveller light{{{1.5, 1.8, -0.2}, slanting}, true};
    const SceneHit in = scene.first_hit(light);
    ASSERT_EQ(in.what, What::object);
    light = scene.branch(light, in).refracted;
    EXPECT_EQ(light.inside, 0);
    const SceneHit out = scene.first_hit(light);
    light = scene.branch(light, out).refracted;
    EXPECT_EQ(light.inside, -1);
    EXPECT_TRUE(light.in_water);
    EXPECT_NEAR(glm::length(light.ray.direction - slanting), 0, 1e-12);
    EXPECT_EQ(scene.first_hit(light).what, What::floor);
}

TEST(WaterScene, ABallThatFloatsHandsLightFromAirToWater) {
    const Surface surface(make_grid(8, 8, 4, 4), {});
    const WaterScene scene({.depth_m = 2,
                            .objects = one({.name = "ball",
                                            .shape = Sphere{0.5},
                                            .material = {.type = Material::Type::glass},
                                            .centre_m = {2, 2, 0}})},
                           surface);
    Traveller light{{{2.1, 2, 3}, {0, 0, -1}}};
    light = scene.branch(light, scene.first_hit(light)).refracted;
    EXPECT_EQ(light.inside, 0);
    EXPECT_FALSE(light.in_water);
    const SceneHit out = scene.first_hit(light);
    ASSERT_EQ(out.what, What::object) << "no water within the glass";
    EXPECT_LT(light.ray.at(out.distance_m).z, -0.4);
    light = scene.branch(light, out).refracted;
    EXPECT_TRUE(light.in_water);
}

TEST(WaterScene, AMirrorSendsBackAllAndADiffuseObjectIsNoBoundary) {
    const Surface surface(make_grid(8, 8, 4, 4), {});
    const WaterScene scene({.depth_m = 2,
                            .objects = one({.name = "m",
                                            .shape = Sphere{0.5},
                                            .material = {.type = Material::Type::mirror},
                                            .centre_m = {2, 2, -1}})},
                           surface);
    const Traveller light{{{2, 2, -0.1}, {0, 0, -1}}, true};
    const Branches ways = scene.branch(light, scene.first_hit(light));
    EXPECT_EQ(ways.transmittance, 0);
    EXPECT_NEAR(ways.reflected.ray.direction.z, 1, 1e-12);
}

TEST(WaterScene, SidesAreWallsOrLeadRoundOrAreOpen) {
    const glm::dvec3 slanting = glm::normalize(glm::dvec3{1, 0, -0.1});
    const Traveller light{{{1.9, 0.7, -0.5}, slanting}, true};
    const Surface walls = wavy({Side::wall, Side::wall});
    const SceneHit wall = WaterScene({.depth_m = 1}, walls).first_hit(light);
    ASSERT_EQ(wall.what, What::side);
    EXPECT_EQ(wall.side, glm::ivec2(1, 0));
    const Surface round = wavy();
    const WaterScene scene({.depth_m = 1}, round);
    const Traveller again = scene.wrapped(light, scene.first_hit(light));
    EXPECT_EQ(again.ray.from_m.x, 0);
    EXPECT_NEAR(again.ray.from_m.z, -0.51, 1e-9);
    EXPECT_EQ(scene.first_hit(again).side, glm::ivec2(1, 0)) << "not the side it has just come in by";
    const Surface open = wavy({Side::absorbing, Side::absorbing});
    EXPECT_EQ(WaterScene({.depth_m = 1}, open).first_hit(light).what, What::floor);
}

TEST(WaterScene, StillWaterLiesBeyondAbsorbingSides) {
    const Surface open = wavy({Side::absorbing, Side::absorbing});
    const WaterScene scene({.depth_m = 1, .still_beyond_m = 1}, open);
    const SceneHit hit = scene.first_hit({{{-0.5, 0.3, 2}, {0, 0, -1}}});
    EXPECT_EQ(hit.what, What::water);
    EXPECT_NEAR(hit.distance_m, 2, 1e-6);
}

}  // namespace
}  // namespace waterlight
