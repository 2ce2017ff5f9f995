// Beams that end on the ground: planes, a cliff and a bowl in closed form, and a flat ground that changes nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "caustics/beam_point.hpp"
#include "caustics/beam_volume.hpp"
#include "caustics/kernels/optics.hpp"
#include "sim/bathymetry.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

std::shared_ptr<const BeamGround> ground_of(const Grid& grid, Boundary boundary, double depth_m, Ground shape) {
    const Field<double> exact = ground_heights({.depth_m = depth_m, .file = std::nullopt, .shapes = {{shape}}}, grid);
    Field<float> height(grid.nx, grid.ny);
    std::ranges::copy(exact.values(), height.data());
    return std::make_shared<BeamGround>(grid, boundary, std::move(height));
}

struct Lit {
    Beams beams;
    BeamVolume volume;
    Lit(const BeamSettings& s, const Surface& surface, glm::ivec3 cells) {
        make_beams(s, surface, beams);
        fill_volume(beams, cells, volume);
    }
};

void expect_same(const Field<float>& a, const Field<float>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE(std::ranges::equal(a.values(), b.values()));
}

TEST(BeamGround, FlatGroundIsTheFloorToTheLastBit) {
    const Grid grid = make_grid(64, 48, 2, 1.5);
    const Surface surface = sample(grid, periodic, egg_crate(.01, .5));
    BeamSettings s;
    s.grid = {40, 37};
    s.depth_m = 1.1;
    s.sun = {40, 25, 1};
    s.optics.absorption_per_m = .2;
    const Lit floor(s, surface, {16, 12, 9});
    s.ground = ground_of(grid, periodic, 1.1, PlaneGround{{0, 0}, {0, 0}, -1.1});
    const Lit ground(s, surface, {16, 12, 9});
    expect_same(floor.beams.end_z, ground.beams.end_z);
    expect_same(floor.beams.flux, ground.beams.flux);
    expect_same(floor.volume.plane_irradiance, ground.volume.plane_irradiance);
    expect_same(floor.volume.scalar_irradiance, ground.volume.scalar_irradiance);
    EXPECT_EQ(floor.beams.ledger.floor_w, ground.beams.ledger.floor_w);
    EXPECT_EQ(floor.beams.ledger.extinguished_w, ground.beams.ledger.extinguished_w);
    EXPECT_EQ(floor.beams.depth_m, ground.beams.depth_m);
    const glm::dvec3 place{.4, .3, -.9};
    EXPECT_EQ(irradiance_at(floor.beams, place).plane_w_m2, irradiance_at(ground.beams, place).plane_w_m2);
}

/// Still water over ground that rises by 0.2 along x from 1.5 m, 4 m long and 1 m wide; c = 0.3.
struct Slope {
    Grid grid = make_grid(64, 16, 4, 1);
    BeamSettings settings;
    f64::Refraction light;
    Slope(double azimuth_deg, Side side) {
        settings.grid = {80, 20};
        settings.depth_m = 1.5;
        settings.sun = {50, azimuth_deg, 1};
        settings.optics.absorption_per_m = .3;
        settings.ground = ground_of(grid, {side, Side::periodic}, 1.5, PlaneGround{{0, 0}, {.2, 0}, -1.5});
        light = f64::refract_sun(settings.sun.direction(), {0, 0}, 4.0 / 3, 1);
    }
    Surface surface(Side side) const { return sample(grid, {side, Side::periodic}, flat); }
};

TEST(BeamGround, EndsLieOnASlopeToRounding) {
    const Slope slope(30, Side::absorbing);
    Beams b;
    make_beams(slope.settings, slope.surface(Side::absorbing), b);
    int seen = 0;
    for (std::size_t i = 0; i < b.x.size(); ++i) {
        // z = -1.5 + 0.2 (x + D t_x) = -D, between the outermost cell centres.
        const double descent = (1.5 - .2 * b.x.data()[i]) / (1 + .2 * slope.light.travel.x);
        const double landed = b.x.data()[i] + descent * slope.light.travel.x;
        if (landed < .04 || landed > 3.96) continue;
        EXPECT_NEAR(b.end_z.data()[i], -descent, 5e-7);
        ++seen;
    }
    EXPECT_GT(seen, 1000);
    EXPECT_LT(b.ledger.closure(), 1e-12);
}

