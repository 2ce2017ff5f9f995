// The projected grid: where its corners lie, and what becomes of the light.
#include <gtest/gtest.h>

#include "caustics/beams.hpp"
#include "caustics/kernels/optics.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

Beams beams_of(const Surface& surface, glm::ivec2 grid, double elevation_deg, double azimuth_deg = 25) {
    BeamSettings s;
    s.grid = grid;
    s.sun = {elevation_deg, azimuth_deg, 1};
    Beams beams;
    make_beams(s, surface, beams);
    return beams;
}

TEST(BeamGrid, CornersLieOnTheSurfaceAndOnTheSunsRays) {
    const Grid grid = make_grid(512, 512, 2, 2);
    const Formula wave = sines({{.02, .5, 0}, {.015, 2 / std::sqrt(13.0), 33.690067525979785}});
    const Surface surface = sample(grid, periodic, wave);
    for (const double elevation : {90.0, 60.0, 30.0}) {
        const Beams b = beams_of(surface, {37, 41}, elevation);
        const glm::dvec3 s = Sun{elevation, 25, 1}.direction();
        for (int j = 0; j <= 41; ++j) {
            for (int i = 0; i <= 37; ++i) {
                const glm::dvec3 p{b.x(i, j), b.y(i, j), b.z(i, j)};
                EXPECT_NEAR(p.z, wave(glm::dvec2(p)).elevation_m, 2e-5);
                const glm::dvec2 at_rest = glm::dvec2(p) - p.z * glm::dvec2(s) / s.z;
                EXPECT_NEAR(at_rest.x, 2.0 * i / 37, 1e-6);
                EXPECT_NEAR(at_rest.y, 2.0 * j / 41, 1e-6);
            }
        }
    }
}

TEST(BeamGrid, TheGridsResolutionIsFreeOfTheSurfaces) {
    const Grid grid = make_grid(16, 16, 2, 2);
    const Surface surface = sample(grid, periodic, sines({{.01, 2, 0}}));
    for (const int n : {3, 50, 200}) {
        const Beams b = beams_of(surface, {n, n + 1}, 60);
        EXPECT_EQ(b.flux.size(), static_cast<std::size_t>(2 * n * (n + 1)));
        EXPECT_NEAR(b.ledger.incident_w, 4 * std::sin(std::numbers::pi / 3), 1e-4);
        EXPECT_LT(b.ledger.closure(), 1e-12);
    }
}

TEST(BeamGrid, ShadowedWaterIsNotLit) {
    // Steep waves under a low sun: the light that falls on the grid enters all the same, and only once.
    const Grid grid = make_grid(256, 8, 2, .0625);
    const Surface surface = sample(grid, periodic, sines({{.06, 1, 0}}));
    const Beams b = beams_of(surface, {400, 4}, 12, 180);
    EXPECT_NEAR(b.ledger.incident_w / (0.125 * std::sin(12 * std::numbers::pi / 180)), 1, 1e-3);
    EXPECT_LT(b.ledger.closure(), 1e-12);
    // Triangles across the jump from a crest to the water behind it face the sun, and carry its light.
    for (int i = 0; i < 400; ++i)
        EXPECT_GE(b.x(i, 0) + 1e-6F, i > 0 ? b.x(i - 1, 0) : -1.0F) << "first hits are in order";
}

TEST(BeamGrid, BeamsEndAtWalls) {
    const Grid grid = make_grid(64, 64, 4, 4);
    const Surface surface = sample(grid, {Side::wall, Side::wall}, sines({{.02, .5, 0}}));
    const Beams b = beams_of(surface, {50, 50}, 30, 0);
    for (const float x : b.x.values()) EXPECT_TRUE(x >= 0 && x <= 4);
    // Light enters through the surface of the pool and nowhere else: that is E0 |s . A| of its real, closed surface.
    // The tilt of its ends adds (elevation at x = 4 less that at x = 0) cos(30) per metre of wall; here they are level.
    EXPECT_NEAR(b.ledger.incident_w, 16 * 0.5, 1e-3);
    EXPECT_GT(b.ledger.outside_w, 0.5);
    EXPECT_LT(b.ledger.closure(), 1e-12);
}

TEST(BeamGrid, StillWaterBeyondAbsorbingSidesLightsTheDomain) {
    const Grid grid = make_grid(32, 32, 2, 2);
    const Surface surface = sample(grid, {Side::absorbing, Side::absorbing}, flat);
    const Beams b = beams_of(surface, {64, 64}, 30, 0);
    const f64::Refraction r = f64::refract_sun(Sun{30, 0, 1}.direction(), {0, 0}, 4.0 / 3, 1);
    EXPECT_NEAR(b.ledger.floor_w, 4 * .5 * r.transmittance, .1) << "but for the beams on the domain's edge";
    EXPECT_GT(*std::max_element(b.x.values().begin(), b.x.values().end()), 2 - r.travel.x - 1e-3);
}

TEST(BeamGrid, TrianglesAlongTheLightAreDiscardedAndReported) {
    const Grid grid = make_grid(256, 8, 2, .0625);
    const Surface surface = sample(grid, periodic, sines({{.05, 1, 0}}));
    BeamSettings s;
    s.grid = {400, 4};
    s.sun = {12, 180, 1};
    s.least_cosine = 0.2;
    Beams b;
    make_beams(s, surface, b);
    EXPECT_GT(b.ledger.discarded_w, 0.01 * b.ledger.incident_w);
    EXPECT_LT(b.ledger.closure(), 1e-12);
}

}  // namespace
}  // namespace waterlight
