// Flat water over a plain floor: a pixel in closed form.
#include "caustics/kernels/optics.hpp"
#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

class RenderCalm : public GpuTest {
  protected:
    Surface surface = calm_surface(Side::periodic);
    Scene scene;
    Look look = plain_look(0.5);
    void SetUp() override {
        GpuTest::SetUp();
        scene.surface = &surface;
        scene.depth_m = 2;
        scene.sun = {.elevation_deg = 50, .azimuth_deg = 90, .irradiance_w_m2 = 900};
        scene.optics.absorption_per_m = 0.3;
        look.sky.irradiance_w_m2 = 0.0;
    }
};

// Straight down on a floor that absorbs all it does not send up: the sun's light through the surface, down, up, out.
TEST_F(RenderCalm, SeenFromAboveIsTheSunsLightDownAndUpAgain) {
    const double n = scene.optics.refractive_index, floor_albedo = 0.5;
    const double sin_el = std::sin(50 * std::numbers::pi / 180), cos_t = std::sqrt(1 - (1 - sin_el * sin_el) / (n * n));
    const double entering = 900 * sin_el * f64::fresnel_transmittance(sin_el, cos_t, n);
    const double on_floor = entering * std::exp(-0.3 * 2 / cos_t);
    // What the floor sends up and the surface throws back comes beside it: r_int of a diffuse light, each time less by
    // diffuse absorption on the way, exp(-1.2 a D).
    const double r_ext = 0.0660, r_int = 1 - (1 - r_ext) / (n * n),
                 back = std::exp(-2.4 * 0.3 * 2) * r_int * floor_albedo;
    const double irradiance = on_floor * (1 + back / (1 - back));
    const double expected = floor_albedo * irradiance / std::numbers::pi * std::exp(-0.3 * 2) *
                            f64::fresnel_transmittance(1, 1, n) / (n * n);
    SceneRenderer renderer(context);
    renderer.draw(scene, look, camera_at({4, 3, 4}, {4, 3, -1}, {65, 65}));
    const glm::dvec3 seen = radiance_at(renderer.read_radiance(), 32, 32);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / expected, 1, 0.002);
}

// What is far away in water that absorbs is dark, up to the rows where floor and surface meet.
TEST_F(RenderCalm, TheHorizonBelowTheWaterIsDark) {
    scene.optics.absorption_per_m = 2;
    SceneRenderer renderer(context);
    for (const int height : {64, 65}) {
        renderer.draw(scene, look, camera_at({4, 3, -1}, {8, 3, -1.01}, {64, height}));
        const Radiance seen = renderer.read_radiance();
        // Five rows from the horizon sight meets the floor some 15 m off.
        for (int j = height / 2 - 4; j < height / 2 + 4; ++j)
            for (int i = 0; i < 64; ++i) EXPECT_LT(radiance_at(seen, i, j).y, 1e-4) << i << " " << j;
    }
}

}  // namespace
}  // namespace waterlight
