// Pictures in a window of a virtual screen, under the validation layer.
#include "gpu/presenter.hpp"

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/device.hpp"
#include "gpu/error.hpp"
#include "gpu/raster.hpp"
#include "render/window.hpp"
#include "shaders/gpu_colour.hpp"
#include "shaders/gpu_layers.hpp"
#include "sim/error.hpp"
#include "tests/support/gpu_fixture.hpp"
#include "tests/support/virtual_display.hpp"

namespace waterlight {
namespace {

struct Square {
    float x, y, side, depth;
    std::array<float, 4> colour;
};

struct Size {
    int width, height;
};

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour red{255, 0, 0}, green{0, 255, 0}, black{0, 0, 0}, white{255, 255, 255};

/// An atlas of one letter of 2 x 2 texels: clear but for its upper left texel; beside it one opaque texel.
constexpr std::array<std::uint8_t, 8> letters{255, 0, 255, 255, 0, 0, 255, 255};
constexpr gpu::InterfaceAtlas atlas{4, 2, letters};

class PresenterTest : public GpuTest {
  protected:
    void SetUp() override {
        if (!test::VirtualDisplay::is_installed()) GTEST_SKIP() << "there is no Xvfb";
        if (gpu::survey().candidates.empty()) GTEST_SKIP() << "there is no Vulkan";
        display.emplace();
        window.emplace("waterlight presents", glm::ivec2(64, 48));
        open({.validation = true, .window_system = window->system()});
        presenter.emplace(context, window->surface(), atlas);
    }
    void TearDown() override {
        presenter.reset();
        GpuTest::TearDown();
        context.reset();
        window.reset();
        display.reset();
    }

    /// A red square in the lower left corner of black, and a green one above it.
    gpu::Target picture(int width, int height) {
        const gpu::TargetSettings bytes{.format = gpu::Format::rgba8};
        gpu::Target target(context, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), bytes);
        gpu::Buffer squares(context, 2 * sizeof(Square), gpu::BufferUse::from_host);
        const auto side = static_cast<float>(height) / 4;
        squares.host<Square>()[0] = {0, 0, side, 0, {1, 0, 0, 1}};
        squares.host<Square>()[1] = {0, side, side, 0, {0, 1, 0, 1}};
        gpu::Raster raster(context, {.name = "squares",
                                     .vertex_spirv = shaders::gpu_layers,
                                     .fragment_spirv = shaders::gpu_colour,
                                     .buffers = 1,
                                     .push_bytes = sizeof(Size),
                                     .topology = gpu::Topology::triangles,
                                     .blend = gpu::Blend::replace,
                                     .format = gpu::Format::rgba8});
        raster.bind({&squares});
        gpu::Commands commands(context);
        commands.upload(squares);
        commands.clear(target);
        commands.draw(raster, target, {1, 12}, Size{width, height});
        commands.run();
        return target;
    }

    bool present(const gpu::Target& target, const gpu::InterfaceDrawing& drawing = {}) {
        window->events();
        const glm::ivec2 size = window->size();
        return presenter->present(target, drawing,
                                  {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)});
    }

    /// The window's pixel on the screen comes to be of this colour, within five seconds of pictures.
    testing::AssertionResult becomes(const gpu::Target& target, glm::ivec2 at, Colour colour,
                                     const gpu::InterfaceDrawing& drawing = {}) {
        Colour found{};
        for (int n = 0; n < 500; ++n) {
            present(target, drawing);
            glm::ivec2 corner;
            glfwGetWindowPos(window->handle(), &corner.x, &corner.y);
            found = display->screen().at(corner.x + at.x, corner.y + at.y);
            if (found == colour) return testing::AssertionSuccess();
            window->events(0.01);
        }
        return testing::AssertionFailure() << "it is " << int{found[0]} << ' ' << int{found[1]} << ' ' << int{found[2]};
    }

    std::optional<test::VirtualDisplay> display;
    std::optional<Window> window;
    std::optional<gpu::Presenter> presenter;
};

TEST_F(PresenterTest, ShowsAPictureUpright) {
    const gpu::Target squares = picture(64, 48);
    EXPECT_TRUE(becomes(squares, {5, 47 - 5}, red));
    EXPECT_TRUE(becomes(squares, {5, 47 - 17}, green));
    EXPECT_TRUE(becomes(squares, {5, 5}, black));
    EXPECT_TRUE(becomes(squares, {30, 47 - 5}, black));
}

TEST_F(PresenterTest, ScalesThePictureToTheWindow) {
    const gpu::Target squares = picture(16, 12);
    EXPECT_TRUE(becomes(squares, {5, 47 - 5}, red));
    EXPECT_TRUE(becomes(squares, {5, 47 - 18}, green));
    EXPECT_TRUE(becomes(squares, {40, 10}, black));
}

