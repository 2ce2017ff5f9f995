// A white furnace with things in it that absorb nothing: none of them can be seen.
#include <gtest/gtest.h>

#include "tests/support/traced_scenes.hpp"

namespace waterlight {
namespace {

constexpr double n2 = 16.0 / 9.0;

double worst_of(const Surface& surface, const Camera& camera, double times) {
    TracedScene scene;
    scene.scene.surface = &surface;
    scene.scene.depth_m = 2;
    scene.scene.sun.irradiance_w_m2 = 0;
    const Look look = plain_look(1);
    const double expected = times * *look.sky.irradiance_w_m2 / std::numbers::pi;
    scene.objects = set_of(
        {object_of(Sphere{0.5}, glass_of(1.5), {3, 3, -0.8}), object_of(Sphere{0.5}, mirror_of(1), {5, 3, 0}),
         object_of(Box{{0.8, 0.8, 0.8}}, glass_of(1.7), {4, 2, 0.1}), object_of(Cup{}, glass_of(1.5), {4, 4.2, -1.9}),
         object_of(Ring{}, mirror_of(1), {2, 4.5, -1}), object_of(Sphere{0.3}, diffuse_of(1), {5, 4, -1.2})});
    const TracedPicture seen = trace_picture(scene, look, camera, {.samples = 4});
    double worst = 0;
    for (const float value : seen.radiance.rgb) worst = std::max(worst, std::abs(value / expected - 1));
    return worst;
}

TEST(TracedFurnace, StaysWhiteAboveTheWater) {
    for (const Side side : {Side::wall, Side::periodic, Side::absorbing})
        for (const Surface& surface : {calm_surface(side), wavy_surface(side)})
            EXPECT_LT(worst_of(surface, camera_at({4, -1, 3}, {4, 3, 0}, {64, 48}), 1), 0.01);
}

TEST(TracedFurnace, StaysWhiteInTheWater) {
    for (const Side side : {Side::wall, Side::periodic, Side::absorbing})
        for (const Surface& surface : {calm_surface(side), wavy_surface(side)})
            EXPECT_LT(worst_of(surface, camera_at({4, 0.5, -1}, {4, 3, -0.8}, {64, 48}), n2), 0.01);
}

}  // namespace
}  // namespace waterlight
