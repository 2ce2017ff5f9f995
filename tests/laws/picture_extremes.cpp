// The mirrored sun keeps its power, and no camera or sky draws what is not a number.
#include <limits>

#include "caustics/kernels/optics.hpp"
#include "sim/error.hpp"
#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

class PictureExtremes : public GpuTest {
  protected:
    void expect_finite(const Scene& scene, const Look& look, const Camera& camera) {
        renderer->draw(scene, look, camera);
        for (const float value : renderer->read_radiance().rgb) {
            ASSERT_TRUE(std::isfinite(value));
            ASSERT_GE(value, 0);
        }
    }
    void SetUp() override {
        GpuTest::SetUp();
        renderer = std::make_unique<SceneRenderer>(context);
    }
    std::unique_ptr<SceneRenderer> renderer;
};

// Radiance times solid angle over the whole mirror image is the sun's irradiance across its beam times Fresnel's
// reflectance, whatever the size of a pixel.
TEST_F(PictureExtremes, TheMirroredSunKeepsItsPower) {
    const Surface surface = calm_surface(Side::absorbing);
    Scene scene;
    scene.surface = &surface;
    scene.depth_m = 2;
    scene.sun = {.elevation_deg = 40, .azimuth_deg = 0, .irradiance_w_m2 = 900};
    Look look = plain_look(0);
    look.sky.irradiance_w_m2 = 0.0;
    const double sine = std::sin(40 * std::numbers::pi / 180), n = scene.optics.refractive_index;
    const double reflected =
        900 * (1 - f64::fresnel_transmittance(sine, std::sqrt(1 - (1 - sine * sine) / (n * n)), n));
    for (const int rows : {90, 360, 1080}) {
        Camera camera = camera_at({0, 3, 2}, {0 + 2 / std::tan(40 * std::numbers::pi / 180), 3, 0}, {rows, rows});
        camera.fov_deg = 8;
        renderer->draw(scene, look, camera);
        const Radiance seen = renderer->read_radiance();
        const Camera::Rays rays = camera.rays();
        const double pixel = glm::length(rays.right);
        double power = 0;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < rows; ++i)
                power += radiance_at(seen, i, j).y * pixel * pixel / std::pow(glm::length(rays.at(i, j)), 3);
        EXPECT_NEAR(power / reflected, 1, 0.05) << rows << " rows";
    }
}

TEST_F(PictureExtremes, NothingButNumbersFromAnywhere) {
    for (const Side side : {Side::wall, Side::periodic, Side::absorbing}) {
        const Surface surface = wavy_surface(side);
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = 2;
        const Look look;
        for (const glm::dvec3 eye :
             {glm::dvec3{4, 3, 5}, {4, 3, 0}, {4, 3, -1.9}, {4, 3, -3}, {-50, 3, -1}, {1e4, 1e4, 300}})
            for (const glm::dvec3 target : {glm::dvec3{4, 3, -1}, {4, 3, 100}, {5, 3, 0}})
                if (eye != target) expect_finite(scene, look, camera_at(eye, target, {40, 30}));
    }
}

TEST_F(PictureExtremes, NothingButNumbersAtAnySun) {
    const Surface surface = wavy_surface(Side::wall);
    Scene scene;
    scene.surface = &surface;
    scene.depth_m = 2;
    for (const double elevation : {-20.0, 0.0, 0.01, 5.0, 90.0})
        for (const double n : {1.0, 4.0 / 3.0, 2.4}) {
            scene.sun.elevation_deg = elevation;
            scene.optics.refractive_index = n;
            expect_finite(scene, {}, camera_at({4, -3, 3}, {4, 3, 0}, {40, 30}));
            expect_finite(scene, {}, camera_at({4, 1, -1}, {4, 3, 0}, {40, 30}));
        }
}

TEST_F(PictureExtremes, ACameraNowhereIsRefused) {
    const Surface surface = calm_surface(Side::wall);
    Scene scene;
    scene.surface = &surface;
    for (const double nowhere : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(renderer->draw(scene, {}, camera_at({nowhere, 0, 1}, {4, 3, 0})), InputError);
        EXPECT_THROW(renderer->draw(scene, {}, camera_at({4, 3, 1}, {4, 3, nowhere})), InputError);
    }
}

TEST_F(PictureExtremes, TheSmallestPicturesAndGrids) {
    const Surface surface(make_grid(2, 2, 1, 1), {Side::wall, Side::wall});
    Scene scene;
    scene.surface = &surface;
    expect_finite(scene, {}, camera_at({0.5, 0.5, 2}, {0.5, 0.5, 0}, {1, 1}));
    expect_finite(scene, {}, camera_at({0.5, -1, 1}, {0.5, 0.5, 0}, {37, 1}));
}

}  // namespace
}  // namespace waterlight
