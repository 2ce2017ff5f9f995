// The shadows of other shapes, of many, under waves, on ground and at sides: by area, and against rays followed one by
// one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "caustics/beam_point.hpp"
#include "caustics/beam_refine.hpp"
#include "caustics/objects/repeated_objects.hpp"
#include "sim/bathymetry.hpp"
#include "tests/support/shadow_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

using std::numbers::pi;

TEST(ShadowBeams, AFloatingBallShadesAndStopsWhatFallsOnIt) {
    ShadowPool pool;
    pool.beams.objects = objects_of({ball(radius, {1.7, 1.4, -.1})});
    const ShadowFields f(pool);
    const double waterline = pi * (radius * radius - .01), rest = disc - waterline;
    EXPECT_NEAR(f.beams.ledger.objects_w / (waterline + rest * pool.light().transmittance), 1, 2e-3);
    EXPECT_NEAR(f.dark_m2(0, pool.entering()) / disc, 1, 2e-3);
    EXPECT_LT(f.beams.ledger.closure(), 1e-12);
}

/// Error of the shadow of some objects on the floor under an overhead sun, as a part of its area.
double error_of_shadow(std::vector<Object> objects, double area_m2) {
    ShadowPool pool;
    pool.beams.objects = objects_of(std::move(objects));
    const ShadowFields f(pool, {16, 12, 10});
    EXPECT_LT(f.beams.ledger.closure(), 1e-12);
    return f.dark_m2(0, pool.entering()) / area_m2 - 1;
}

TEST(ShadowBeams, EveryShapeHasItsShadow) {
    const glm::dvec3 at{1.73, 1.41, -1};
    EXPECT_NEAR(error_of_shadow({{.shape = Box{{.5, .3, .4}}, .centre_m = at, .rotation_deg = {0, 0, 37}}}, .15), 0,
                2e-3);
    EXPECT_NEAR(error_of_shadow({{.shape = Ring{.4, .5, .2}, .centre_m = at}}, pi * .09), 0, 2e-3);
    EXPECT_NEAR(error_of_shadow({{.shape = Cup{.2, .3, .6}, .centre_m = at}}, pi * .09), 0, 2e-3);
    // Plates on edge, thinner than a beam by five.
    EXPECT_NEAR(error_of_shadow({{.shape = Box{{.8, .02, .4}}, .centre_m = at, .rotation_deg = {0, 0, 31}}}, .016), 0,
                5e-3);
    // A cube on its corner: a hexagon of sqrt(3) of its face.
    EXPECT_NEAR(error_of_shadow({{.shape = Box{{.4, .4, .4}},
                                  .centre_m = at,
                                  .rotation_deg = {45, std::atan(std::sqrt(.5)) * 180 / pi, 0}}},
                                .16 * std::numbers::sqrt3),
                0, 2e-3);
}

TEST(ShadowBeams, ABallSmallerThanABeamIsNotMissed) {
    for (const double r : {.05, .01})
        EXPECT_NEAR(error_of_shadow({ball(r, {1.73, 1.41, -1})}, pi * r * r), 0, 3e-3) << r;
}

TEST(ShadowBeams, ShadowsThatOverlapCountOnce) {
    // Two discs a radius apart share (2 pi / 3 - sqrt(3) / 2) R^2; one is above the water.
    const double both = 2 * disc - (2 * pi / 3 - std::numbers::sqrt3 / 2) * radius * radius;
    EXPECT_NEAR(error_of_shadow({ball(radius, {1.7, 1.4, -.9}), ball(radius, {2, 1.4, -1.5})}, both), 0, 2e-3);
    EXPECT_NEAR(error_of_shadow({ball(radius, {1.7, 1.4, .9}), ball(radius, {2, 1.4, -1.5})}, both), 0, 2e-3);
    EXPECT_NEAR(error_of_shadow({ball(radius, {1.7, 1.4, .9}), ball(.2, {1.7, 1.4, -1.5})}, disc), 0, 2e-3);
}