TEST_F(PresenterTest, LaysTheInterfaceOverThePicture) {
    const gpu::Target squares = picture(64, 48);
    gpu::InterfaceDrawing drawing;
    const auto rectangle = [&](float x, float y, float side, std::array<float, 4> uv, std::uint32_t rgba) {
        const auto first = static_cast<std::uint32_t>(drawing.corners.size());
        drawing.corners.insert(drawing.corners.end(), {{x, y, uv[0], uv[1], rgba},
                                                       {x + side, y, uv[2], uv[1], rgba},
                                                       {x + side, y + side, uv[2], uv[3], rgba},
                                                       {x, y + side, uv[0], uv[3], rgba}});
        for (const std::uint32_t corner : {0, 1, 2, 0, 2, 3}) drawing.indices.push_back(first + corner);
    };
    constexpr float opaque = 2.5F / 4;
    rectangle(10, 20, 8, {opaque, 0.5F, opaque, 0.5F}, 0xffffffffU);  // white
    rectangle(30, 20, 2, {0, 0, 0.5F, 1}, 0xff00ff00U);               // the letter in green
    rectangle(2, 42, 4, {opaque, 0.5F, opaque, 0.5F}, 0x80ffffffU);   // a veil over the red square
    drawing.batches = {{{0, 0}, {14, 200}, 0, 6}, {{-5, -5}, {500, 500}, 6, 12}};
    EXPECT_TRUE(becomes(squares, {12, 24}, white, drawing));
    EXPECT_TRUE(becomes(squares, {15, 24}, black, drawing)) << "beyond the rectangle of its batch";
    EXPECT_TRUE(becomes(squares, {30, 20}, green, drawing));
    EXPECT_TRUE(becomes(squares, {31, 20}, black, drawing)) << "clear texels of a letter";
    EXPECT_TRUE(becomes(squares, {3, 44}, {255, 128, 128}, drawing));
}

TEST_F(PresenterTest, FollowsTheWindowThroughManySizes) {
    const gpu::Target squares = picture(64, 48);
    int shown = 0;
    for (int n = 0; n < 200; ++n) {
        if (n % 4 == 0) glfwSetWindowSize(window->handle(), 40 + 13 * (n % 31), 30 + 7 * (n % 47));
        if (present(squares)) ++shown;
    }
    EXPECT_GT(shown, 100);
    glfwSetWindowSize(window->handle(), 640, 480);
    EXPECT_TRUE(becomes(squares, {60, 479 - 60}, red));
    EXPECT_TRUE(becomes(squares, {60, 479 - 170}, green));
}

TEST_F(PresenterTest, DrawsNothingInAWindowWithoutArea) {
    const gpu::Target squares = picture(64, 48);
    EXPECT_FALSE(presenter->present(squares, {}, {0, 0}));
    EXPECT_TRUE(becomes(squares, {5, 47 - 5}, red));
}

// By a layer that loses the surface at the fourth picture.
TEST_F(PresenterTest, MakesALostSurfaceAnew) {
    presenter.reset();
    ::setenv("VK_ADD_LAYER_PATH", WATERLIGHT_LAYERS, 1);
    ::setenv("VK_INSTANCE_LAYERS", "VK_LAYER_WATERLIGHT_lost_device", 1);
    ::setenv("WATERLIGHT_SURFACE_LOST_AT", "4", 1);
    open({.validation = true, .window_system = window->system()});
    for (const char* name : {"VK_ADD_LAYER_PATH", "VK_INSTANCE_LAYERS"}) ::unsetenv(name);
    int made = 0;
    const auto counted = [&](VkInstance_T* instance) {
        ++made;
        return window->surface()(instance);
    };
    presenter.emplace(context, counted, atlas);
    const gpu::Target squares = picture(64, 48);
    std::string shown;
    for (int n = 0; n < 6; ++n) shown += present(squares) ? '1' : '0';
    ::unsetenv("WATERLIGHT_SURFACE_LOST_AT");
    EXPECT_EQ(shown, "111011");
    EXPECT_EQ(made, 2);
    EXPECT_TRUE(becomes(squares, {5, 47 - 5}, red));
}

TEST_F(PresenterTest, RefusesADeviceThatCannotShow) {
    gpu::WindowSystem blind = window->system();
    blind.presents = [](VkInstance_T*, VkPhysicalDevice_T*, std::uint32_t) { return false; };
    try {
        gpu::Context({.window_system = blind});
        FAIL() << "it was opened";
    } catch (const gpu::Error& error) {
        EXPECT_NE(std::string(error.what()).find("cannot show pictures in this window system"), std::string::npos)
            << error.what();
    }
}

TEST(Window, SaysThatThereIsNoDisplay) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    try {
        Window window("waterlight", {64, 48});
        FAIL() << "it was opened";
    } catch (const WorldError& error) {
        EXPECT_STREQ(error.what(),
                     "cannot open a window: no display (DISPLAY and WAYLAND_DISPLAY are not set); `waterlight run` "
                     "renders without one");
    }
}

TEST(Window, SaysThatTheDisplayIsNotThere) {
    ::setenv("DISPLAY", ":999999", 1);
    EXPECT_THROW(Window("waterlight", {64, 48}), WorldError);
    ::unsetenv("DISPLAY");
}

}  // namespace
}  // namespace waterlight
