// What the water has reached: against closed forms.
#include <gtest/gtest.h>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

TEST(ShallowRecords, FrontOverDryGroundArrivesWhenRitterSays) {
    RiemannProblem dam = ritter();
    dam.left_depth_m = 1;
    dam.at_m.x = 20;
    ShallowWaterSettings settings = settings_of(dam, flume(1600, 40).grid, walled);
    settings.wet_m = 0.01;
    settings.keep_records = true;
    const auto model = make_shallow_water<double>(settings);
    watch(*model, 0.01, 3, [](double) {});
    const ShallowRecords& records = *model->records();
    const double front = 2 * std::sqrt(g) - 3 * std::sqrt(g * settings.wet_m);
    for (double way = 4; way < 14; way += 1) {
        const int i = static_cast<int>((20 + way) / settings.grid.dx_m);
        EXPECT_NEAR(records.arrival_s(i, 0), (settings.grid.x_m(i) - 20) / front, 0.02 * way / front) << way;
        EXPECT_NEAR(records.max_elevation_m(i, 0), model->state(i, 0).depth_m, 1e-6) << way;
    }
    EXPECT_TRUE(std::isnan(records.arrival_s(1599, 0)));
    EXPECT_TRUE(std::isnan(records.max_elevation_m(1599, 0)));
    EXPECT_EQ(records.max_speed_m_s(1599, 0), 0);
    EXPECT_FLOAT_EQ(records.max_elevation_m(0, 0), 1);
}

// A uniform flow that a wall stops: the bore runs back over it with the depth of the Riemann problem of both mirrored.
TEST(ShallowRecords, BoreThatAWallThrowsBackHasItsHeight) {
    const RiemannProblem mirrored{1, 1, 1.5, -1.5, {0, 0}};
    const auto middle = mirrored.middle();
    for (const double datum : {0.0, 10000.0}) {
        ShallowWaterSettings settings = flume(200, 20);
        settings.bed_m = field_of(settings.grid, [&](int, int) { return datum; });
        settings.depth_m = field_of(settings.grid, [](int, int) { return 1; });
        settings.velocity_x_m_s = field_of(settings.grid, [](int, int) { return 1.5; });
        settings.sides.west = FlowSide{datum + 1, {1.5, 0}};
        settings.keep_records = true;
        const auto model = make_shallow_water<float>(settings);
        model->advance(3);
        const ShallowRecords& records = *model->records();
        for (const int i : {185, 170, 150}) {
            const double way = 20 - settings.grid.x_m(i);
            EXPECT_NEAR(records.max_elevation_m(i, 0), datum + middle.depth_m, 0.02 * middle.depth_m);
            EXPECT_NEAR(records.max_speed_m_s(i, 0), 1.5, 0.01);
            // The foot of the bore is two cells wide.
            const double foot = 2 * settings.grid.dx_m;
            EXPECT_NEAR(records.arrival_s(i, 0), (way - 0.5 * foot) / middle.right_shock_m_s,
                        0.5 * foot / middle.right_shock_m_s);
        }
    }
}

TEST(ShallowRecords, SmallWaveIsTwiceAsHighAtAWall) {
    const double a = 1e-3;
    ShallowWaterSettings settings = flume(400, 20);
    const Grid grid = settings.grid;
    settings.depth_m = field_of(grid, [&](int i, int) { return 1 + a * std::exp(-std::pow(grid.x_m(i) - 10, 2)); });
    settings.velocity_x_m_s = field_of(grid, [&](int i, int) { return std::sqrt(g) * (settings.depth_m(i, 0) - 1); });
    settings.wet_m = 0.5 * a;
    settings.keep_records = true;
    const auto model = make_shallow_water<double>(settings);
    watch(*model, 0.01, 4, [](double) {});
    EXPECT_NEAR(model->records()->max_elevation_m(399, 0), 2 * a, 0.02 * a);
    EXPECT_NEAR(model->records()->max_elevation_m(300, 0), a, 0.02 * a);
    // Half the height of the hump is 0.833 m ahead of its crest.
    EXPECT_NEAR(model->records()->arrival_s(300, 0), (grid.x_m(300) - 10 - std::sqrt(std::log(2))) / std::sqrt(g),
                0.02);
}

TEST(ShallowRecords, AreKeptOnlyWhereAskedFor) {
    EXPECT_EQ(make_shallow_water<float>(flume(4, 4))->records(), nullptr);
}

}  // namespace
}  // namespace waterlight::testing