TEST(BeamGround, ASlopeTakesTheTransmittedPowerLessItsAbsorption) {
    // The sun across the slope, so that no light leaves along it: over each x the way is path (1.5 - 0.2 x).
    const Slope slope(90, Side::wall);
    const Lit lit(slope.settings, slope.surface(Side::wall), {40, 1, 30});
    const double entered = slope.light.incident * slope.light.transmittance, c = .3 * slope.light.path;
    const double landed = entered * (std::exp(-.7 * c) - std::exp(-1.5 * c)) / (.2 * c);
    RecordProperty("landed_error_percent", std::to_string(100 * (lit.beams.ledger.floor_w / landed - 1)));
    EXPECT_NEAR(lit.beams.ledger.floor_w / landed, 1, 1e-4);
    EXPECT_NEAR(lit.beams.ledger.extinguished_w / (4 * entered - landed), 1, 1e-4);
    for (int k = 0; k < 30; ++k) {
        const double z = lit.volume.z_m(k), reach = std::min(4.0, (1.5 + z) / .2);
        const double expected = entered * std::exp(c * z);
        EXPECT_NEAR(lit.volume.ledger[k].flux_w / (expected * reach), 1, 1e-3) << "only where there is water: " << z;
        for (int i = 0; i < 40; ++i) {
            const double low = .1 * i, high = low + .1, e = lit.volume.plane(k)[i];
            if (high < reach - .01) {
                EXPECT_NEAR(e / expected, 1, 1e-3) << i << " " << k;
            }
            if (low > reach + .01) {
                EXPECT_EQ(e, 0) << "in the ground";
            }
            EXPECT_EQ(lit.volume.above_ground(i, k), .5 * (low + high) < reach) << i << " " << k;
        }
    }
}

TEST(BeamGround, ACliffCastsAShadowWhereSlantingLightMeetsIt) {
    // Light runs towards -x over a plateau at -0.2 m that ends at x = 3 above a floor at -2 m.
    const Grid grid = make_grid(600, 4, 6, .04);
    const Boundary open{Side::absorbing, Side::periodic};
    BeamSettings s;
    s.grid = {1200, 4};
    s.depth_m = 2;
    s.sun = {45, 0, 1};
    s.ground = ground_of(grid, open, 2, StepGround{{3, 0}, 0, 1.8});
    const Lit lit(s, sample(grid, open, flat), {600, 1, 20});
    const f64::Refraction light = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
    const double entered = light.incident * light.transmittance;
    for (int k = 0; k < 20; ++k) {
        const double z = lit.volume.z_m(k), edge = 3 + (-.2 - z) * light.travel.x;
        if (z > -.2) continue;
        for (int i = 0; i < 600; ++i) {
            const double x = .01 * (i + .5), e = lit.volume.plane(k)[i];
            if (x < edge - .04) {
                EXPECT_NEAR(e / entered, 1, 1e-4) << "lit: " << x << " " << z;
            }
            if (x > edge + .04) {
                EXPECT_EQ(e, 0) << "in shadow or in the ground: " << x << " " << z;
            }
        }
    }
    const double edge = 3 + 1.7 * light.travel.x;  // at z = -1.9
    EXPECT_NEAR(irradiance_at(lit.beams, {edge - .05, .02, -1.9}).plane_w_m2 / entered, 1, 1e-4);
    EXPECT_EQ(irradiance_at(lit.beams, {edge + .05, .02, -1.9}).plane_w_m2, 0);
    EXPECT_EQ(irradiance_at(lit.beams, {4, .02, -.5}).plane_w_m2, 0) << "inside the cliff";
}