TEST(ShadowBeams, AShadowThatLeavesOneSideComesInAtTheOther) {
    ShadowPool pool;
    pool.beams.sun = {40, 30, 1};
    constexpr int east = 25, north = 19;  // cells by which it moves, of 1/16 m
    for (const double height : {-.9, .8}) {
        pool.beams.objects = objects_of({ball(radius, {2, 1.5, height})});
        const ShadowFields middle(pool);
        pool.beams.objects = objects_of({ball(radius, {2 - east / 16.0, 1.5 - north / 16.0, height})});
        const ShadowFields moved(pool);
        double error = 0, dark = 0;
        for (int k = 0; k < 40; ++k)
            for (int j = 0; j < 48; ++j)
                for (int i = 0; i < 64; ++i) {
                    const int from = (j + north) % 48 * 64 + (i + east) % 64;
                    const float a = moved.volume.plane(k)[static_cast<std::size_t>(j * 64 + i)];
                    const float b = middle.volume.plane(k)[static_cast<std::size_t>(from)];
                    error += std::abs(a - b);
                    dark += pool.entering() - b;
                }
        EXPECT_LT(error / dark, 2e-3);
        EXPECT_GT(dark, 100);
    }
}

TEST(RepeatedObjects, AreMetInTheOrderOfTheRay) {
    const Grid grid = make_grid(8, 6, 4, 3);
    const RepeatedObjects objects(objects_of({ball(.3, {1, 1, -1})}), 0, grid, {Side::periodic, Side::absorbing});
    for (const double towards : {1.0, -1.0}) {
        Ray ray{.from_m = {11.2, 1, -1}, .direction = {towards, 0, 0}, .farthest_m = 30};
        const auto hit = objects.first_hit(ray);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->distance_m, towards > 0 ? 13 - .3 - 11.2 : 11.2 - 9.3, 1e-12) << "the balls at 13 and at 9";
        ray.from_m.y = 4;
        EXPECT_FALSE(objects.first_hit(ray)) << "not along y";
    }
}

/// Power that a ball takes under waves: of rays from a fine mesh of the surface as its formula says, one by one.
double taken(const ShadowPool& pool, glm::dvec3 centre, int rays) {
    const glm::dvec3 s = pool.beams.sun.direction();
    const auto meets = [&](glm::dvec3 from, glm::dvec3 way) {
        // The light may come from a period beside.
        for (int p = -1; p <= 1; ++p)
            for (int q = -1; q <= 1; ++q) {
                const glm::dvec3 off = centre + glm::dvec3{4 * p, 3 * q, 0} - from;
                const double along = glm::dot(off, glm::normalize(way));
                if (along > 0 && glm::dot(off, off) - along * along < radius * radius) return true;
            }
        return false;
    };
    double sum = 0;
    for (int j = 0; j < 3 * rays; ++j)
        for (int i = 0; i < 4 * rays; ++i) {
            const glm::dvec2 at{(i + .5) / rays, (j + .5) / rays};
            const SurfacePoint p = pool.waves(at);
            const f64::Refraction r = f64::refract_sun(s, p.slope, 4.0 / 3, 1);
            const glm::dvec3 from{at, p.elevation_m};
            if (meets(from, -s))
                sum += r.incident;
            else if (meets(from, {r.travel, -1}))
                sum += r.incident * r.transmittance;
        }
    return sum / (rays * rays);
}

TEST(ShadowBeams, UnderWavesTheLedgerTakesWhatRaysBring) {
    ShadowPool pool;
    pool.waves = sines({{.008, 1, 0}, {.006, .5, 90}});
    pool.beams.sun = {60, 30, 1};
    pool.beams.grid = {160, 120};
    for (const glm::dvec3 centre : {in_water, in_air, glm::dvec3{.1, 1.4, -1.2}}) {
        pool.beams.objects = objects_of({ball(radius, centre)});
        const ShadowFields f(pool, {40, 30, 20});
        const double expected = taken(pool, centre, 400);
        RecordProperty("error_percent", std::to_string(100 * (f.beams.ledger.objects_w / expected - 1)));
        EXPECT_NEAR(f.beams.ledger.objects_w / expected, 1, 5e-3);
        EXPECT_LT(f.beams.ledger.closure(), 1e-12);
        for (int k = 0; k < 20; ++k) {
            const SliceLedger& l = f.volume.ledger[k];
            const double shaded = centre.z > 0 ? f.bare_volume.ledger[0].flux_w - f.volume.ledger[0].flux_w : 0;
            EXPECT_NEAR((l.flux_w + l.objects_w + shaded) / f.bare_volume.ledger[k].flux_w, 1, 1e-4);
            EXPECT_NEAR(l.inside_w, l.flux_w, 1e-9);
        }
        EXPECT_NEAR(f.volume.ledger[0].flux_w / f.beams.ledger.floor_w, 1, 1e-4) << "what lands, passes the last slice";
    }
}

