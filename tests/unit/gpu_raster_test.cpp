// Raster passes blend fragments into a target, on whatever device there is, under the validation layer.
#include "gpu/raster.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/error.hpp"
#include "shaders/gpu_colour.hpp"
#include "shaders/gpu_halved.hpp"
#include "shaders/gpu_layers.hpp"
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

struct Layer {
    float x, y, side, depth;
    std::array<float, 4> colour;
};

/// Draws layers into one target, then half of that into a second, and reads both.
struct Painter {
    static constexpr int width = 8, height = 8;
    std::shared_ptr<Context> context;
    Target first, second;
    Buffer layers, whole;
    Raster painted, halved;
    Commands commands;

    Painter(const std::shared_ptr<Context>& c, const TargetSettings& target, Blend blend)
        : context(c),
          first(c, width, height, target),
          second(c, width, height, {.format = Format::rgba8}),
          layers(c, 4 * sizeof(Layer), BufferUse::from_host),
          whole(c, sizeof(Layer), BufferUse::from_host),
          painted(c, {.name = "paint",
                      .vertex_spirv = shaders::gpu_layers,
                      .fragment_spirv = shaders::gpu_colour,
                      .buffers = 1,
                      .push_bytes = sizeof(Size),
                      .topology = Topology::triangles,
                      .blend = blend,
                      .depth = target.depth ? Depth::test_and_set : Depth::none,
                      .format = target.format,
                      .samples = first.samples()}),
          halved(c, {.name = "halve",
                     .vertex_spirv = shaders::gpu_layers,
                     .fragment_spirv = shaders::gpu_halved,
                     .buffers = 1,
                     .push_bytes = sizeof(Size),
                     .targets = 1,
                     .topology = Topology::triangles,
                     .blend = Blend::replace,
                     .format = Format::rgba8}),
          commands(c) {
        painted.bind({&layers});
        if (first.samples() == 1) halved.bind({&whole}, {&first});
        whole.host<Layer>()[0] = {0, 0, width, 0, {1, 1, 1, 1}};
    }

    template <class Number>
    std::vector<Number> read(const Target& target) {
        Buffer pixels(context, target.bytes(), BufferUse::to_host);
        commands.copy(target, pixels);
        commands.download(pixels);
        commands.run();
        const std::span<const Number> all = pixels.host<Number>();
        return {all.begin(), all.end()};
    }

    void paint(std::initializer_list<Layer> drawn) {
        std::ranges::copy(drawn, layers.host<Layer>().begin());
        commands.upload(layers);
        commands.upload(whole);
        commands.clear(first);
        commands.clear(second);
        commands.draw(painted, first, {1, 6 * static_cast<std::uint32_t>(drawn.size())}, Size{width, height});
        commands.resolve(first);
        if (first.samples() == 1) commands.draw(halved, second, {1, 6}, Size{width, height});
        commands.run();
    }
};

TEST_F(GpuRaster, KeepsTheNearerOfTwoLayersInWhateverOrder) {
    for (const Format format : {Format::rgba32f, Format::rgba16f}) {
        Painter painter(context, {.format = format, .depth = true}, Blend::replace);
        painter.paint({{0, 0, 4, 0.75F, {1, 0.5F, 0, 1}}, {0, 0, 8, 0.25F, {0, 0, 1, 1}}});
        const std::vector<std::uint8_t> half = painter.read<std::uint8_t>(painter.second);
        for (std::size_t pixel = 0; pixel < 64; ++pixel) {
            const bool near = pixel % 8 < 4 && pixel / 8 < 4;
            EXPECT_NEAR(half[4 * pixel], near ? 127.5 : 0, 0.51);
            EXPECT_NEAR(half[4 * pixel + 1], near ? 63.75 : 0, 0.51);
            EXPECT_NEAR(half[4 * pixel + 2], near ? 0 : 127.5, 0.51);
        }
    }
}

TEST_F(GpuRaster, ResolvesThePartOfAPixelThatALayerCovers) {
    Painter painter(context, {.format = Format::rgba32f, .samples = 4, .depth = true}, Blend::replace);
    if (painter.first.samples() != 4) GTEST_SKIP() << "the device has not four samples";
    painter.paint(
        {{-4, 0, 8, 0.5F, {1, 1, 1, 1}}, {3.5F, 0, 0.5F, 0.5F, {0, 0, 0, 1}}, {4, 0, 0.5F, 0.5F, {3, 3, 3, 1}}});
    const std::vector<float> all = painter.read<float>(painter.first);
    EXPECT_EQ(all[4 * 2], 1.0F);
    // Half of the samples of a pixel lie on either side of its middle, both ways: a quarter of them in the small
    // squares.
    EXPECT_EQ(all[4 * 3], 0.75F);
    EXPECT_EQ(all[4 * 4], 0.75F);
    EXPECT_EQ(all[4 * 5], 0.0F);
}

TEST_F(GpuRaster, LaysPremultipliedColoursOver) {
    Painter painter(context, {.format = Format::rgba32f}, Blend::over);
    painter.paint({{0, 0, 8, 0, {8, 4, 2, 1}}, {0, 0, 8, 0, {1, 1, 1, 0.25F}}});
    const std::vector<float> all = painter.read<float>(painter.first);
    EXPECT_EQ((std::vector<float>(all.begin(), all.begin() + 4)), (std::vector<float>{7, 4, 2.5F, 1}));
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
