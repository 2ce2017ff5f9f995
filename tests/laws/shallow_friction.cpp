// Manning's friction.
#include <gtest/gtest.h>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

template <class Real>
class ShallowFriction : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ShallowFriction, Precisions);

/// Flow on level ground that is the same everywhere.
ShallowWaterSettings uniform_flow(double depth_m, glm::dvec2 velocity_m_s, double manning) {
    ShallowWaterSettings settings;
    settings.grid = {6, 5, 1, 1, 0, 0};
    settings.sides = periodic_all;
    settings.water.depth_m = depth_m;
    settings.velocity_x_m_s = field_of(settings.grid, [&](int, int) { return velocity_m_s.x; });
    settings.velocity_y_m_s = field_of(settings.grid, [&](int, int) { return velocity_m_s.y; });
    settings.manning = manning;
    return settings;
}

// du/dt = -g n^2 u^2 / h^(4/3), whose solution is u0 / (1 + g n^2 u0 t / h^(4/3)): no error of the time step.
TYPED_TEST(ShallowFriction, UniformFlowDecaysExactly) {
    const double rounding = sizeof(TypeParam) == 4 ? 3e-5 : 1e-12;
    for (const double depth : {0.01, 1.0, 30.0}) {
        const glm::dvec2 start{1.2, -0.9};
        const double speed = 1.5, n = 0.04;
        const auto model = make_shallow_water<TypeParam>(uniform_flow(depth, start, n));
        watch(*model, 0.5, 5, [&](double t) {
            const double part = 1 / (1 + g * n * n * speed * t / std::pow(depth, 4.0 / 3));
            EXPECT_NEAR(model->state(2, 3).velocity_m_s.x, start.x * part, rounding);
            EXPECT_NEAR(model->state(2, 3).velocity_m_s.y, start.y * part, rounding);
        });
    }
}

TYPED_TEST(ShallowFriction, NeverTurnsTheFlow) {
    for (const double depth : {1e-6, 1e-3, 1.0}) {
        const auto model = make_shallow_water<TypeParam>(uniform_flow(depth, {3, -1}, 100));
        ShallowState before = model->state(0, 0);
        for (int n = 0; n < 50; ++n) {
            take_steps(*model, 1);
            const ShallowState s = model->state(0, 0);
            EXPECT_GE(s.velocity_m_s.x, 0);
            EXPECT_LE(s.velocity_m_s.y, 0);
            EXPECT_LE(speed_m_s(s), speed_m_s(before));
            before = s;
        }
    }
}

// On a slope S the flow settles where u = h^(2/3) sqrt(S) / n.
TEST(ShallowFriction, UniformFlowDownASlopeReachesNormalDepth) {
    struct Case {
        double slope, manning, discharge_m2_s, length_m;
    };
    for (const Case& c : {Case{1e-3, 0.03, 1, 2000}, Case{0.05, 0.02, 0.5, 400}}) {
        const double slope = c.slope, n = c.manning, q = c.discharge_m2_s, length_m = c.length_m;
        const double normal_m = std::pow(q * n / std::sqrt(slope), 0.6);
        const bool fast = q / normal_m > std::sqrt(g * normal_m);
        ShallowWaterSettings settings = flume(100, length_m);
        const Grid grid = settings.grid;
        settings.bed_m = field_of(grid, [&](int i, int) { return slope * (length_m - grid.x_m(i)); });
        settings.depth_m = field_of(grid, [&](int, int) { return 0.5 * normal_m; });
        settings.manning = n;
        settings.sides.west = DischargeSide{constant_series(q)};
        if (fast)
            settings.sides.west =
                FlowSide{slope * (length_m - grid.x_m(0)) + 0.7 * normal_m, {q / (0.7 * normal_m), 0}};
        settings.sides.east = LevelSide{constant_series(slope * (length_m - grid.x_m(grid.nx - 1)) + normal_m)};
        if (fast) settings.sides.east = OpenSide{};
        const auto model = make_shallow_water<double>(settings);
        model->advance(4 * length_m);
        for (int i = 40; i < 60; ++i) {
            const ShallowState s = model->state(i, 0);
            EXPECT_NEAR(s.depth_m, normal_m, 2e-3 * normal_m) << i << " on " << slope;
            EXPECT_NEAR(s.velocity_m_s.x, std::pow(s.depth_m, 2.0 / 3) * std::sqrt(slope) / n, 2e-3 * s.velocity_m_s.x)
                << i << " on " << slope;
        }
    }
}

}  // namespace
}  // namespace waterlight::testing