/// Power that a ball below takes of the rays of each beam as they are between its corners.
double taken_of_beams(const Beams& beams, glm::dvec3 centre, int parts) {
    double sum = 0;
    for (int j = 0; j < beams.ny; ++j)
        for (int b = 0; b < 2 * beams.nx; ++b) {
            const std::array<glm::ivec2, 3> at = corners_of(b, j);
            std::array<glm::dvec2, 3> still, travel;
            for (int k = 0; k < 3; ++k) {
                const int i = at[k].x, row = at[k].y;
                travel[k] = {beams.travel_x(i, row), beams.travel_y(i, row)};
                still[k] = glm::dvec2{beams.x(i, row), beams.y(i, row)} + double{beams.z(i, row)} * travel[k];
            }
            int met = 0, all = 0;
            for (int q = 0; q < parts; ++q)
                for (int p = 0; p + q < parts; ++p, ++all) {
                    const double u = (p + 1.0 / 3) / parts, v = (q + 1.0 / 3) / parts;
                    const glm::dvec3 way{travel[0] + u * (travel[1] - travel[0]) + v * (travel[2] - travel[0]), -1};
                    glm::dvec3 off{still[0] + u * (still[1] - still[0]) + v * (still[2] - still[0]), 0};
                    off -= centre;
                    off -= glm::dvec3{4 * std::round((off.x - centre.z * way.x) / 4),
                                      3 * std::round((off.y - centre.z * way.y) / 3), 0};
                    const double along = glm::dot(off, glm::normalize(way));
                    met += glm::dot(off, off) - along * along < radius * radius ? 1 : 0;
                }
            sum += double{beams.flux(b, j)} * met / all;
        }
    return sum;
}

TEST(ShadowBeams, WideBeamsAreStoppedWhereTheirOwnRaysAre) {
    ShadowPool pool;
    pool.waves = sines({{.12, 4, 0}, {.1, 3, 90}});
    pool.beams.grid = {5, 4};
    for (const double along : {0.0, .8, 1.6, 2.4, 3.2}) {
        const glm::dvec3 centre{.3 + along, 1.1 + .4 * along, -1.6};
        pool.beams.objects = objects_of({ball(radius, centre)});
        const Beams beams = pool.made();
        EXPECT_NEAR(beams.ledger.objects_w / taken_of_beams(pool.bare(), centre, 300), 1, 4e-3) << along;
    }
}

TEST(ShadowBeams, ReflectedBeamsAreStoppedAboveTheWater) {
    ShadowPool pool;
    pool.reflected = true;
    pool.beams.sun = {45, 30, 1};
    pool.beams.objects = objects_of({ball(radius, in_air)});
    const ShadowFields f(pool);
    const double up = std::sin(pi / 4), reflected = up * (1 - pool.light().transmittance), shadow = disc / up;
    for (int k = 0; k < 40; ++k) {
        const double height = -f.volume.z_m(k);
        if (std::abs(height - in_air.z) < radius) continue;
        // Its own shadow on the water, and above it that of what comes back.
        EXPECT_NEAR(f.dark_m2(k, reflected) / shadow, height > in_air.z ? 2 : 1, 4e-3) << height;
    }
    EXPECT_LT(f.beams.ledger.closure(), 1e-12);
}

