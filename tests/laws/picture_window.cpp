// Snell's window: from below, all of the sky is within arcsin(1/n) of the vertical, brighter by n^2, and beyond it the
// surface is a mirror.
#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

/// Unpolarised transmittance from water into air at the sine of the angle in water, by Fresnel's two amplitudes.
double transmittance_up(double sine, double n) {
    const double in = std::sqrt(1 - sine * sine), out = std::sqrt(1 - n * n * sine * sine);
    const double s = (n * in - out) / (n * in + out), p = (in - n * out) / (in + n * out);
    return 1 - 0.5 * (s * s + p * p);
}

class PictureWindow : public GpuTest {
  protected:
    static constexpr double sky_w_m2 = 300;

    struct View {
        Camera camera = camera_at({4, 3, -1}, {5, 3, -0.1}, {9, 900});
        std::vector<double> radiance;
        /// Sine of the angle from the vertical.
        double sine(double row) const {
            const glm::dvec3 d = glm::normalize(camera.rays().at(0.5 * (camera.size.x - 1), row));
            return std::sqrt(1 - d.z * d.z);
        }
    };

    /// The middle column of a picture from below, of a uniform sky over a floor of the given albedo.
    View view_up(double n, double floor_albedo, glm::dvec3 target = {5, 3, -0.1}) {
        View view;
        view.camera.target_m = target;
        view.camera.fov_deg = 80;
        const Surface surface = calm_surface(Side::absorbing);
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = 2;
        scene.sun.irradiance_w_m2 = 0;
        scene.optics.refractive_index = n;
        Look look = plain_look(floor_albedo);
        look.sky.irradiance_w_m2 = sky_w_m2;
        SceneRenderer renderer(context);
        renderer.draw(scene, look, view.camera);
        const Radiance seen = renderer.read_radiance();
        for (int j = 0; j < view.camera.size.y; ++j) view.radiance.push_back(radiance_at(seen, 4, j).x);
        return view;
    }
};

TEST_F(PictureWindow, EndsAtTheCriticalAngle) {
    for (const double n : {4.0 / 3.0, 1.2, 1.5}) {
        const View view = view_up(n, 0);
        int edge = 0;  // the lowest row that sees the sky
        while (view.radiance[static_cast<std::size_t>(edge)] == 0) ++edge;
        EXPECT_GT(view.sine(edge - 1.5) * n, 1) << "n = " << n;
        EXPECT_LT(view.sine(edge + 1.0) * n, 1) << "n = " << n;
    }
}

TEST_F(PictureWindow, ShowsTheSkyBrighterByTheSquareOfTheIndex) {
    for (const double n : {4.0 / 3.0, 1.5}) {
        const View view = view_up(n, 0);
        const double sky = sky_w_m2 / std::numbers::pi;
        int checked = 0;
        for (int row = 0; row < view.camera.size.y; row += 25) {
            const double sine = view.sine(row);
            if (sine > 0.97 / n) continue;
            const double expected = n * n * transmittance_up(sine, n) * sky;
            EXPECT_NEAR(view.radiance[static_cast<std::size_t>(row)] / expected, 1, 0.005) << "row " << row;
            ++checked;
        }
        EXPECT_GE(checked, 5);
    }
}

// Beyond the window the floor is seen in a perfect mirror: a plain floor is as bright there as where it is seen itself.
TEST_F(PictureWindow, IsSurroundedByTheMirroredFloor) {
    const View up = view_up(4.0 / 3.0, 0.6), down = view_up(4.0 / 3.0, 0.6, {4.5, 3, -2});
    const double floor = down.radiance[450];
    ASSERT_GT(floor, 0);
    int mirrored = 0;
    for (int row = 0; row < up.camera.size.y; ++row) {
        if (up.camera.rays().at(4, row).z <= 0 || up.sine(row) < 0.76 || up.sine(row) > 0.99) continue;
        EXPECT_NEAR(up.radiance[static_cast<std::size_t>(row)] / floor, 1, 1e-3) << "row " << row;
        ++mirrored;
    }
    EXPECT_GE(mirrored, 100);
}

}  // namespace
}  // namespace waterlight
