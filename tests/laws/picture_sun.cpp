// The sun in the water: from below it stands where Snell puts it with the power that Fresnel lets through; on waves its
// glint has, at any resolution, the power that their slopes send to the eye.
#include <functional>

#include "tests/support/picture_places.hpp"
#include "tests/support/render_scenes.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

constexpr double pi = std::numbers::pi, n = 4.0 / 3.0, e0 = 900;

/// What a picture holds of the sun: irradiance across the sight, and its centre.
struct Spot {
    double power = 0;
    glm::dvec2 centre{0, 0};
};

class PictureSun : public GpuTest {
  protected:
    Spot draw(const Surface& surface, const Sun& sun, const Camera& camera) {
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = 2;
        scene.sun = sun;
        Look look = plain_look(0);
        look.sky.irradiance_w_m2 = 0.0;
        look.exposure_w_m2_sr = 1e4;  // the disc is brighter than half floats hold in units of white
        SceneRenderer renderer(context);
        renderer.draw(scene, look, camera);
        const Radiance seen = renderer.read_radiance();
        const Camera::Rays rays = camera.rays();
        const double pixel = glm::length(rays.right) * glm::length(rays.up);
        Spot spot;
        for (int j = 0; j < camera.size.y; ++j)
            for (int i = 0; i < camera.size.x; ++i) {
                const double power = radiance_at(seen, i, j).y * pixel / std::pow(glm::length(rays.at(i, j)), 3);
                spot.power += power;
                spot.centre += power * glm::dvec2{i, j};
            }
        spot.centre /= spot.power;
        return spot;
    }
};

TEST_F(PictureSun, FromBelowIsWhereSnellPutsItAndAsBrightAsFresnelLetsIt) {
    const Surface surface = calm_surface(Side::periodic);
    for (const double elevation : {20.0, 50.0, 80.0}) {
        const Sun sun{.elevation_deg = elevation, .azimuth_deg = 30, .irradiance_w_m2 = e0};
        const glm::dvec3 s = sun.direction();
        const double sine = std::sqrt(1 - s.z * s.z), mu = std::sqrt(1 - sine * sine / (n * n));
        const glm::dvec3 towards{-s.x / n, -s.y / n, mu}, eye{4, 3, -1};
        // Half a degree across; 0.02 degrees a pixel; the picture's middle is a little beside it.
        Camera camera = camera_at(eye, eye + towards + glm::dvec3{0.01, 0.005, 0}, {201, 201});
        camera.fov_deg = 4;
        const Spot spot = draw(surface, sun, camera);
        const glm::dvec2 off = spot.centre - test::pixel_of(camera, eye + towards);
        EXPECT_LT(glm::length(off), 0.5) << "sun at " << elevation;
        EXPECT_NEAR(spot.power / (e0 * (1 - test::reflectance(sine, n)) * -s.z / mu), 1, 0.02)
            << "sun at " << elevation;
    }
}

constexpr double steepest = 0.08;  // along each axis
constexpr double wavelength = 0.5;

/// Crossing sines, shorter by far than the glint is wide.
Surface choppy() {
    const double amplitude = steepest * wavelength / (2 * pi);
    return test::sample(make_grid(256, 256, 8, 8), {Side::periodic, Side::periodic},
                        test::egg_crate(amplitude, wavelength));
}

/// Irradiance across the sight from facets of all slopes of crossing sines: each reflects E0 R, and of the surface in a
/// direction v it makes up its share times cos_i / (N_z v_z).
double glint_power(const Sun& sun) {
    constexpr int parts = 400;
    const glm::dvec3 l = -sun.direction();
    double sum = 0;
    for (int a = 0; a < parts; ++a)
        for (int b = 0; b < parts; ++b) {
            const double p = steepest * std::sin(2 * pi * (a + 0.5) / parts);
            const double q = steepest * std::sin(2 * pi * (b + 0.5) / parts);
            const glm::dvec3 normal = glm::normalize(glm::dvec3{-p, -q, 1});
            const double cos_i = glm::dot(l, normal);
            const glm::dvec3 v = 2 * cos_i * normal - l;
            sum += test::reflectance(std::sqrt(1 - cos_i * cos_i), n) * cos_i / (normal.z * v.z);
        }
    return e0 * sum / (parts * parts);
}

// From 60 m, where a wave is much shorter than the way on which the slope that mirrors the sun changes. A pixel is
// wider than a wave in the first picture and narrower than two cells in the last.
TEST_F(PictureSun, GlintOnWavesHasThePowerOfTheirSlopesAtAnyResolution) {
    const Surface surface = choppy();
    const Sun sun{.elevation_deg = 60, .azimuth_deg = 180, .irradiance_w_m2 = e0};
    const glm::dvec3 eye{4 + 60 / std::tan(60 * pi / 180), 4, 60};
    const double expected = glint_power(sun);
    for (const int rows : {40, 160, 640, 1080}) {
        Camera camera = camera_at(eye, {4, 4, 0}, {rows, rows});
        camera.fov_deg = 40;
        const double power = draw(surface, sun, camera).power;
        RecordProperty("power_ratio_at_" + std::to_string(rows), std::to_string(power / expected));
        EXPECT_NEAR(power / expected, 1, 0.05) << rows << " rows";
    }
}

}  // namespace
}  // namespace waterlight
