// A white furnace: a uniform sky of radiance L, everything white, no sun, nothing absorbed. Whatever is reflected,
// refracted or thrown back, every pixel has the radiance L in the air and n^2 L in the water.
#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

class RenderFurnace : public GpuTest {
  protected:
    /// Draws the surface in the furnace and expects the radiance of the camera's side in every pixel.
    void expect_white(const Surface& surface, const Camera& camera, double times,
                      const Field<float>* ground = nullptr) {
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = 2;
        scene.ground_m = ground;
        scene.sun.irradiance_w_m2 = 0;
        const Look look = plain_look(1);
        SceneRenderer renderer(context);
        renderer.draw(scene, look, camera);
        const Radiance seen = renderer.read_radiance();
        const double expected = times * *look.sky.irradiance_w_m2 / std::numbers::pi;
        double worst = 0;
        for (const float value : seen.rgb) worst = std::max(worst, std::abs(value / expected - 1));
        EXPECT_LT(worst, 0.01);
    }
    static constexpr double n2 = 16.0 / 9.0;
};

TEST_F(RenderFurnace, StaysWhiteAboveAPool) {
    for (const Surface& surface : {calm_surface(Side::wall), wavy_surface(Side::wall)}) {
        expect_white(surface, camera_at({4, -2, 3}, {4, 3, 0}), 1);
        expect_white(surface, camera_at({4, 3, 5}, {4, 3, 0}), 1);
    }
}

TEST_F(RenderFurnace, StaysWhiteInAPool) {
    for (const Surface& surface : {calm_surface(Side::wall), wavy_surface(Side::wall)}) {
        expect_white(surface, camera_at({4, 1, -1}, {4, 5, -0.4}), n2);
        expect_white(surface, camera_at({2, 2, -1.5}, {3, 3, 0}), n2);
    }
}

TEST_F(RenderFurnace, StaysWhiteAboveTheSeaToTheHorizon) {
    for (const Side side : {Side::periodic, Side::absorbing})
        for (const Surface& surface : {calm_surface(side), wavy_surface(side)})
            expect_white(surface, camera_at({4, 3, 2}, {30, 8, 1}), 1);
}

TEST_F(RenderFurnace, StaysWhiteInTheSea) {
    for (const Side side : {Side::periodic, Side::absorbing})
        for (const Surface& surface : {calm_surface(side), wavy_surface(side)})
            expect_white(surface, camera_at({4, 3, -1}, {8, 5, 0}), n2);
}

TEST_F(RenderFurnace, StaysWhiteOverABeach) {
    const Surface surface = calm_surface(Side::wall);
    Field<float> ground(surface.grid.nx, surface.grid.ny);
    for (int j = 0; j < surface.grid.ny; ++j)
        for (int i = 0; i < surface.grid.nx; ++i)
            ground(i, j) = static_cast<float>(-0.8 + 0.15 * surface.grid.x_m(i));  // dry from x = 5.33 m
    expect_white(surface, camera_at({1, -1, 3}, {5, 3, 0}), 1, &ground);
    expect_white(surface, camera_at({1, 3, -0.3}, {4, 3.3, -0.3}), n2, &ground);
}

}  // namespace
}  // namespace waterlight
