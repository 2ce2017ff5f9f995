// Data shown in a picture: each pixel has the colour that the legend gives to its value, to the last of 256 shades.
#include "render/overlay_map.hpp"
#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

class RenderOverlay : public GpuTest {
  protected:
    Surface surface = calm_surface(Side::periodic);
    Field<float> map{64, 48};
    Scene scene;
    Look look = plain_look(0.5);

    void SetUp() override {
        GpuTest::SetUp();
        scene.surface = &surface;
        scene.depth_m = 2;
        scene.floor_plan = cover(surface.grid, 64, 48);
        scene.sun = {.elevation_deg = 50, .azimuth_deg = 90, .irradiance_w_m2 = 900};
        scene.optics.absorption_per_m = 0.3;
        look.colour_per_m = {0.3, 0.05, 0.01};
    }

    /// The pixel in the middle of a look straight down.
    Rgb middle() {
        SceneRenderer renderer(context);
        const glm::ivec2 size{33, 33};
        renderer.draw(scene, look, camera_at({4, 3, 4}, {4, 3, -1}, size));
        const std::vector<std::uint8_t> all = renderer.read_picture();
        const std::uint8_t* rgba = all.data() + 4 * (16 * size.x + 16);
        return {rgba[0], rgba[1], rgba[2]};
    }
    void expect_colour_of(double value) {
        const double position = (value - look.range.low) / (look.range.high - look.range.low);
        const Rgb expected = colour(overlay_map(look.overlay), position), found = middle();
        // A shade of the 256 of the map, and one of the picture.
        constexpr int most = 4;
        EXPECT_NEAR(found.r, expected.r, most) << "of " << value;
        EXPECT_NEAR(found.g, expected.g, most) << "of " << value;
        EXPECT_NEAR(found.b, expected.b, most) << "of " << value;
    }
    void fill(float value) { std::ranges::fill(map.values(), value); }
};

TEST_F(RenderOverlay, IrradianceHasTheColourOfItsValueThroughWaterOfAnyColour) {
    look.overlay = Overlay::irradiance;
    look.range = {0, 2000};
    scene.floor = &map;
    for (const double value : {0.0, 250.0, 700.0, 1300.0, 1999.0, 5000.0}) {
        fill(static_cast<float>(value));
        expect_colour_of(value);
    }
}

TEST_F(RenderOverlay, AnErrorHasASign) {
    look.overlay = Overlay::error;
    look.range = {-50, 50};
    scene.floor = scene.error = &map;
    for (const double value : {-80.0, -20.0, 0.0, 35.0, 50.0}) {
        fill(static_cast<float>(value));
        expect_colour_of(value);
    }
}

TEST_F(RenderOverlay, ElevationIsShownOnTheWater) {
    look.overlay = Overlay::elevation;
    look.range = {-0.02, 0.02};
    for (const double value : {-0.03, -0.01, 0.0, 0.015}) {
        std::ranges::fill(surface.elevation.values(), static_cast<float>(value));
        expect_colour_of(value);
    }
}

}  // namespace
}  // namespace waterlight