/// Errors of the ledger over a bowl of radius 1 and depth 1 under an overhead sun.
struct BowlErrors {
    double dry, floor;
    /// The surface on dry ground is at the ground, as of the model shallow-water, or at the level of the water.
    BowlErrors(int n, bool at_ground) {
        const Grid grid = make_grid(2 * n, 2 * n, 3, 3);
        BeamSettings s;
        s.grid = {n, n};
        s.sun = {90, 0, 1};
        s.optics.absorption_per_m = .4;
        s.ground = ground_of(grid, {Side::wall, Side::wall}, 1, BowlGround{{1.5, 1.5}, 1, 1});
        Beams b;
        const Formula surface = [&](glm::dvec2 at) {
            return SurfacePoint{at_ground ? std::max(0.0, s.ground->height_m(at)) : 0, {0, 0}, 0};
        };
        make_beams(s, sample(grid, {Side::wall, Side::wall}, surface), b);
        const double transmittance = f64::refract_sun({0, 0, -1}, {0, 0}, 4.0 / 3, 1).transmittance;
        const double disc = std::numbers::pi, landed = transmittance * disc * (1 - std::exp(-.4)) / .4;
        dry = std::abs(b.ledger.dry_w / (9 - disc) - 1);
        floor = std::abs(b.ledger.floor_w / landed - 1);
    }
};

TEST(BeamGround, ABowlTakesWhatItsDepthsLeaveAndDryGroundTheRest) {
    const BowlErrors coarse(40, false), fine(160, false);
    RecordProperty("floor_error_percent_40", std::to_string(100 * coarse.floor));
    RecordProperty("floor_error_percent_160", std::to_string(100 * fine.floor));
    EXPECT_LT(fine.dry, 1e-3);
    EXPECT_LT(fine.floor, 1e-3);
    EXPECT_LT(fine.dry, .1 * coarse.dry) << "second order: the shore cuts beams where it is";
    EXPECT_LT(fine.floor, .1 * coarse.floor);
    const BowlErrors coarse_cells(40, true), fine_cells(160, true);
    // First order: the shore is where a cell of the surface is dry, so that a rim as wide as it and a beam counts as
    // wet.
    const double rim_m = 3.0 / 320 + 3.0 / 160, disc_m2 = std::numbers::pi, rim_m2 = 2 * disc_m2 * rim_m;
    RecordProperty("floor_error_percent_cells_40", std::to_string(100 * coarse_cells.floor));
    RecordProperty("floor_error_percent_cells_160", std::to_string(100 * fine_cells.floor));
    EXPECT_LT(fine_cells.dry, rim_m2 / (9 - disc_m2));
    EXPECT_LT(fine_cells.floor, rim_m2 * .4 / (disc_m2 * (1 - std::exp(-.4))));
    EXPECT_LT(fine_cells.dry, .35 * coarse_cells.dry);
    EXPECT_LT(fine_cells.floor, .35 * coarse_cells.floor);
}

TEST(BeamPoint, OnAnEdgeOfBeamsIsInOneOfThem) {
    const Slope slope(90, Side::wall);
    Beams beams;
    make_beams(slope.settings, slope.surface(Side::wall), beams);
    for (const double x : {.0, .5, .55, 4.0})  // edges of cells, and walls
        for (const double y : {.0, .05, .5, 1.0})
            EXPECT_EQ(irradiance_at(beams, {x, y, -.4}).beams, 1) << x << " " << y;
}

TEST(BeamGround, RaysMeetTheGroundOnceAndNotBefore) {
    const Grid grid = make_grid(80, 80, 4, 4);
    const auto ground = ground_of(grid, periodic, 1, BumpGround{{2, 2}, {.5, .5}, 0, .8});
    for (const glm::dvec2 travel : {glm::dvec2{0, 0}, {.9, .3}, {-.4, .7}}) {
        for (double x = .05; x < 4; x += .13) {
            const glm::dvec3 from{x, 1.9, .02};
            const double end = ground->end_z(from, travel);
            const auto at = [&](double z) { return glm::dvec2(from) + (from.z - z) * travel; };
            EXPECT_NEAR(ground->height_m(at(end)), end, 1e-7);
            for (double z = from.z; z > end + .01; z -= .01) EXPECT_GT(z, ground->height_m(at(z)) - 1e-3);
        }
    }
    EXPECT_NEAR(ground->end_z({2.025, 2.025, -.25}, {.3, 0}), -.2, .01) << "from in the ground";
}

}  // namespace
}  // namespace waterlight
