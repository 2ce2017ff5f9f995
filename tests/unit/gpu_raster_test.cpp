// Raster passes add floats to a target, on whatever device there is, under the validation layer.
#include "gpu/raster.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/error.hpp"
#include "shaders/gpu_strip.hpp"
#include "shaders/gpu_value.hpp"
#include "tests/support/gpu_fixture.hpp"

namespace waterlight::gpu {
namespace {

struct Square {
    float x, y, side, value;
};
struct Size {
    int width, height;
};

class GpuRaster : public GpuTest {};

/// Squares whose edges run between pixels: every pixel holds the sum of those that cover its centre, row 0 first.
void expect_sums_of_squares(const std::shared_ptr<Context>& context) {
    constexpr int width = 37, height = 23;
    const std::vector<Square> squares{{1, 2, 10, 3}, {5, 5, 20, 0.25F}, {-4, 15, 30, -7}, {36, 22, 1, 1e20F}};
    Buffer from(context, squares.size() * sizeof(Square), BufferUse::from_host);
    Buffer to(context, sizeof(float) * width * height, BufferUse::to_host);
    std::ranges::copy(squares, from.host<Square>().begin());
    Target target(context, width, height);
    Raster raster(
        context,
        {"squares", shaders::gpu_strip, shaders::gpu_value, 1, sizeof(Size), {std::bit_cast<std::uint32_t>(2.0F)}});
    raster.bind({&from});
    Commands commands(context, 2);
    for (int frame = 0; frame < 2; ++frame) {
        commands.upload(from);
        commands.clear(target);
        for (int k = 0; k < 2; ++k) commands.draw(raster, target, {4, 4}, Size{width, height});
        commands.copy(target, to);
        commands.download(to);
        commands.run();
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                float expected = 0;
                for (const Square& s : squares)
                    if (i + .5F > s.x && i + .5F < s.x + s.side && j + .5F > s.y && j + .5F < s.y + s.side)
                        expected += 2 * 2 * s.value;
                EXPECT_EQ(to.host<float>()[static_cast<std::size_t>(j * width + i)], expected) << i << " " << j;
            }
    }
    ASSERT_EQ(commands.timings().size(), 2U);
    EXPECT_EQ(commands.timings()[0].pass, "squares");
}

TEST_F(GpuRaster, AddsWhatEachStripBrings) { expect_sums_of_squares(context); }

TEST_F(GpuRaster, AndSoItDoesThroughStagingAreas) {
    open({.staging = true, .validation = true});
    expect_sums_of_squares(context);
}

TEST_F(GpuRaster, RefusesAPictureLargerThanTheDeviceDraws) {
    EXPECT_THROW(Target(context, context->device().largest_target + 1, 1), Error);
}

TEST(DrawingRejections, NameWhatIsMissing) {
    DeviceDescription device;
    device.graphics = device.adds_floats = true;
    EXPECT_TRUE(drawing_rejections(device).empty());
    device.adds_floats = false;
    EXPECT_EQ(drawing_rejections(device), std::vector<std::string>{"does not blend into targets of 32-bit floats"});
    device.graphics = false;
    EXPECT_EQ(drawing_rejections(device).size(), 2U);
}

}  // namespace
}  // namespace waterlight::gpu
