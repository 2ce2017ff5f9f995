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

constexpr double pi = std::numbers::pi, radius = .3, disc = pi * radius * radius;
const glm::dvec3 in_water{1.7, 1.4, -.9}, in_air{1.7, 1.4, .8};

struct Fields {
    Beams beams, bare;
    BeamVolume volume, bare_volume;
    explicit Fields(const ShadowPool& pool, glm::ivec3 cells = {64, 48, 40}) : beams(pool.made()), bare(pool.bare()) {
        fill_volume(beams, cells, volume);
        fill_volume(bare, cells, bare_volume);
    }
    /// Area (m2) of even light that a slice lacks.
    double dark_m2(int k, double entering) const {
        return (bare_volume.ledger[k].flux_w - volume.ledger[k].flux_w) / entering;
    }
};

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
        const Fields f(pool);
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
    const Fields f(pool);
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
    const Fields f(pool);
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
    const Fields f(pool);
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

std::string elevation_of(const testing::TestParamInfo<double>& sun) {
    return "at_" + std::to_string(static_cast<int>(sun.param));
}
INSTANTIATE_TEST_SUITE_P(ShadowBeams, Suns, testing::Values(90.0, 45.0, 20.0), elevation_of);

TEST(ShadowBeams, AFloatingBallShadesAndStopsWhatFallsOnIt) {
    ShadowPool pool;
    pool.beams.objects = objects_of({ball(radius, {1.7, 1.4, -.1})});
    const Fields f(pool);
    const double waterline = pi * (radius * radius - .01), rest = disc - waterline;
    EXPECT_NEAR(f.beams.ledger.objects_w / (waterline + rest * pool.light().transmittance), 1, 2e-3);
    EXPECT_NEAR(f.dark_m2(0, pool.entering()) / disc, 1, 2e-3);
    EXPECT_LT(f.beams.ledger.closure(), 1e-12);
}

/// Error of the shadow of some objects on the floor under an overhead sun, as a part of its area.
double error_of_shadow(std::vector<Object> objects, double area_m2) {
    ShadowPool pool;
    pool.beams.objects = objects_of(std::move(objects));
    const Fields f(pool, {16, 12, 10});
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
    for (const double height : {-.9, .8}) {
        pool.beams.objects = objects_of({ball(radius, {2, 1.5, height})});
        const Fields middle(pool);
        // By whole cells of the fields and of the beams.
        pool.beams.objects = objects_of({ball(radius, {.4, .3, height})});
        const Fields corner(pool);
        const int east = 64 * 4 / 10, north = 48 * 4 / 10;  // 1.6 and 1.2 m, less a rest
        ASSERT_EQ(10 * east, 64 * 4 - 6);
        double error = 0, dark = 0;
        pool.beams.objects = objects_of({ball(radius, {2 - east / 16.0, 1.5 - north / 16.0, height})});
        const Fields moved(pool);
        for (int k = 0; k < 40; ++k) {
            EXPECT_NEAR(corner.volume.ledger[k].flux_w, middle.volume.ledger[k].flux_w, 1e-3 * disc);
            for (int j = 0; j < 48; ++j)
                for (int i = 0; i < 64; ++i) {
                    const float a = moved.volume.plane(k)[static_cast<std::size_t>(j * 64 + i)];
                    const float b =
                        middle.volume.plane(k)[static_cast<std::size_t>((j + north) % 48 * 64 + (i + east) % 64)];
                    error += std::abs(a - b);
                    dark += pool.entering() - b;
                }
        }
        EXPECT_LT(error / dark, 2e-3);
        EXPECT_GT(dark, 100);
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
        const Fields f(pool, {40, 30, 20});
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

TEST(ShadowBeams, ReflectedBeamsAreStoppedAboveTheWater) {
    ShadowPool pool;
    pool.reflected = true;
    pool.beams.sun = {45, 30, 1};
    pool.beams.objects = objects_of({ball(radius, in_air)});
    const Fields f(pool);
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
    const Fields f(pool);
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
    const Fields f(pool);
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