TEST(ShadowBeams, RefinedGridsShareThePieces) {
    ShadowPool pool;
    pool.waves = sines({{.008, 1, 0}, {.006, .5, 90}});
    pool.beams.objects = objects_of({ball(radius, in_water)});
    RefinedBeams refined;
    make_refined_beams(pool.beams, .8, pool.surface(), refined);
    const auto flux = [](const Beams& b) {
        double sum = 0;
        for (const float w : b.flux.values()) sum += w;
        for (const float w : b.pieces->beams.flux.values()) sum += w;
        return sum;
    };
    const Beams whole = pool.made();
    EXPECT_GT(refined.refined_cells, 100);
    EXPECT_LT(refined.refined_cells, 1000);
    EXPECT_NEAR((flux(refined.coarse) + flux(refined.fine)) / flux(whole), 1, 1e-3);
}

TEST(ShadowBeams, TheGroundStopsWhatObjectsLeave) {
    ShadowPool pool;
    pool.beams.sun = {50, 30, 1};
    pool.beams.optics.absorption_per_m = .2;
    Field<float> height(128, 96);
    height.fill(-1.5F);
    pool.beams.ground = std::make_shared<BeamGround>(pool.surface().grid, pool.boundary, std::move(height));
    pool.beams.objects = objects_of({ball(radius, in_water), ball(radius, {1, 1, -1.9})});
    const ShadowFields f(pool);
    EXPECT_LT(f.beams.ledger.closure(), 1e-12);
    // The second is buried but for its cap: within its shadow the ground would have been as dark.
    EXPECT_NEAR(f.dark_m2(12, pool.entering() * std::exp(.2 * f.volume.z_m(12) * pool.light().path)) /
                    (disc * pool.light().path),
                1, 2e-3)
        << f.volume.z_m(12);
    EXPECT_EQ(f.volume.ledger[3].flux_w, 0) << "in the ground";
}

TEST(ShadowBeams, AWallEndsTheLightBeforeWhatIsBehindIt) {
    ShadowPool pool;
    pool.boundary = {Side::wall, Side::wall};
    pool.beams.sun = {40, 180, 1};  // light runs towards +x
    pool.beams.objects = objects_of({ball(radius, {4.5, 1.4, -.9})});
    const Beams beams = pool.made();
    EXPECT_EQ(beams.pieces, nullptr);
    EXPECT_EQ(beams.ledger.objects_w, 0);
}

TEST(ShadowBeams, ObjectsOutOfTheWayChangeNoBit) {
    ShadowPool pool;
    pool.waves = egg_crate(.01, .5);
    pool.beams.sun = {50, 30, 1};
    pool.beams.objects = objects_of({ball(radius, {1.7, 1.4, -2.5})});  // under the floor
    const ShadowFields f(pool);
    EXPECT_EQ(f.beams.pieces, nullptr);
    EXPECT_TRUE(std::ranges::equal(f.beams.flux.values(), f.bare.flux.values()));
    EXPECT_TRUE(std::ranges::equal(f.volume.plane_irradiance.values(), f.bare_volume.plane_irradiance.values()));
    EXPECT_EQ(f.beams.ledger.floor_w, f.bare.ledger.floor_w);
}

TEST(ShadowBeams, FollowTheObjectOnItsPath) {
    ShadowPool pool;
    Object moving = ball(radius, {0, 0, 0});
    moving.path = {{0, {1, 1, -1}}, {2, {3, 2, -1}}};
    pool.beams.objects = objects_of({moving});
    Surface surface = pool.surface();
    surface.time_s = 1;
    Beams beams;
    make_beams(pool.beams, surface, beams);
    EXPECT_EQ(irradiance_at(beams, {2, 1.5, -1.8}).plane_w_m2, 0);
    EXPECT_GT(irradiance_at(beams, {1, 1, -1.8}).plane_w_m2, .9);
    surface.time_s = 0;
    make_beams(pool.beams, surface, beams);
    EXPECT_EQ(irradiance_at(beams, {1, 1, -1.8}).plane_w_m2, 0);
    EXPECT_GT(irradiance_at(beams, {2, 1.5, -1.8}).plane_w_m2, .9);
}

}  // namespace
}  // namespace waterlight
