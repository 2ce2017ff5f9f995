// Photons among objects: mirrors, shadows, and what becomes of the light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "caustics/kernels/optics.hpp"
#include "tests/support/photon_stage.hpp"
#include "tests/support/sides.hpp"

namespace waterlight {
namespace {

using namespace test;
using Branching = PhotonOptions::Branching;
using Start = PhotonOptions::Start;
using std::numbers::pi;

TEST(PhotonObjects, AMirrorRingsCaustic) {
    // Parallel light in a circle is reflected into a nephroid, its cusp at half the radius before the mirror (a
    // cardioid it is for a lamp on the circle). On the plane that the ring stands on light from the height z lands z /
    // tan(el) before the mirror: at 45 degrees a ring half as high as it is wide lights all of it.
    const double radius = 0.5;
    Stage stage(1.1, 220, 1,
                {.name = "ring",
                 .shape = Ring{radius, 0.52, 0.5},
                 .material = {.type = Material::Type::mirror, .reflectance = 0.9},
                 .centre_m = {0, 0, -0.75}});
    stage.settings.floor.sun = {45, 0, 1};
    stage.settings.options.map = 2048;
    const FloorMap map = stage.map();
    const auto on_axis = [&](int i) { return (map.irradiance(i, 109) + map.irradiance(i, 110)) / 2; };
    // Before the cusp one reflected ray is on the axis, E0 sin(el) .9 / (t / f - 1) at the distance t from the mirror,
    // over the sun's own light.
    double cusp = 0;
    int places = 0;
    for (int i = 70; i < 100; ++i, ++places) {
        const double t = stage.place(i, 110).x + radius, sun = std::sin(pi / 4);
        cusp += t / (1 + 0.9 * sun / (on_axis(i) - sun));
    }
    EXPECT_NEAR(cusp / places, radius / 2, 0.01 * radius / 2);
    // Beyond it there are three, so that the brightest pixel lies a little on that side.
    int brightest = 15;
    for (int i = 15; i < 205; ++i)
        if (on_axis(i) > on_axis(brightest)) brightest = i;
    EXPECT_NEAR(stage.place(brightest, 110).x, -radius / 2 - 1.5 * stage.pitch_m(), 2 * stage.pitch_m());
    EXPECT_LT(map.ledger.closure(), 1e-12);
    EXPECT_GT(map.ledger.objects_w, 0);
}

TEST(PhotonObjects, ADiffuseBallsShadow) {
    const double radius = 0.3;
    for (const double elevation : {90.0, 50.0})
        for (const double height : {-0.6, 0.0, 0.7}) {
            Stage stage(4, 200, 1, {.name = "ball", .shape = Sphere{radius}, .centre_m = {0.3, 0, height}});
            stage.settings.floor.sun = {elevation, 25, 1};
            stage.settings.options.map = 1024;
            const FloorMap map = stage.map();
            const double across = std::sin(elevation * pi / 180);
            double dark = 0;
            for (const float e : map.irradiance.values()) dark += (1 - e / across) * std::pow(stage.pitch_m(), 2);
            const double area = pi * radius * radius / across;
            EXPECT_NEAR(dark, area, 0.01 * area) << elevation << ' ' << height;
            EXPECT_NEAR(map.ledger.objects_w, area * across, 0.01 * area);
            EXPECT_LT(map.ledger.closure(), 1e-12);
        }
}

TEST(PhotonObjects, WhatStandsPartlyBeyondASideStopsAllThatFallsOnIt) {
    Stage stage(4, 40, 1, {.name = "ball", .shape = Sphere{0.3}, .centre_m = {-2, 0, 0.7}});
    stage.settings.options.map = 512;
    for (const Side side : {Side::wall, Side::absorbing}) {
        stage.surface.boundary = {side, side};
        const FloorLedger ledger = stage.map().ledger;
        const double area = pi * 0.09;
        EXPECT_NEAR(ledger.objects_w, area, 0.01 * area);
        EXPECT_NEAR(ledger.incident_w, 16 + area / 2, 0.01 * area)
            << "the half beyond the side comes in by the ball alone";
        EXPECT_LT(ledger.closure(), 1e-12);
    }
}

TEST(PhotonObjects, InWaterTheShadowIsThatOfTheRefractedLight) {
    const double radius = 0.3, sine = std::cos(50 * pi / 180) / (4.0 / 3);
    for (const Start start : {Start::light, Start::surface}) {
        Stage stage(4, 200, 1, {.name = "ball", .shape = Sphere{radius}, .centre_m = {0.3, 0, -0.6}});
        stage.settings.floor.optics.refractive_index = 4.0 / 3;
        stage.settings.floor.sun = {50, 25, 1};
        stage.settings.options = {.start = start, .map = 1024};
        const FloorMap map = stage.map();
        const f64::Refraction r = f64::refract_sun(stage.settings.floor.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const double clear = r.incident * r.transmittance;
        double dark = 0;
        for (const float e : map.irradiance.values()) dark += (1 - e / clear) * std::pow(stage.pitch_m(), 2);
        const double area = pi * radius * radius / std::sqrt(1 - sine * sine);
        EXPECT_NEAR(dark, area, 0.01 * area);
    }
}

/// Glass, mirror and diffuse things in waves, some of them through the surface.
PhotonSettings crowd(const Grid& grid) {
    PhotonSettings s = photons_over(grid, 24, 24, 60);
    s.floor.optics.absorption_per_m = 0.1;
    s.floor.objects = objects(
        {glass_ball(0.15, {0.3, 0.3, 0.02}),
         {.name = "cup",
          .shape = Cup{0.15, 0.2, 0.4, 0.02, 0.03},
          .material = {.type = Material::Type::glass, .absorption_per_m = 1},
          .centre_m = {0.7, 0.6, -0.9},
          .rotation_deg = {20, 0, 0}},
         {.name = "ring",
          .shape = Ring{0.1, 0.12, 0.1},
          .material = {.type = Material::Type::mirror, .reflectance = 0.8},
          .centre_m = {0.3, 0.75, -0.5}},
         {.name = "box", .shape = Box{{0.1, 0.2, 0.1}}, .centre_m = {0.75, 0.2, -0.7}, .rotation_deg = {0, 30, 10}}});
    return s;
}

Surface rippled(const Grid& grid, Boundary boundary) {
    Surface surface(grid, boundary);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const double k = 4 * pi, x = k * grid.x_m(i), y = k * grid.y_m(j);
            surface.elevation(i, j) = static_cast<float>(0.01 * std::cos(x) * std::cos(y));
            surface.slope_x(i, j) = static_cast<float>(-0.01 * k * std::sin(x) * std::cos(y));
            surface.slope_y(i, j) = static_cast<float>(-0.01 * k * std::cos(x) * std::sin(y));
        }
    return surface;
}

TEST(PhotonObjects, SplittingAndRouletteAgreeWithinTheirErrors) {
    const Grid grid = make_grid(64, 64, 1, 1);
    for (const Side side : {Side::periodic, Side::wall, Side::absorbing}) {
        const Surface surface = rippled(grid, {side, side});
        PhotonSettings s = crowd(grid);
        s.options.map = 192;
        s.options.passes = 8;
        const PhotonResult roulette = photon_map(s, surface);
        s.options.branching = Branching::split;
        s.options.seed = 2;
        const PhotonResult split = photon_map(s, surface);
        const double off = relative_difference(roulette.map.irradiance, split.map.irradiance);
        const double ratio = std::hypot(roulette.error, split.error) / off;
        EXPECT_GT(ratio, 0.8) << int(side);
        EXPECT_LT(ratio, 1.25) << int(side);
        for (const FloorLedger& l : {roulette.map.ledger, split.map.ledger}) {
            EXPECT_LT(l.closure(), 1e-12);
            EXPECT_LT(l.lost_w, 1e-3 * l.incident_w);
        }
        const FloorLedger &a = roulette.map.ledger, &b = split.map.ledger;
        EXPECT_NEAR(a.floor_w, b.floor_w, 5e-3 * b.floor_w);
        EXPECT_NEAR(a.objects_w, b.objects_w, 0.02 * b.objects_w);
        EXPECT_NEAR(a.reflected_w, b.reflected_w, 0.03 * b.reflected_w);
        EXPECT_NEAR(a.extinguished_w, b.extinguished_w, 5e-3 * b.extinguished_w);
    }
}

TEST(PhotonObjects, BothStartsAgreeAroundWhatLiesUnderWater) {
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = rippled(grid, {});
    PhotonSettings s = photons_over(grid, 24, 24, 60);
    s.floor.objects = objects({glass_ball(0.15, {0.4, 0.4, -0.3})});
    s.options = {.start = Start::surface, .map = 192, .passes = 8};
    const PhotonResult from_surface = photon_map(s, surface);
    s.options.start = Start::light;
    s.options.seed = 2;
    const PhotonResult from_light = photon_map(s, surface);
    const double off = relative_difference(from_surface.map.irradiance, from_light.map.irradiance);
    EXPECT_NEAR(std::hypot(from_surface.error, from_light.error) / off, 1, 0.2);
    EXPECT_NEAR(from_surface.map.ledger.floor_w, from_light.map.ledger.floor_w, 2e-3 * from_light.map.ledger.floor_w);
}

TEST(PhotonObjects, GoOnAcrossPeriodicSides) {
    // The same ball in the middle, on a corner, and a period away: the same light, elsewhere.
    const Grid grid = make_grid(16, 16, 1, 1);
    const Surface surface(grid, {});
    for (const Material::Type type : {Material::Type::diffuse, Material::Type::glass}) {
        std::vector<PhotonResult> found;
        for (const glm::dvec2 at : {glm::dvec2{0.5, 0.5}, {0, 0}, {-1.5, 0.5}})
            for (const double z : {-0.6, 0.5}) {
                PhotonSettings s = photons_over(grid, 32, 32, 40);
                s.options.map = 256;
                Object ball = glass_ball(0.2, {at, z});
                ball.material.type = type;
                s.floor.objects = objects({ball});
                found.push_back(photon_map(s, surface));
            }
        for (std::size_t k = 2; k < found.size(); ++k) {
            const FloorMap &middle = found[k % 2].map, &moved = found[k].map;
            EXPECT_LT(moved.ledger.closure(), 1e-12);
            EXPECT_NEAR(moved.ledger.objects_w, middle.ledger.objects_w, 0.01 * middle.ledger.objects_w);
            EXPECT_NEAR(moved.ledger.floor_w, middle.ledger.floor_w, 0.005 * middle.ledger.floor_w);
            const int by = k < 4 ? 16 : 0;
            double difference = 0, square = 0;
            for (int j = 0; j < 32; ++j)
                for (int i = 0; i < 32; ++i) {
                    const double a = middle.irradiance(i, j), b = moved.irradiance((i + by) % 32, (j + by) % 32);
                    difference += (a - b) * (a - b);
                    square += a * a;
                }
            EXPECT_LT(std::sqrt(difference / square), 0.08) << int(type) << ' ' << k << " noise";
        }
    }
}

TEST(PhotonObjects, WhatMeetsTooManyInterfacesIsLostAndCounted) {
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = rippled(grid, {});
    PhotonSettings s = crowd(grid);
    s.options.map = 64;
    double last = 1e300;
    for (const int bounces : {1, 2, 4, 8}) {
        s.options.bounces = bounces;
        const FloorLedger ledger = photon_map(s, surface).map.ledger;
        EXPECT_LT(ledger.closure(), 1e-12);
        EXPECT_LT(ledger.lost_w, 0.7 * last) << bounces;
        last = ledger.lost_w;
    }
}

}  // namespace
}  // namespace waterlight
