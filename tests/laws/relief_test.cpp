// The laws of ground that is not flat: a plane slope in closed form, power, and the flat floor's own map.
#include "caustics/relief.hpp"

#include <gtest/gtest.h>

#include "caustics/kernels/optics.hpp"
#include "caustics/truth.hpp"
#include "sim/error.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

template <class Height>
ReliefSettings settings_for(const Grid& grid, int width, int height, double elevation_deg, Height bed) {
    ReliefSettings s;
    s.floor.plan = cover(grid, width, height);
    s.floor.sun = {elevation_deg, 200, 1000};
    s.bed_m = Field<float>(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) s.bed_m(i, j) = static_cast<float>(bed(grid.x_m(i), grid.y_m(j)));
    return s;
}

FloorMap map_of(ReliefSettings settings, const Surface& surface) {
    FloorMap map;
    make_relief_floor(std::move(settings))->compute(surface, map);
    return map;
}

// On a plane z = -d + g x light that travels M a metre lands at X = x + (d - g X) M: dX/dx = 1 / (1 + g M), so that it
// is 1 + g M times as dense a horizontal metre, and cos(slope) of that a metre of ground.
TEST(Relief, AFlatWatersLightOnAPlaneSlopeHasTheClosedForm) {
    const Grid grid = make_grid(80, 60, 4, 3);
    const Surface surface = sample(grid, walls, flat);
    const f64::Refraction r = f64::refract_sun(Sun{50, 200, 1}.direction(), {0, 0}, 4.0 / 3, 1);
    for (const double g : {-.3, .2, .5}) {
        ReliefSettings s = settings_for(grid, 160, 120, 50, [g](double x, double) { return -1.5 + g * (x - 2); });
        s.per_ground_area = false;
        const double level = 1000 * r.incident * r.transmittance * (1 + g * r.travel.x);
        const FloorMap map =
            map_of(settings_for(grid, 160, 120, 50, [g](double x, double) { return -1.5 + g * (x - 2); }), surface);
        const FloorMap horizontal = map_of(std::move(s), surface);
        for (const int i : {90, 120, 150}) {
            EXPECT_NEAR(horizontal.irradiance(i, 80), level, 1e-5 * level) << g;
            EXPECT_NEAR(map.irradiance(i, 80), level / std::sqrt(1 + g * g), 1e-5 * level) << g;
        }
        EXPECT_LT(map.ledger.closure(), 1e-9);
        EXPECT_EQ(map.ledger.floor_w, horizontal.ledger.floor_w);
    }
}

// Between periodic sides and without absorption all light lands, whatever the ground: the sloped floor's total power is
// the flat one's.
TEST(Relief, TotalPowerIsThatOfTheFlatFloor) {
    const Grid grid = make_grid(96, 96, 2, 2);
    const Surface surface = sample(grid, periodic, sines({{.006, 1, 0}, {.004, .5, 90}}));
    constexpr double k = std::numbers::pi;
    const FloorMap flat_floor = map_of(settings_for(grid, 128, 128, 60, [](double, double) { return -1.5; }), surface);
    const FloorMap hills =
        map_of(settings_for(grid, 128, 128, 60,
                            [](double x, double y) { return -1.5 + .3 * std::sin(k * x) * std::cos(k * y); }),
               surface);
    EXPECT_NEAR(hills.ledger.floor_w, flat_floor.ledger.floor_w, 1e-9 * flat_floor.ledger.floor_w);
    EXPECT_LT(hills.ledger.closure(), 1e-9);
    // And its irradiance times its true area is that power.
    ReliefSettings truly = settings_for(
        grid, 128, 128, 60, [](double x, double y) { return -1.5 + .3 * std::sin(k * x) * std::cos(k * y); });
    double sum = 0;
    for (int j = 0; j < 128; ++j)
        for (int i = 0; i < 128; ++i) {
            const glm::dvec2 at = truly.floor.plan.position_m({i + .5, j + .5});
            const glm::dvec2 g =
                .3 * k * glm::dvec2{std::cos(k * at.x) * std::cos(k * at.y), -std::sin(k * at.x) * std::sin(k * at.y)};
            sum += hills.irradiance(i, j) * std::sqrt(1 + glm::dot(g, g)) * 4 / (128 * 128);
        }
    EXPECT_NEAR(sum, hills.ledger.floor_w, 1e-3 * sum);
}

TEST(Relief, OverFlatGroundItIsTheTruth) {
    const Grid grid = make_grid(256, 256, 1, 1);
    const Formula waves = egg_crate(.006, .5);
    ReliefSettings s = settings_for(grid, 128, 128, 90, [](double, double) { return -1.0; });
    TruthSettings t;
    t.floor = s.floor;
    t.floor.depth_m = 1;
    t.subsamples = 2;
    t.most_subsamples = 8;
    const TruthMap truth = truth_map(t, as_truth(grid, periodic, waves));
    const FloorMap map = map_of(std::move(s), sample(grid, periodic, waves));
    std::printf("relative RMSE over flat ground %.2g\n", relative_rmse(map.irradiance, truth.irradiance));
    EXPECT_LT(relative_rmse(map.irradiance, truth.irradiance), .005);
}

TEST(Relief, BeyondAnAbsorbingSideStillWaterLightsTheMap) {
    const Grid grid = make_grid(40, 40, 2, 2);
    const Surface surface = sample(grid, {Side::absorbing, Side::absorbing}, flat);
    const FloorMap map = map_of(settings_for(grid, 80, 80, 40, [](double, double) { return -1.0; }), surface);
    for (const float e : map.irradiance.values()) EXPECT_NEAR(e, map.irradiance(40, 40), 1e-3);
    EXPECT_LT(map.ledger.closure(), 1e-9);
    EXPECT_GT(map.ledger.entered_w, 0);
}

TEST(Relief, RefusesAPlanBesideTheDomainAndGroundOfOtherCells) {
    const Grid grid = make_grid(8, 8, 1, 1);
    const Surface surface = sample(grid, walls, flat);
    const auto deep = [](double, double) { return -1.0; };
    ReliefSettings s = settings_for(grid, 8, 8, 90, deep);
    s.floor.plan.origin_m.x = .5;
    EXPECT_THROW(map_of(std::move(s), surface), InputError);
    EXPECT_THROW(map_of(settings_for(make_grid(4, 8, 1, 1), 8, 8, 90, deep), surface), InputError);
}

}  // namespace
}  // namespace waterlight
