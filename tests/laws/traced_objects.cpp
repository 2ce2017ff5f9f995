// Mirrors and diffuse things, shadows on them, and what a traced picture refuses.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>

#include "caustics/floor.hpp"
#include "caustics/kernels/optics.hpp"
#include "sim/error.hpp"
#include "tests/support/traced_scenes.hpp"

namespace waterlight {
namespace {

using std::numbers::pi;

/// Level mirrors send the sky's radiance of the mirrored direction, times their reflectance.
TEST(TracedObjects, MirrorShowsTheSkyInIt) {
    const Surface surface = calm_surface(Side::wall);
    TracedScene scene = dry_scene(surface);
    scene.scene.sun = {40, 0, 1000};
    Look look;
    const glm::dvec3 eye{4, 1, 2}, to{4, 3, 0.5};
    const TracedPicture up = trace_picture(
        scene, look, camera_at({4, 3, 3}, glm::dvec3(4, 3, 3) + (to - eye) * glm::dvec3(1, 1, -1), {1, 1}),
        {.samples = 1});
    scene.objects = set_of({object_of(Box{{2, 2, 1}}, mirror_of(0.8), {4, 3, 0})});
    const TracedPicture in_mirror = trace_picture(scene, look, camera_at(eye, to, {1, 1}), {.samples = 1});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(in_mirror.radiance.rgb[c] / up.radiance.rgb[c], 0.8, 1e-4);
}

/// The mirror shows the sun's disc whole: integrated over the picture it brings E0 times the reflectance.
TEST(TracedObjects, MirrorShowsTheSunWithAllItsLight) {
    const Surface surface = calm_surface(Side::wall);
    TracedScene scene = dry_scene(surface);
    scene.scene.sun = {90, 0, 1000};
    Look look = plain_look(0);
    look.sky.irradiance_w_m2 = 0.0;
    scene.objects = set_of({object_of(Box{{2, 2, 1}}, mirror_of(0.8), {4, 3, 0})});
    for (const double fov : {2.0, 60.0}) {  // the disc of many pixels, and of a part of one
        const int n = fov < 10 ? 64 : 12;
        Camera camera = camera_at({4, 3, 3}, {4, 3, 0.5}, {n, n});
        camera.fov_deg = fov;
        camera.position_m.x += 1e-3;
        const TracedPicture seen = trace_picture(scene, look, camera, {.samples = 16});
        const double pixel = 2 * std::tan(fov * pi / 360) / n;
        double sum = 0;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const double off = std::hypot(i - 0.5 * (n - 1), j - 0.5 * (n - 1)) * pixel;
                sum += radiance_at(seen.radiance, i, j).x * pixel * pixel * std::pow(1 + off * off, -1.5);
            }
        EXPECT_NEAR(sum / 800, 1, 0.02) << fov;
    }
}

/// Lambert: E0 cos times the reflectance over pi, in the sun; nothing in a shadow.
TEST(TracedObjects, DiffuseFollowsLambertAndLiesInShadow) {
    const Surface surface = calm_surface(Side::wall);
    TracedScene scene = dry_scene(surface);
    Look look = plain_look(0.5);
    look.sky.irradiance_w_m2 = 0.0;
    look.exposure_w_m2_sr = 100;
    const Camera camera = camera_at({4, 3, 4}, {4, 3, 0.5}, {1, 1});
    for (const double elevation : {90.0, 60.0, 20.0}) {
        scene.scene.sun = {elevation, 0, 1000};
        const Object table = object_of(Box{{1, 1, 1}}, diffuse_of(0.6), {4, 3, 0.5});
        scene.objects = set_of({table});
        const double lit = 0.6 * 1000 * std::sin(elevation * pi / 180) / pi;
        EXPECT_NEAR(trace_picture(scene, look, camera, {.samples = 1}).radiance.rgb[0], lit, 1e-3 * lit);
        const double e = elevation * pi / 180;
        const glm::dvec3 towards{std::cos(e), 0, std::sin(e)};
        if (elevation == 90) continue;
        scene.objects = set_of({table, object_of(Sphere{0.2}, mirror_of(1), glm::dvec3(4, 3, 1) + 1.5 * towards)});
        EXPECT_NEAR(trace_picture(scene, look, camera, {.samples = 1}).radiance.rgb[0], 0, 1e-3 * lit);
        // A pane of glass across the way lets 4 % and 4 % less through.
        scene.objects = set_of({table, object_of(Box{{12, 12, 0.01}}, glass_of(1.5), {4, 3, 2})});
        const Camera below = camera_at({4, 2.4, 1.5}, {4, 3, 1}, {1, 1});
        const double through = trace_picture(scene, look, below, {.samples = 1}).radiance.rgb[0] / lit;
        const double t = std::asin(std::cos(e) / 1.5), i = pi / 2 - e;
        const double s = std::pow(std::sin(i - t) / std::sin(i + t), 2),
                     p = std::pow(std::tan(i - t) / std::tan(i + t), 2);
        EXPECT_NEAR(through, std::pow(1 - 0.5 * (s + p), 2), 2e-3) << elevation;
        scene.objects = set_of({table, object_of(Box{{12, 12, 0.01}}, glass_of(1.5, 20), {4, 3, 2})});
        const double tinted = trace_picture(scene, look, below, {.samples = 1}).radiance.rgb[0] / lit;
        EXPECT_NEAR(tinted / through, std::exp(-20 * 0.01 / std::sin(e)), 1e-3) << elevation;
    }
}

/// I cos / r^2 within the cone of a spot, nothing beyond.
TEST(TracedObjects, LampFollowsTheInverseSquare) {
    const Surface surface = calm_surface(Side::wall);
    TracedScene scene = dry_scene(surface);
    scene.scene.sun.irradiance_w_m2 = 0;
    Look look = plain_look(0.5);
    look.sky.irradiance_w_m2 = 0.0;
    scene.objects = set_of({object_of(Box{{1, 1, 1}}, diffuse_of(0.6), {4, 3, 0.5})});
    const Camera camera = camera_at({4, 3, 4}, {4, 3, 0.5}, {1, 1});
    for (const double half : {30.0, 5.0}) {
        scene.lamp = Lamp{Lamp::Type::spot, {5, 3, 3}, 200, {5, 3, 0}, half};
        const double expected = half > 26.6 ? 0.6 / pi * 200 / 5 * 2 / std::sqrt(5.0) : 0;
        EXPECT_NEAR(trace_picture(scene, look, camera, {.samples = 1}).radiance.rgb[0], expected,
                    1e-3 * expected + 1e-9);
    }
}

/// Under still water a level thing has the refracted sun, less what the water took on its way, and on that of sight.
TEST(TracedObjects, DiffuseInTheWaterHasTheSunOfItsDepth) {
    const Surface surface = calm_surface(Side::absorbing);
    TracedScene scene;
    scene.scene.surface = &surface;
    scene.scene.depth_m = 5;
    scene.scene.optics.absorption_per_m = 0.2;
    Look look = plain_look(0);
    look.sky.irradiance_w_m2 = 0.0;
    const glm::dvec3 eye{4, 3, -0.1}, on{4.1, 3.1, -1};
    for (const double elevation : {90.0, 50.0, 25.0}) {
        scene.scene.sun = {elevation, 30, 1000};
        const f64::Refraction r = f64::refract_sun(scene.scene.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const double down = 1000 * r.incident * r.transmittance * std::exp(-0.2 * r.path);
        const double expected = 0.6 / pi * down * std::exp(-0.2 * glm::length(on - eye));
        scene.objects = set_of({object_of(Box{{2, 2, 1}}, diffuse_of(0.6), {4, 3, -1.5})});
        const auto seen = [&] {
            return trace_picture(scene, look, camera_at(eye, on, {1, 1}), {.samples = 1}).radiance.rgb[0];
        };
        EXPECT_NEAR(seen() / expected, 1, 1e-4) << elevation;
        // What hangs in the air where the sun enters keeps it off.
        const glm::dvec3 enters = on + glm::dvec3(-r.travel, 1.0), towards = -scene.scene.sun.direction();
        scene.objects = set_of({scene.objects->objects()[0], object_of(Sphere{0.2}, diffuse_of(0), enters + towards)});
        EXPECT_EQ(seen(), 0) << elevation;
    }
}

/// Waves focus light on a level thing as they do on a floor at its depth.
TEST(TracedObjects, WavesFocusLightOnThings) {
    Surface surface(make_grid(256, 192, 8, 6), {Side::periodic, Side::periodic});
    const double k = 2 * pi / 0.8;
    for (int j = 0; j < 192; ++j)
        for (int i = 0; i < 256; ++i) {
            const double x = surface.grid.x_m(i);
            surface.elevation(i, j) = static_cast<float>(0.012 * std::cos(k * x));
            surface.slope_x(i, j) = static_cast<float>(-0.012 * k * std::sin(k * x));
        }
    TracedScene scene;
    scene.scene.surface = &surface;
    scene.scene.depth_m = 1.5;
    scene.scene.sun = {55, 90, 1000};
    Look look = plain_look(0);
    look.sky.irradiance_w_m2 = 0.0;
    scene.objects = set_of({object_of(Box{{2, 2, 0.4}}, diffuse_of(0.6), {4, 3, -1.2})});
    FloorSettings floor;
    floor.plan = cover(surface.grid, 256, 192);
    floor.depth_m = 1;
    floor.sun = scene.scene.sun;
    FloorMap map;
    make_floor_cpu(floor)->compute(surface, map);
    double least = 1e9, most = 0, squares = 0, sum = 0;
    for (int i = 110; i < 146; i += 3) {
        const glm::dvec2 at = floor.plan.position_m({i + 0.5, 96.5});
        const Camera camera = camera_at({at, -0.5}, {at, -1}, {1, 1});
        const double expected = 0.6 / pi * map.irradiance(i, 96);
        const double off = trace_picture(scene, look, camera, {.samples = 1}).radiance.rgb[0] - expected;
        least = std::min(least, expected);
        most = std::max(most, expected);
        squares += off * off;
        sum += expected * expected;
    }
    EXPECT_GT(most, 1.3 * least);
    EXPECT_LT(std::sqrt(squares / sum), 0.01);
}

/// Periodic sides repeat water and things: from one period further the picture is the same.
TEST(TracedObjects, PeriodsLookAlike) {
    const Surface surface = wavy_surface(Side::periodic);
    TracedScene scene;
    scene.scene.surface = &surface;
    scene.scene.depth_m = 2;
    scene.objects = set_of({object_of(Sphere{0.5}, mirror_of(0.9), {3, 3, 0.2})});
    const glm::dvec3 from{2, 0, 2}, to{3, 3, 0}, period{-8, 12, 0};
    const TracedPicture here = trace_picture(scene, {}, camera_at(from, to, {48, 36}), {.samples = 1});
    const TracedPicture there =
        trace_picture(scene, {}, camera_at(from + period, to + period, {48, 36}), {.samples = 1});
    std::vector<double> off;
    for (std::size_t k = 0; k < here.radiance.rgb.size(); ++k)
        off.push_back(std::abs(there.radiance.rgb[k] / here.radiance.rgb[k] - 1));
    std::ranges::sort(off);
    EXPECT_LT(off[off.size() * 98 / 100], 0.01);  // at edges rounding decides
    scene.objects = nullptr;
    const TracedPicture bare = trace_picture(scene, {}, camera_at(from, to, {48, 36}), {.samples = 1});
    EXPECT_NE(bare.radiance.rgb, here.radiance.rgb);
}

TEST(TracedObjects, SameBytesWhateverTheThreads) {
    const Surface surface = wavy_surface(Side::periodic);
    TracedScene scene;
    scene.scene.surface = &surface;
    scene.objects =
        set_of({object_of(Sphere{0.5}, glass_of(1.5), {3, 3, 0}), object_of(Cup{}, diffuse_of(0.5), {5, 3, -0.9})});
    const Camera camera = camera_at({4, -1, 2}, {4, 3, 0}, {60, 41});
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    const TracedPicture one = trace_picture(scene, {}, camera, {.samples = 4});
    omp_set_num_threads(4);
    int calls = 0;
    double last = 0;
    const TracedPicture four = trace_picture(scene, {}, camera, {.samples = 4, .progress = [&](double part) {
                                                                     ++calls;
                                                                     last = std::max(last, part);
                                                                 }});
    omp_set_num_threads(threads);
    EXPECT_EQ(one.radiance.rgb, four.radiance.rgb);
    EXPECT_EQ(calls, 41);
    EXPECT_EQ(last, 1);
}

TEST(TracedObjects, RefusesWhatIsOutOfRange) {
    const Surface surface = calm_surface(Side::wall);
    TracedScene scene;
    scene.scene.surface = &surface;
    const Camera camera = camera_at({4, -1, 2}, {4, 3, 0}, {4, 3});
    EXPECT_THROW(trace_picture(scene, {}, camera, {.samples = 0}), InputError);
    EXPECT_THROW(trace_picture(scene, {}, camera, {.bounces = 0}), InputError);
    EXPECT_THROW(trace_picture(scene, {}, camera, {.least_share = 1}), InputError);
    Look overlay;
    overlay.overlay = Overlay::elevation;
    EXPECT_THROW(trace_picture(scene, overlay, camera, {}), InputError);
    Camera wrong = camera;
    wrong.fov_deg = 180;
    EXPECT_THROW(trace_picture(scene, {}, wrong, {}), InputError);
}

}  // namespace
}  // namespace waterlight
