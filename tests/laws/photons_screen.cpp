// Photons in the camera's pixels against the irradiance on what it sees.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "caustics/kernels/optics.hpp"
#include "caustics/photons/screen_buffer.hpp"
#include "tests/support/photon_maps.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

/// Still water that is not to be seen, with one diffuse ball of radius .3 m above the floor at z = -1.
struct Scene {
    Grid grid = make_grid(4, 4, 4, 4);
    Surface surface{grid, open_sides};
    std::shared_ptr<const ObjectSet> ball = objects({{.name = "ball", .shape = Sphere{0.3}, .centre_m = {2, 2, -0.5}}});
    WaterOptics optics{.refractive_index = 1};
    PhotonSettings settings = photons_over(grid, 4, 4, 60);
    Scene() {
        settings.floor.optics = optics;
        settings.options.map = 1024;
    }
    WaterScene scene() const {
        return WaterScene({.depth_m = 1, .optics = optics, .objects = ball, .still_beyond_m = 20}, surface);
    }
};

TEST(ScreenPhotons, AreTheIrradianceOfWhatTheCameraSees) {
    const Scene s;
    const WaterScene scene = s.scene();
    const Camera camera{.position_m = {0.5, 1, 1.5}, .target_m = {2, 2, -0.6}, .fov_deg = 40, .size = {60, 40}};
    const Field<float> found = screen_photons(s.settings, scene, camera);
    const glm::dvec3 sun = s.settings.floor.sun.direction();
    const Camera::Rays rays = camera.rays();
    int compared = 0, on_ball = 0;
    double difference = 0, square = 0, astray = 0;
    for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 60; ++i) {
            // Pixels that show one receiver, lit or unlit all over.
            double sum = 0, least = 1e300, most = 0;
            bool ball = false, floor = false, beyond = false;
            const int parts = 5;
            for (int b = 0; b < parts; ++b)
                for (int a = 0; a < parts; ++a) {
                    const glm::dvec3 way = rays.at(i + (a + 0.5) / parts - 0.5, j + (b + 0.5) / parts - 0.5);
                    Traveller look{{camera.position_m, glm::normalize(way), 0}, false};
                    SceneHit hit = scene.first_hit(look);
                    if (hit.what == SceneHit::What::water) {
                        look.ray.nearest_m = hit.distance_m;
                        look.in_water = true;
                        hit = scene.first_hit(look);
                    }
                    const bool is_ball = hit.what == SceneHit::What::object;
                    (is_ball ? ball : floor) = true;
                    const glm::dvec3 at = look.ray.at(hit.distance_m);
                    beyond = beyond || at.x < 0 || at.x > 4 || at.y < 0 || at.y > 4;
                    const bool lit = scene.objects().clear(at, at - 10.0 * sun);
                    const double e = lit ? 1000 * std::max(0.0, -glm::dot(sun, hit.normal)) : 0;
                    sum += e / (parts * parts);
                    least = std::min(least, e);
                    most = std::max(most, e);
                }
            if (beyond || (ball && floor) || (least == 0 && most > 0)) continue;
            ++compared;
            on_ball += ball ? 1 : 0;
            difference += std::pow(found(i, j) - sum, 2);
            square += sum * sum;
            astray += most == 0 ? found(i, j) : 0;
        }
    EXPECT_LT(astray, 50) << "all that unlit pixels have, by lit corners smaller than a part";
    EXPECT_GT(compared, 1500);
    EXPECT_GT(on_ball, 60);
    EXPECT_LT(std::sqrt(difference / square), 0.03) << "noise";
}

TEST(ScreenPhotons, ShowTheFloorMapFromStraightAbove) {
    const Grid grid = make_grid(128, 128, 1, 1);
    const Surface surface = sample(grid, {}, egg_crate(0.005, 0.5));
    PhotonSettings s = photons_over(grid, 32, 32, 70);
    s.options.map = 512;
    const FloorMap map = photon_map(s, surface).map;
    const WaterScene scene({.depth_m = 1}, surface);
    // Its pixels are the map's: 1 m seen at the depth 4.
    const Camera above{.position_m = {0.5, 0.5, 3},
                       .target_m = {0.5, 0.5, 0},
                       .fov_deg = 2 * std::atan(0.125) * 180 / std::numbers::pi,
                       .size = {32, 32}};
    EXPECT_LT(relative_difference(screen_photons(s, scene, above), map.irradiance), 0.01)
        << "the same photons, but for those on a pixel's edge";
    EXPECT_LT(relative_difference(screen_photons(s, scene, mirrored(above)), map.irradiance), 0.01);
    Camera below = above;
    below.position_m = {0.5, 0.5, -2};
    const Field<float> dark = screen_photons(s, scene, below);
    for (const float e : dark.values()) EXPECT_EQ(e, 0) << "the floor from below";
}

TEST(ScreenPhotons, SeeThroughGlassAndNotThroughMirrors) {
    const Grid grid = make_grid(4, 4, 4, 4);
    const Surface surface(grid, open_sides);
    PhotonSettings s = photons_over(grid, 4, 4, 90);
    s.floor.optics.refractive_index = 1;
    s.options.map = 256;
    const Camera camera{.position_m = {0.5, 2, 2}, .target_m = {2, 2, -1}, .fov_deg = 10, .size = {8, 8}};
    for (const Material::Type type : {Material::Type::glass, Material::Type::mirror}) {
        // A pane before the camera that shades nothing it sees.
        const WaterScene scene({.depth_m = 1,
                                .optics = s.floor.optics,
                                .objects = objects({{.name = "pane",
                                                     .shape = Box{{0.01, 1, 1}},
                                                     .material = {.type = type, .reflectance = 1, .index = 1},
                                                     .centre_m = {0.75, 2, 1.5}}}),
                                .still_beyond_m = 20},
                               surface);
        const Field<float> found = screen_photons(s, scene, camera);
        double sum = 0;
        for (const float e : found.values()) sum += e / 64;
        const double expected = type == Material::Type::glass ? 1000 : 0;
        EXPECT_NEAR(sum, expected, 0.03 * expected);
    }
}

}  // namespace
}  // namespace waterlight
