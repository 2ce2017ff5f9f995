// A white furnace of any index: a uniform sky of radiance L over white floor and walls. Every pixel has the radiance L
// in the air and n^2 L in the water, whatever the water's waves.
#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

class PictureFurnace : public GpuTest, public testing::WithParamInterface<double> {
  protected:
    /// Draws flat and wavy water and expects the furnace's radiance times `times` in every pixel.
    void expect_white(Side side, const Camera& camera, double times) {
        SceneRenderer renderer(context);
        for (const Surface& surface : {calm_surface(side), wavy_surface(side)}) {
            Scene scene;
            scene.surface = &surface;
            scene.depth_m = 2;
            scene.sun.irradiance_w_m2 = 0;
            scene.optics.refractive_index = GetParam();
            const Look look = plain_look(1);
            renderer.draw(scene, look, camera);
            const double expected = times * *look.sky.irradiance_w_m2 / std::numbers::pi;
            double worst = 0;
            for (const float value : renderer.read_radiance().rgb)
                worst = std::max(worst, std::abs(value / expected - 1));
            EXPECT_LT(worst, 0.01) << "n = " << GetParam() << ", eye at z = " << camera.position_m.z;
        }
    }
};

TEST_P(PictureFurnace, StaysWhiteFromAbove) {
    expect_white(Side::wall, camera_at({4, -2, 3}, {4, 3, 0}), 1);
    expect_white(Side::wall, camera_at({4, 3, 5}, {4, 3, 0}), 1);
    for (const Side side : {Side::periodic, Side::absorbing}) {
        expect_white(side, camera_at({4, 3, 2}, {30, 8, 1}), 1);
        expect_white(side, camera_at({4, 3, 0.3}, {6, 3, 0}), 1);
    }
}

TEST_P(PictureFurnace, StaysWhiteFromBelow) {
    const double n2 = GetParam() * GetParam();
    expect_white(Side::wall, camera_at({4, 1, -1}, {4, 5, -0.4}), n2);
    expect_white(Side::wall, camera_at({2, 2, -1.5}, {3, 3, 0}), n2);
    for (const Side side : {Side::periodic, Side::absorbing}) {
        expect_white(side, camera_at({4, 3, -1}, {8, 5, 0}), n2);
        expect_white(side, camera_at({4, 3, -0.3}, {4.1, 3, 0}), n2);
    }
}

INSTANTIATE_TEST_SUITE_P(Indices, PictureFurnace, testing::Values(1.0, 4.0 / 3.0, 1.5));

}  // namespace
}  // namespace waterlight
