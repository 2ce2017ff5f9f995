// Beams are dark behind objects, by the area that the shadow must have: fields, places and the ledger against shadows
// in closed form in still water, and against rays followed one by one under waves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "caustics/beam_point.hpp"
#include "caustics/beam_refine.hpp"
#include "sim/bathymetry.hpp"
#include "tests/support/shadow_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

using std::numbers::pi;

/// What of light at z the ball stops, by area: everything below it, a smaller circle where the sun is overhead.
double shadow_of_ball(const ShadowPool& pool, double z) {
    const double up = z - in_water.z;
    if (up >= radius) return 0;
    if (up <= -radius) return disc * pool.light().path;
    return up <= 0 ? disc : disc - pi * up * up;
}

struct Suns : testing::TestWithParam<double> {
    ShadowPool pool;
    Suns() { pool.beams.sun = {GetParam(), 30, 1}; }
};

TEST_P(Suns, EachSliceBelowABallLacksItsShadowAndNoneAboveIt) {
    pool.beams.objects = objects_of({ball(radius, in_water)});
    const bool overhead = GetParam() == 90;
    for (const glm::ivec2 grid : {glm::ivec2{4, 3}, {40, 30}, {111, 97}}) {
        pool.beams.grid = grid;
        const ShadowFields f(pool);
        double most = 0, within = 0;
        for (int k = 0; k < 40; ++k) {
            const double z = f.volume.z_m(k), dark = f.dark_m2(k, pool.entering());
            if (!overhead && std::abs(z - in_water.z) < radius) continue;
            const double error = std::abs(dark - shadow_of_ball(pool, z));
            if (z > in_water.z + radius) {
                EXPECT_LT(error, 1e-6) << z;
            }
            const bool below = z < in_water.z - radius;
            (below ? most : within) = std::max(below ? most : within, error / (disc * pool.light().path));
            const SliceLedger& l = f.volume.ledger[k];
            EXPECT_NEAR(l.inside_w, l.flux_w, 1e-9) << "periodic sides keep all";
            EXPECT_NEAR(l.flux_w + l.objects_w, f.bare_volume.ledger[k].flux_w, 1e-5) << z;
        }
        RecordProperty("error_percent_" + std::to_string(grid.x), std::to_string(100 * most));
        EXPECT_LT(most, 2e-3) << grid.x << " cells";
        RecordProperty("error_percent_within_" + std::to_string(grid.x), std::to_string(100 * within));
        EXPECT_LT(within, 1.5e-2) << "through the ball: its height is that of triangles";
        EXPECT_NEAR(f.beams.ledger.objects_w / (pool.entering() * disc * pool.light().path), 1, 2e-3);
        EXPECT_LT(f.beams.ledger.closure(), 1e-12);
    }
}

TEST_P(Suns, ABallAboveTheWaterShadesItsSurface) {
    pool.beams.objects = objects_of({ball(radius, in_air)});
    const ShadowFields f(pool);
    // Across the sun's rays the shadow is the ball's disc, whatever it is on the water.
    EXPECT_NEAR(f.beams.ledger.objects_w / disc, 1, 2e-3);
    EXPECT_LT(f.beams.ledger.closure(), 1e-12);
    const double shadow = disc / std::sin(GetParam() * pi / 180);
    for (int k = 0; k < 40; ++k) {
        EXPECT_NEAR(f.dark_m2(k, pool.entering()) / shadow, 1, 2e-3);
        EXPECT_EQ(f.volume.ledger[k].objects_w, 0) << "nothing in the water";
    }
}

TEST_P(Suns, ExtinctionTakesItsPartOfWhatGoesOn) {
    pool.beams.objects = objects_of({ball(radius, in_water)});
    pool.beams.optics.absorption_per_m = .4;
    const ShadowFields f(pool);
    for (int k = 0; k < 40; ++k) {
        const double z = f.volume.z_m(k), left = std::exp(.4 * z * pool.light().path);
        const SliceLedger& l = f.volume.ledger[k];
        EXPECT_NEAR(l.flux_w + l.objects_w, f.bare_volume.ledger[k].flux_w, 1e-5);
        if (z > in_water.z - radius) continue;
        EXPECT_NEAR(f.dark_m2(k, pool.entering() * left) / (disc * pool.light().path), 1, 2e-3);
    }
    EXPECT_LT(f.beams.ledger.closure(), 1e-12);
    // From each place of the disc to the ball's upper half: at t across the light, sqrt(R^2 - t^2) before its middle.
    const double c = .4, way = -in_water.z * pool.light().path, cr = c * radius;
    const double mean = 2 * pi * ((cr - 1) * std::exp(cr) + 1) / (c * c) * std::exp(-c * way);
    EXPECT_NEAR(f.beams.ledger.objects_w / (pool.entering() * pool.light().path * mean), 1, 2e-3);
}

