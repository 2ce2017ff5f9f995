// Water of index 1 that takes no light is not there: the picture through its surface is that of a camera with no
// surface before it. The other picture has the surface above the camera, so that floor and walls are drawn directly.
#include <functional>

#include "tests/support/picture_places.hpp"
#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

class PictureInvisible : public GpuTest {
  protected:
    Radiance draw(const Surface& surface, const Camera& camera, double index) {
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = 2;
        scene.sun = {.elevation_deg = 50, .azimuth_deg = 180, .irradiance_w_m2 = 900};
        scene.optics.refractive_index = index;
        Look look = plain_look(0.7);
        look.floor.pattern = look.walls.pattern = Finish::Pattern::tiles;
        look.floor.tile_m = look.walls.tile_m = 0.5;
        look.sky.irradiance_w_m2 = 0.0;
        SceneRenderer renderer(context);
        renderer.draw(scene, look, camera);
        return renderer.read_radiance();
    }

    static Surface above_the_camera(Side side) {
        Surface surface = calm_surface(side);
        surface.elevation.fill(10);
        return surface;
    }

    /// The largest difference of two pictures, and the root mean square, in units of white in the sun.
    struct Difference {
        double most = 0, rms = 0;
    };
    static Difference difference(
        const Radiance& a, const Radiance& b,
        const std::function<bool(int, int)>& counts = [](int, int) { return true; }) {
        const double white = 900 * std::sin(50 * std::numbers::pi / 180) / std::numbers::pi;
        Difference d;
        for (std::size_t k = 0; k < a.rgb.size(); ++k) {
            const int pixel = static_cast<int>(k) / 3;
            if (!counts(pixel % a.size.x, pixel / a.size.x)) continue;
            const double off = std::abs(a.rgb[k] - b.rgb[k]) / white;
            d.most = std::max(d.most, off);
            d.rms += off * off;
        }
        d.rms = std::sqrt(d.rms / static_cast<double>(a.rgb.size()));
        return d;
    }
};

TEST_F(PictureInvisible, WavesOfIndexOneOverTiles) {
    const Camera camera = camera_at({4, 3, 2}, {6.2, 4.1, -2}, {320, 240});
    const Radiance without = draw(above_the_camera(Side::periodic), camera, 1);
    for (const Surface& surface : {calm_surface(Side::periodic), wavy_surface(Side::periodic)}) {
        const Difference d = difference(draw(surface, camera, 1), without);
        EXPECT_LT(d.most, 1e-3);
        EXPECT_LT(d.rms, 1e-4);
    }
    // The comparison sees water where it is.
    EXPECT_GT(difference(draw(calm_surface(Side::periodic), camera, 4.0 / 3.0), without).rms, 0.02);
}

TEST_F(PictureInvisible, WavesOfIndexOneBeforeAWall) {
    // The wall's lower part and the floor before it, without the waterline.
    Camera camera = camera_at({5.5, 3, 0.5}, {8, 3.1, -1.6}, {320, 240});
    camera.fov_deg = 35;
    const Radiance without = draw(above_the_camera(Side::wall), camera, 1);
    // Through water a pixel has one sight, of floor or wall; directly the samples tell the edge between them.
    const glm::dvec2 a = test::pixel_of(camera, {8, 2, -2}), b = test::pixel_of(camera, {8, 4, -2});
    const auto off_the_edge = [&](int i, int j) {
        return std::abs(j - a.y - (i - a.x) * (b.y - a.y) / (b.x - a.x)) > 1.5;
    };
    for (const Surface& surface : {calm_surface(Side::wall), wavy_surface(Side::wall)})
        EXPECT_LT(difference(draw(surface, camera, 1), without, off_the_edge).most, 1e-3);
}

}  // namespace
}  // namespace waterlight
