// A hand does to shallow water on a Vulkan device what it does on the CPU.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sim/shallow_water_vulkan.hpp"
#include "tests/support/gpu_fixture.hpp"

namespace waterlight {
namespace {

using DisturbVulkan = GpuTest;

TEST_F(DisturbVulkan, ComesToTheWaterOfTheCpu) {
    ShallowWaterSettings settings;
    settings.grid = make_grid(60, 45, 6, 4.5);
    settings.bed_m = Field<double>(60, 45);
    for (int j = 0; j < 45; ++j)
        for (int i = 0; i < 60; ++i) settings.bed_m(i, j) = -0.4 + 0.1 * settings.grid.x_m(i);
    const auto on_device = make_shallow_water_vulkan(settings, context);
    const auto on_cpu = make_shallow_water<float>(settings);
    const std::array<Disturbance, 3> hand{Drop{{2, 2}, 0.4, 0.05, 0}, Push{{1.5, 3}, 0.5, 0.02},
                                          Push{{4, 1}, 0.4, -0.05}};
    const Rain rain{3, {0.2, 0.3}, {-0.02, -0.01}, 0, 1e30, 4};
    for (ShallowWaterModel* model : {on_device.get(), on_cpu.get()}) {
        model->set_rain({&rain, 1});
        model->advance(0.1);
        model->disturb(hand);
        model->advance(0.5);
        model->disturb(hand);
    }
    const Field<float>&device = on_device->surface().elevation, &cpu = on_cpu->surface().elevation;
    const Field<float>& depth = *on_cpu->surface().depth;
    double most = 0, difference = 0;
    for (std::size_t n = 0; n < cpu.size(); ++n) {
        if (depth.data()[n] <= 0) continue;
        most = std::max(most, std::abs(static_cast<double>(cpu.data()[n])));
        difference = std::max(difference, std::abs(static_cast<double>(device.data()[n]) - cpu.data()[n]));
    }
    EXPECT_GT(most, 0.02);
    EXPECT_LT(difference, 1e-4 * most);
    EXPECT_NEAR(on_device->totals().volume_m3, on_cpu->totals().volume_m3, 2e-6 * on_cpu->totals().volume_m3);
}

}  // namespace
}  // namespace waterlight