TEST_P(Suns, TheCoreIsDarkAndWhatIsFarIsAsItWasToTheLastBit) {
    pool.beams.objects = objects_of({ball(radius, in_water)});
    const ShadowFields f(pool);
    // A cell of the fields, and of the beams, may reach so far into what it is not in.
    const double cell = std::hypot(4.0 / 64, 3.0 / 48), beam = std::hypot(.1, .1);
    int dark = 0, far = 0;
    for (int k = 0; k < 40; ++k) {
        const double z = f.volume.z_m(k);
        for (int j = 0; j < 48; ++j)
            for (int i = 0; i < 64; ++i) {
                const std::size_t n = static_cast<std::size_t>(j) * 64 + i;
                glm::dvec2 off = glm::dvec2{(i + .5) / 16, (j + .5) / 16} - glm::dvec2(in_water) -
                                 (in_water.z - z) * pool.light().travel;
                off -= glm::dvec2{4, 3} * glm::round(off / glm::dvec2{4, 3});
                const double away = glm::length(off);
                if (z < in_water.z - radius && away < radius - cell) {
                    EXPECT_LT(f.volume.plane(k)[n], 1e-9);
                    ++dark;
                }
                if (away > radius * pool.light().path + cell + beam) {
                    EXPECT_EQ(f.volume.plane(k)[n], f.bare_volume.plane(k)[n]);
                    EXPECT_EQ(f.volume.scalar(k)[n], f.bare_volume.scalar(k)[n]);
                    ++far;
                }
            }
    }
    EXPECT_GT(dark, 500);
    EXPECT_GT(far, 50000);
}

TEST_P(Suns, PlacesBehindTheBallAreDarkToItsEdge) {
    const Beams bare = pool.bare();
    for (const glm::dvec3 centre : {in_water, in_air}) {
        pool.beams.objects = objects_of({ball(radius, centre)});
        const Beams beams = pool.made();
        const glm::dvec3 s = pool.beams.sun.direction(), t = {pool.light().travel, -1};
        // The way from its middle to the surface and on; and the shadow's axes across it.
        const bool above = centre.z > 0;
        const glm::dvec3 surface = above ? centre - centre.z / s.z * s : centre;
        const glm::dvec3 light = above ? s : glm::normalize(t);
        const glm::dvec3 side = glm::normalize(glm::cross(light, glm::dvec3{.3, .9, .1}));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> any(0, 1);
        for (int n = 0; n < 60; ++n) {
            const double angle = 2 * pi * any(random), z = -1.25 - .7 * any(random);
            const glm::dvec3 across = std::cos(angle) * side + std::sin(angle) * glm::cross(light, side);
            for (const double part : {.3, .99, 1.01, 1.5}) {
                // A place of the shadow's edge, along the light in the air to the surface, then in the water.
                glm::dvec3 at = surface + part * radius * across;
                if (above) at -= at.z / s.z * s;
                at += (at.z - z) * t;
                at.x -= 4 * std::floor(at.x / 4);
                at.y -= 3 * std::floor(at.y / 3);
                const PointIrradiance p = irradiance_at(beams, at);
                if (part < 1)
                    EXPECT_EQ(p.plane_w_m2, 0) << part;
                else
                    EXPECT_NEAR(p.plane_w_m2 / pool.entering(), 1, 1e-3) << part;
            }
        }
        const glm::dvec3 over = glm::dvec3(in_water) + glm::dvec3{-.02, .01, .4};
        if (!above) {
            EXPECT_NEAR(irradiance_at(beams, over).plane_w_m2 / irradiance_at(bare, over).plane_w_m2, 1, 1e-4);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(ShadowBeams, Suns, testing::Values(90.0, 45.0, 20.0), elevation_of);

}  // namespace
}  // namespace waterlight
