// Objects darken the floor map on Vulkan as they do on the CPU.
#include <gtest/gtest.h>

#include <ostream>

#include "caustics/floor_vulkan.hpp"
#include "tests/support/gpu_fixture.hpp"
#include "tests/support/shadow_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

class FloorShadowsOnVulkan : public GpuTest {
  protected:
    void compare(FloorSettings s, const Surface& surface) {
        for (const Footprint footprint : {Footprint::adaptive, Footprint::pixel}) {
            s.footprint = footprint;
            FloorMap cpu, vulkan;
            make_floor_cpu(s)->compute(surface, cpu);
            make_floor_vulkan(s, context)->compute(surface, vulkan);
            Field<double> expected(cpu.irradiance.nx(), cpu.irradiance.ny());
            std::ranges::copy(cpu.irradiance.values(), expected.data());
            EXPECT_LT(relative_rmse(vulkan.irradiance, expected), 1e-4);
            const FloorLedger &a = vulkan.ledger, &b = cpu.ledger;
            const double tolerance = 1e-5 * (b.incident_w + b.entered_w);
            EXPECT_GT(b.objects_w, 1e-2 * b.incident_w);
            EXPECT_NEAR(a.objects_w, b.objects_w, tolerance);
            EXPECT_NEAR(a.reflected_w, b.reflected_w, tolerance);
            EXPECT_NEAR(a.extinguished_w, b.extinguished_w, tolerance);
            EXPECT_NEAR(a.floor_w, b.floor_w, tolerance);
            EXPECT_NEAR(a.outside_w, b.outside_w, tolerance);
            EXPECT_NEAR(a.entered_w, b.entered_w, tolerance);
            EXPECT_LT(a.closure(), 1e-5);
        }
    }
};

TEST_F(FloorShadowsOnVulkan, InStillWaterAndInWavesInAllKindsOfPools) {
    const Formula waves = sines({{.02, 1, 0}, {.012, .5, 90}});
    FloorSettings s;
    s.plan = cover(make_grid(128, 96, 4, 3), 100, 75);
    s.depth_m = 2;
    s.objects = objects_of({ball(.4, {2, 1.5, -1}), ball(.3, {3.9, 2.8, .5})});
    s.sun = {55, 30, 1000};
    compare(s, sample(make_grid(128, 96, 4, 3), {}, flat));
    s.optics.absorption_per_m = .3;
    for (const Side side : {Side::periodic, Side::wall, Side::absorbing})
        compare(s, sample(make_grid(128, 96, 4, 3), {side, side}, waves));
    s.plan = {80, 70, {1.2, .6}, {.02, .02}, 33};
    compare(s, sample(make_grid(128, 96, 4, 3), {}, waves));
}

TEST_F(FloorShadowsOnVulkan, WhatIsNotInTheWayChangesNothing) {
    FloorSettings s;
    s.plan = cover(make_grid(128, 96, 4, 3), 100, 75);
    s.depth_m = 2;
    const Surface surface = sample(make_grid(128, 96, 4, 3), {}, sines({{.02, 1, 0}}));
    FloorMap bare, with;
    make_floor_vulkan(s, context)->compute(surface, bare);
    s.objects = objects_of({ball(.4, {2, 1.5, -5})});
    make_floor_vulkan(s, context)->compute(surface, with);
    EXPECT_TRUE(std::ranges::equal(bare.irradiance.values(), with.irradiance.values()));
    EXPECT_EQ(bare.ledger.floor_w, with.ledger.floor_w);
}

}  // namespace
}  // namespace waterlight
