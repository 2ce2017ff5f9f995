// What objects in the way of the light take from the floor map, by every method that does not follow light through
// them: the area of the shadow, darkness within, and the ledger.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>
#include <ostream>
#include <string>

#include "caustics/objects/water_scene.hpp"
#include "caustics/quads.hpp"
#include "caustics/relief.hpp"
#include "tests/support/shadow_scenes.hpp"
#include "tests/support/sides.hpp"

namespace waterlight {
namespace {

using namespace test;

using std::numbers::pi;

/// A pool of 4 x 3 m, 2 m deep.
Surface pool(const Formula& waves = flat, Boundary boundary = periodic) {
    return sample(make_grid(128, 96, 4, 3), boundary, waves);
}

FloorSettings settings_of(std::vector<Object> objects, double elevation_deg = 90, double azimuth_deg = 0) {
    FloorSettings s;
    s.plan = cover(make_grid(128, 96, 4, 3), 160, 120);
    s.depth_m = 2;
    s.sun = {elevation_deg, azimuth_deg, 1000};
    if (!objects.empty()) s.objects = objects_of(std::move(objects));
    return s;
}

struct Method {
    const char* name;
    std::unique_ptr<FloorMapper> (*make)(FloorSettings, const Grid&);
};
std::ostream& operator<<(std::ostream& out, const Method& m) { return out << m.name; }

const Method methods[] = {
    {"adaptive", [](FloorSettings s, const Grid&) { return make_floor_cpu(s); }},
    {"pixel",
     [](FloorSettings s, const Grid&) {
         s.footprint = Footprint::pixel;
         return make_floor_cpu(s);
     }},
    {"quads", [](FloorSettings s, const Grid&) { return make_floor_quads(s); }},
    {"relief",
     [](FloorSettings s, const Grid& g) {
         ReliefSettings relief{s, Field<float>(g.nx, g.ny)};
         std::ranges::fill(relief.bed_m.values(), static_cast<float>(-s.depth_m));
         return make_relief_floor(std::move(relief));
     }},
};

class FloorShadows : public testing::TestWithParam<Method> {
  protected:
    static FloorMap map_of(const FloorSettings& s, const Surface& surface) {
        FloorMap map;
        GetParam().make(s, surface.grid)->compute(surface, map);
        EXPECT_LT(map.ledger.closure(), 2e-6);
        EXPECT_LT(map.ledger.lost_w, 1e-7 * map.ledger.incident_w);
        return map;
    }
    /// The light that the floor has less with the objects than without, W.
    static double taken_w(const FloorSettings& s, const Surface& surface) {
        FloorSettings bare = s;
        bare.objects = nullptr;
        return map_of(bare, surface).ledger.floor_w - map_of(s, surface).ledger.floor_w;
    }
    static float at(const FloorMap& map, const FloorSettings& s, glm::dvec2 place_m) {
        const glm::ivec2 pixel(glm::floor(s.plan.pixel(place_m)));
        const auto wrapped = [](int i, int n) { return ((i % n) + n) % n; };
        return map.irradiance(wrapped(pixel.x, s.plan.width), wrapped(pixel.y, s.plan.height));
    }
};

INSTANTIATE_TEST_SUITE_P(All, FloorShadows, testing::ValuesIn(methods),
                         [](const testing::TestParamInfo<Method>& m) { return std::string(m.param.name); });

// Parallel light along t casts a ball's shadow on a level plane as an ellipse of area pi R^2 / |t_z|.
TEST_P(FloorShadows, ABallInTheWaterTakesTheAreaOfItsShadow) {
    constexpr double radius = 0.4;
    const glm::dvec3 centre{2.1, 1.4, -1};
    for (const double elevation : {90.0, 60.0, 35.0}) {
        const FloorSettings s = settings_of({ball(radius, centre)}, elevation, 25);
        const f64::Refraction light = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const double even = 1000 * light.incident * light.transmittance, area = pi * radius * radius * light.path;
        EXPECT_NEAR(taken_w(s, pool()) / even, area, 1e-2 * area) << elevation;
        const FloorMap map = map_of(s, pool());
        EXPECT_NEAR(map.ledger.objects_w, even * area, 1e-2 * even * area) << elevation;
        const glm::dvec2 middle = glm::dvec2(centre) + light.travel;
        for (const glm::dvec2 aside :
             {glm::dvec2{0, 0}, {.9 * radius, 0}, {0, .9 * radius}, {-.6 * radius, .6 * radius}})
            EXPECT_LT(at(map, s, middle + aside), 1e-3 * even) << elevation;
        EXPECT_NEAR(at(map, s, middle + glm::dvec2{0, 1.2 * radius}), even, 1e-3 * even);
        EXPECT_NEAR(at(map, s, middle - glm::dvec2{1.5 * radius, 0}), even, 1e-3 * even);
    }
}

// The sun's ray takes the shadow down to the surface; its area there, and on the floor below flat water, is pi R^2 /
// sin(elevation), and the light is what the ball's disc faces.
TEST_P(FloorShadows, ABallAboveTheWaterTakesWhatItsDiscFaces) {
    constexpr double radius = 0.4;
    const glm::dvec3 centre{2.1, 1.4, .8};
    for (const double elevation : {90.0, 60.0, 35.0}) {
        const FloorSettings s = settings_of({ball(radius, centre)}, elevation, 25);
        const f64::Refraction light = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const double even = 1000 * light.incident * light.transmittance;
        const double area = pi * radius * radius / std::sin(elevation * pi / 180);
        EXPECT_NEAR(taken_w(s, pool()) / even, area, 1e-2 * area) << elevation;
        const FloorMap map = map_of(s, pool());
        EXPECT_NEAR(map.ledger.objects_w, 1000 * pi * radius * radius, 10 * pi * radius * radius) << elevation;
        const glm::dvec3 sun = s.sun.direction();
        const glm::dvec2 middle = glm::dvec2(centre) + .8 * glm::dvec2(sun) / -sun.z + 2.0 * light.travel;
        EXPECT_LT(at(map, s, middle), 1e-3 * even) << elevation;
        EXPECT_LT(at(map, s, middle + glm::dvec2{0, .9 * radius}), 1e-3 * even) << elevation;
    }
}

// Light under the sun overhead goes z0 - sqrt(R^2 - r^2) to the ball: the integral of exp(-c d) over the disc.
TEST_P(FloorShadows, TurbidWaterDimsTheLightThatTheBallStops) {
    constexpr double radius = 0.5, depth = 1.2, c = 0.8;
    FloorSettings s = settings_of({ball(radius, {2, 1.5, -depth})});
    s.optics.absorption_per_m = .5;
    s.optics.scattering_per_m = .3;
    const double enters = 1000 * f64::refract_sun({0, 0, -1}, {0, 0}, 4.0 / 3, 1).transmittance;
    const double stopped =
        2 * pi * std::exp(-c * depth) * ((radius / c - 1 / (c * c)) * std::exp(c * radius) + 1 / (c * c));
    const FloorMap map = map_of(s, pool());
    EXPECT_NEAR(map.ledger.objects_w, enters * stopped, 1e-2 * enters * stopped);
    const double dark = enters * std::exp(-c * 2) * pi * radius * radius;
    EXPECT_NEAR(taken_w(s, pool()), dark, 1e-2 * dark);
}

TEST_P(FloorShadows, ABallOverAPeriodicSideTakesAsMuchAsOneInTheMiddle) {
    constexpr double radius = 0.4;
    for (const double z : {-1.0, .9}) {
        const FloorSettings middle = settings_of({ball(radius, {2, 1.5, z})}, 50, 200);
        const double expected = map_of(middle, pool()).ledger.objects_w;
        for (const glm::dvec2 place : {glm::dvec2{0, 1.5}, {4, 3}, {.1, .05}}) {
            const FloorSettings s = settings_of({ball(radius, {place, z})}, 50, 200);
            const FloorMap map = map_of(s, pool());
            EXPECT_NEAR(map.ledger.objects_w, expected, 5e-3 * expected) << place.x << " " << z;
            EXPECT_NEAR(map.ledger.floor_w, map_of(middle, pool()).ledger.floor_w, 5e-3 * expected);
        }
    }
    // Light that leaves through a side meets what stands at the other: the shadow of a ball at the side is in the map.
    const FloorSettings s = settings_of({ball(radius, {.2, .2, -1})}, 40, 45);
    const f64::Refraction light = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
    EXPECT_LT(at(map_of(s, pool()), s, glm::dvec2{.2, .2} + light.travel), 1);
}

/// What of the sun's light objects stop, W: rays on a fine lattice followed through the scene one by one.
double stopped_of_rays(const FloorSettings& s, const Surface& surface) {
    const WaterScene scene({.depth_m = s.depth_m, .optics = s.optics, .objects = s.objects}, surface);
    const glm::dvec3 sun = s.sun.direction();
    constexpr int across = 800, along = 600;
    double sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < across; ++i) {
            const glm::dvec2 still{4 * (i + .5) / across, 3 * (j + .5) / along};
            // Through this place of still water; the surface is near it.
            const glm::dvec3 up = glm::dvec3(still, 0) - 3.0 * sun / -sun.z;
            Traveller light{{up, sun}};
            double left = 1;
            SceneHit hit = scene.first_hit(light);
            if (hit.what == SceneHit::What::nothing) continue;
            if (hit.what == SceneHit::What::water) {
                const Branches ways = scene.branch(light, hit);
                left = ways.transmittance;
                light = ways.refracted;
                while ((hit = scene.first_hit(light)).what == SceneHit::What::side) light = scene.wrapped(light, hit);
            }
            if (hit.what == SceneHit::What::object) sum += left;
        }
    return sum * 1000 * -sun.z * 12 / (across * along);
}

TEST_P(FloorShadows, UnderWavesObjectsStopWhatRaysSay) {
    const Formula waves = sines({{.02, 1, 0}, {.02, 1, 90}, {.012, .5, 90}});
    Object box{.name = "box", .shape = Box{{.5, .3, .6}}, .centre_m = {2.6, .9, -1.5}, .rotation_deg = {20, 30, 40}};
    for (const double elevation : {90.0, 70.0}) {
        const FloorSettings s = settings_of({ball(.35, {1.2, 1.6, -.8}), box}, elevation, 0);
        const Surface surface = pool(waves);
        const FloorMap map = map_of(s, surface);
        const double expected = stopped_of_rays(s, surface);
        EXPECT_NEAR(map.ledger.objects_w, expected, 1e-2 * expected) << elevation;
        FloorSettings bare = s;
        bare.objects = nullptr;
        EXPECT_NEAR(map_of(bare, surface).ledger.floor_w - map.ledger.floor_w, expected, 1e-2 * expected) << elevation;
    }
}

TEST_P(FloorShadows, WhatIsNotInTheWayChangesNothing) {
    const Surface surface = pool(sines({{.02, 1, 0}, {.012, .5, 90}}), walls);
    const FloorSettings bare = settings_of({}, 60);
    const FloorMap without = map_of(bare, surface);
    for (const glm::dvec3 centre : {glm::dvec3{2, 1.5, -3}, {2, 9, -1}, {-5, 1, -1}}) {
        const FloorMap with = map_of(settings_of({ball(.5, centre)}, 60), surface);
        EXPECT_EQ(0, std::memcmp(with.irradiance.data(), without.irradiance.data(),
                                 sizeof(float) * without.irradiance.size()));
        EXPECT_EQ(with.ledger.objects_w, 0);
        EXPECT_EQ(with.ledger.outside_w, without.ledger.outside_w);
    }
    FloorSettings none = bare;
    none.objects = objects_of({});
    EXPECT_EQ(0, std::memcmp(map_of(none, surface).irradiance.data(), without.irradiance.data(),
                             sizeof(float) * without.irradiance.size()));
}

TEST_P(FloorShadows, SmallAndThinThingsTakeTheirPart) {
    // A ball of a third of a pixel, between the corners of samples, and a pole thinner than a pixel.
    const FloorSettings small = settings_of({ball(.008, {2.0125, 1.5125, -1})});
    const double enters = 1000 * f64::refract_sun({0, 0, -1}, {0, 0}, 4.0 / 3, 1).transmittance;
    EXPECT_NEAR(map_of(small, pool()).ledger.objects_w, enters * pi * 6.4e-5, .3 * enters * pi * 6.4e-5);
    Object pole{.name = "pole", .shape = Box{{.02, .02, 3}}, .centre_m = {1.003, 1.004, -.5}};
    // Above the water it takes .02 x 1 m / tan(45) of the surface, which the part below lies behind but for its own
    // shadow's end.
    const FloorSettings s = settings_of({pole}, 45, 0);
    const FloorMap map = map_of(s, pool());
    const double above = 1000 * std::sin(pi / 4) * .02;
    EXPECT_GT(map.ledger.objects_w, .9 * above);
    EXPECT_LT(map.ledger.objects_w, 2.6 * above);
}

TEST_P(FloorShadows, ABallThatMovesTakesItsShadowAlong) {
    Object moving = ball(.4, {0, 0, 0});
    moving.path = {{0, {1, 1.5, -1}}, {2, {3, 1.5, -1}}};
    const FloorSettings s = settings_of({moving});
    Surface surface = pool();
    const auto mapper = GetParam().make(s, surface.grid);
    for (const double time : {0.0, 1.0, 2.0}) {
        surface.time_s = time;
        FloorMap map;
        mapper->compute(surface, map);
        for (const double x : {1.0, 2.0, 3.0})
            EXPECT_EQ(at(map, s, {x, 1.5}) < 1, std::abs(x - 1 - time) < .1) << time << " " << x;
    }
}

TEST_P(FloorShadows, TheMapDoesNotDependOnTheNumberOfThreads) {
    const Surface surface = pool(sines({{.02, 1, 0}, {.012, .5, 90}}));
    const FloorSettings s = settings_of({ball(.3, {1, 1, -1}), ball(.2, {3.9, 2.8, .6})}, 50, 30);
    omp_set_num_threads(1);
    const FloorMap one = map_of(s, surface);
    omp_set_num_threads(3);
    const FloorMap many = map_of(s, surface);
    omp_set_num_threads(omp_get_num_procs());
    EXPECT_EQ(0, std::memcmp(one.irradiance.data(), many.irradiance.data(), sizeof(float) * one.irradiance.size()));
    EXPECT_EQ(one.ledger.objects_w, many.ledger.objects_w);
}

// Methods that can be laid otherwise than over the domain.
TEST(FloorShadowsOnMaps, TurnedMapsPartsSidesAndSamplesAllClose) {
    const Formula waves = sines({{.02, 1, 0}, {.012, .5, 90}});
    for (const Side side : {Side::periodic, Side::wall, Side::absorbing})
        for (const double angle : {0.0, 33.0})
            for (const int samples : {1, 2}) {
                FloorSettings s = settings_of({ball(.4, {2, 1.5, -1}), ball(.2, {2.4, 1.4, .5})}, 60, 40);
                s.plan = {100, 80, {1.2, .6}, {.02, .02}, angle};
                s.samples_per_pixel = samples;
                for (const Method& m : {methods[0], methods[1], methods[2]}) {
                    FloorMap map, bare;
                    m.make(s, Grid())->compute(pool(waves, {side, side}), map);
                    EXPECT_LT(map.ledger.closure(), 2e-6) << m << angle;
                    EXPECT_GT(map.ledger.objects_w, 300) << m << angle;
                    FloorSettings without = s;
                    without.objects = nullptr;
                    m.make(without, Grid())->compute(pool(waves, {side, side}), bare);
                    EXPECT_EQ(map.ledger.incident_w, bare.ledger.incident_w);
                    const double less = bare.ledger.floor_w - map.ledger.floor_w;
                    EXPECT_GT(less, .5 * map.ledger.objects_w) << m << angle;
                    // Light from beyond the domain is stopped as well, and not counted as stopped.
                    const double entered = bare.ledger.entered_w - map.ledger.entered_w;
                    EXPECT_LT(less, map.ledger.objects_w + entered) << m << angle;
                }
            }
}

// Half of a ball stands in the water before a wall, across which a turned map's coarse samples lie.
TEST(FloorShadowsOnMaps, QuadsThatAWallCutsAreShaded) {
    constexpr double radius = .5;
    FloorSettings s = settings_of({ball(radius, {0, 1.5, -1})});
    s.plan = {50, 40, {.6, -.9}, {.1, .1}, 33};
    FloorMap map;
    make_floor_quads(s)->compute(pool(flat, walls), map);
    const double enters = 1000 * f64::refract_sun({0, 0, -1}, {0, 0}, 4.0 / 3, 1).transmittance;
    const double stopped = enters * pi * radius * radius / 2;
    EXPECT_NEAR(map.ledger.objects_w, stopped, 1e-2 * stopped);
    EXPECT_LT(map.ledger.closure(), 1e-6);
    const glm::ivec2 at_wall(glm::floor(s.plan.pixel({0, 1.5})));
    EXPECT_LT(map.irradiance(at_wall.x, at_wall.y), 1);
}

TEST(FloorShadowsOnMaps, AreasConvergeWithTheSamples) {
    constexpr double radius = .3;
    // Percent of the area, of a ball of 1.5, 6 and 24 samples.
    for (const auto& [pixels, percent] : {std::pair{20, 4.0}, {80, 0.5}, {320, 0.1}}) {
        double worst = 0;
        for (int k = 0; k < 5; ++k) {
            FloorSettings s = settings_of({ball(radius, {1.7 + .0137 * k, 1.3 + .0211 * k, -1})});
            s.plan = cover(make_grid(128, 96, 4, 3), pixels, pixels * 3 / 4);
            FloorMap map;
            make_floor_quads(s)->compute(pool(), map);
            const double even = map.ledger.incident_w / 12 * (1 - map.ledger.reflected_w / map.ledger.incident_w);
            worst = std::max(worst, std::abs(map.ledger.objects_w / even / (pi * radius * radius) - 1));
        }
        RecordProperty("worst_" + std::to_string(pixels), std::to_string(worst));
        EXPECT_LT(100 * worst, percent) << pixels;
    }
}

}  // namespace
}  // namespace waterlight
