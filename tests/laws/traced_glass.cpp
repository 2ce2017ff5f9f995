// Sight through glass: by Snell's law, less what is reflected and absorbed; and none at all where the index is that of
// what is around.
#include <gtest/gtest.h>

#include "tests/support/traced_scenes.hpp"

namespace waterlight {
namespace {

using std::numbers::pi;

double most_difference(const TracedPicture& a, const TracedPicture& b) {
    double most = 0, mean = 0;
    for (const float value : b.radiance.rgb) mean += value / static_cast<double>(b.radiance.rgb.size());
    for (std::size_t k = 0; k < a.radiance.rgb.size(); ++k)
        most = std::max(most, std::abs(a.radiance.rgb[k] - static_cast<double>(b.radiance.rgb[k])) / mean);
    return most;
}

TEST(TracedGlass, OfTheIndexAroundIsInvisible) {
    const Surface surface = wavy_surface(Side::wall);
    TracedScene scene;
    scene.scene.surface = &surface;
    scene.scene.depth_m = 2;
    scene.scene.sun = {50, 20, 1000};
    Look look;
    look.colour_per_m = {0, 0, 0};  // the glass has none
    const Camera camera = camera_at({4, -2, 2}, {4, 3, -0.5}, {96, 72});
    const TracedPicture without = trace_picture(scene, look, camera, {.samples = 4});
    const double water = scene.scene.optics.refractive_index;
    scene.objects =
        set_of({object_of(Sphere{0.5}, glass_of(water), {3, 3, -0.8}), object_of(Cup{}, glass_of(water), {5, 3, -1.9}),
                object_of(Sphere{0.4}, glass_of(1), {4, 2, 0.8}), object_of(Ring{}, glass_of(1), {5, 1, 0.6})});
    EXPECT_LT(most_difference(trace_picture(scene, look, camera, {.samples = 4}), without), 2e-3);
    scene.objects = set_of({object_of(Sphere{0.4}, glass_of(1.05), {4, 2, 0.8})});
    EXPECT_GT(most_difference(trace_picture(scene, look, camera, {.samples = 4}), without), 0.02);
}

/// A dry floor whose red and green tell the place: both grow evenly along x and y, blue is the same everywhere.
struct TellingFloor {
    Surface surface = calm_surface(Side::wall);
    std::array<Field<float>, 3> colours{Field<float>(64, 48), Field<float>(64, 48), Field<float>(64, 48)};
    TracedScene scene = dry_scene(surface);
    Look look = plain_look(1);

    TellingFloor() {
        scene.scene.floor_plan = cover(surface.grid, 64, 48);
        for (int j = 0; j < 48; ++j)
            for (int i = 0; i < 64; ++i) {
                const glm::dvec2 at = scene.scene.floor_plan.position_m({i + 0.5, j + 0.5});
                colours[0](i, j) = static_cast<float>(at.x);
                colours[1](i, j) = static_cast<float>(at.y);
                colours[2](i, j) = 1;
            }
        for (std::size_t c = 0; c < 3; ++c) scene.scene.floor_rgb[c] = &colours[c];
        scene.scene.sun.irradiance_w_m2 = 0;
        look.sky.irradiance_w_m2 = 0.0;
        look.exposure_w_m2_sr = 1;
    }
    /// Red, green, blue along the middle of the picture, with no way but the first seen.
    glm::dvec3 seen(const Camera& camera, int bounces) const {
        const TracedPicture picture = trace_picture(scene, look, camera, {.samples = 1, .bounces = bounces});
        return radiance_at(picture.radiance, camera.size.x / 2, camera.size.y / 2);
    }
};

/// A plate of thickness d shifts what is seen along the floor by d (tan i - tan t) and lets T^2 exp(-a d / cos t)
/// through.
TEST(TracedGlass, PlateFollowsSnellFresnelAndBeer) {
    constexpr double n = 1.5, thick = 0.4, absorption = 0.7;
    for (const double incidence : {10.0, 35.0, 60.0, 75.0}) {
        TellingFloor floor;
        const double i = incidence * pi / 180, t = std::asin(std::sin(i) / n);
        floor.scene.objects = set_of({object_of(Box{{7, 5, thick}}, glass_of(n, absorption), {4, 3, 0.5})});
        const glm::dvec3 eye{3, 2, 1};
        const Camera camera =
            camera_at(eye, eye + glm::dvec3{std::sin(i) * 0.8, std::sin(i) * 0.6, -std::cos(i)}, {1, 1});
        const glm::dvec3 rgb = floor.seen(camera, 4);  // water of no account, two faces, and the floor
        const double way = (1.001 - thick) * std::tan(i) + thick * std::tan(t);
        EXPECT_NEAR(rgb.x / rgb.z, 3 + 0.8 * way, 2e-3) << incidence;
        EXPECT_NEAR(rgb.y / rgb.z, 2 + 0.6 * way, 2e-3) << incidence;
        const double s = std::pow(std::sin(i - t) / std::sin(i + t), 2),
                     p = std::pow(std::tan(i - t) / std::tan(i + t), 2);
        const double face = 1 - 0.5 * (s + p), left = std::exp(-absorption * thick / std::cos(t));
        // And what went to and fro within the plate once, as far as the bounces go.
        EXPECT_NEAR(rgb.z * pi, face * face * left, 0.004 * face * face * left + 2e-4) << incidence;
    }
}

/// A ball in front of a far plane turns the picture upside down: rays above its middle end below it.
TEST(TracedGlass, BallTurnsThePictureUpsideDown) {
    TellingFloor floor;
    floor.scene.objects = set_of({object_of(Sphere{0.3}, glass_of(1.5), {4, 3, 2.5})});
    Camera camera = camera_at({4, 3, 4}, {4, 3, 2.5}, {41, 41});
    camera.fov_deg = 8;
    const TracedPicture through = trace_picture(floor.scene, floor.look, camera, {.samples = 1, .bounces = 4});
    floor.scene.objects = nullptr;
    const TracedPicture direct = trace_picture(floor.scene, floor.look, camera, {.samples = 1});
    const auto x = [](const TracedPicture& p, int i) {
        const glm::dvec3 rgb = radiance_at(p.radiance, i, 20);
        return rgb.x / rgb.z - 4;
    };
    for (const int i : {5, 12, 28, 35}) {
        EXPECT_GT(std::abs(x(direct, i)), 0.01);
        EXPECT_LT(x(direct, i) * x(through, i), 0) << i;
    }
    EXPECT_NEAR(x(through, 20), 0, 1e-3);
}

}  // namespace
}  // namespace waterlight
