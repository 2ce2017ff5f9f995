// The sun in the water: from below it stands where Snell puts it with the power that Fresnel lets through; on waves its
// glint has, at any resolution, the power that their slopes send to the eye.
#include <functional>

#include "tests/support/picture_places.hpp"
#include "tests/support/render_scenes.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using std::numbers::pi;
using test::n_water;
constexpr double e0 = 900;

/// What a picture holds of the sun: irradiance across the sight, and its centre.
struct Spot {
    double power = 0;
    glm::dvec2 centre{0, 0};
};

class PictureSun : public GpuTest {
  protected:
    Spot draw(const Surface& surface, const Sun& sun, const Camera& camera, double depth_m = 2) {
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = depth_m;
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
        const double sine = std::sqrt(1 - s.z * s.z), mu = std::sqrt(1 - sine * sine / (n_water * n_water));
        const glm::dvec3 towards{-s.x / n_water, -s.y / n_water, mu}, eye{4, 3, -1};
        // Half a degree across; 0.02 degrees a pixel; the picture's middle is a little beside it.
        Camera camera = camera_at(eye, eye + towards + glm::dvec3{0.01, 0.005, 0}, {201, 201});
        camera.fov_deg = 4;
        const Spot spot = draw(surface, sun, camera);
        const glm::dvec2 off = spot.centre - test::pixel_of(camera, eye + towards);
        EXPECT_LT(glm::length(off), 0.5) << "sun at " << elevation;
        EXPECT_NEAR(spot.power / (e0 * (1 - test::reflectance(sine, n_water)) * -s.z / mu), 1, 0.02)
            << "sun at " << elevation;
    }
}

constexpr double wavelength = 0.5;

/// Crossing sines of slopes up to `steepest` along each axis, shorter by far than the sun's image on them is wide.
Surface choppy(double steepest) {
    const double amplitude = steepest * wavelength / (2 * pi);
    return test::sample(make_grid(256, 256, 8, 8), {Side::periodic, Side::periodic},
                        test::egg_crate(amplitude, wavelength));
}

/// The mean over the slopes of crossing sines.
double mean_over_slopes(double steepest, const std::function<double(glm::dvec3 normal)>& of) {
    constexpr int parts = 400;
    double sum = 0;
    for (int a = 0; a < parts; ++a)
        for (int b = 0; b < parts; ++b) {
            const double p = steepest * std::sin(2 * pi * (a + 0.5) / parts);
            const double q = steepest * std::sin(2 * pi * (b + 0.5) / parts);
            sum += of(glm::normalize(glm::dvec3{-p, -q, 1}));
        }
    return sum / (parts * parts);
}

/// Irradiance across the sight from facets of all slopes: each takes E0 cos_i / N_z of a piece of level surface and
/// sends R of it in a direction v, across which the piece is v_z as wide.
double glint_power(const Sun& sun, double steepest) {
    const glm::dvec3 l = -sun.direction();
    return e0 * mean_over_slopes(steepest, [&](glm::dvec3 normal) {
               const double cos_i = glm::dot(l, normal), v_z = 2 * cos_i * normal.z - l.z;
               return test::reflectance(std::sqrt(1 - cos_i * cos_i), n_water) * cos_i / (normal.z * v_z);
           });
}

/// The same of what they let into the water.
double shine_power(const Sun& sun, double steepest) {
    const glm::dvec3 s = sun.direction();
    return e0 * mean_over_slopes(steepest, [&](glm::dvec3 normal) {
               const double cos_i = -glm::dot(s, normal), sine = std::sqrt(1 - cos_i * cos_i);
               const double fall =
                   -(s.z / n_water + (cos_i / n_water - std::sqrt(1 - sine * sine / (n_water * n_water))) * normal.z);
               return (1 - test::reflectance(sine, n_water)) * cos_i / (normal.z * fall);
           });
}

// From 60 m, where a wave is much shorter than the way on which the slope that mirrors the sun changes. A pixel is
// wider than a wave in the first picture and narrower than two cells in the last.
TEST_F(PictureSun, GlintOnWavesHasThePowerOfTheirSlopesAtAnyResolution) {
    const Surface surface = choppy(0.08);
    const Sun sun{.elevation_deg = 60, .azimuth_deg = 180, .irradiance_w_m2 = e0};
    const glm::dvec3 eye{4 + 60 / std::tan(60 * pi / 180), 4, 60};
    const double expected = glint_power(sun, 0.08);
    for (const int rows : {40, 160, 640, 1080}) {
        Camera camera = camera_at(eye, {4, 4, 0}, {rows, rows});
        camera.fov_deg = 40;
        const double power = draw(surface, sun, camera).power;
        RecordProperty("power_ratio_at_" + std::to_string(rows), std::to_string(power / expected));
        EXPECT_NEAR(power / expected, 1, 0.05) << rows << " rows";
    }
}

TEST_F(PictureSun, SeenThroughWavesHasThePowerThatTheyLetInAtAnyResolution) {
    const Sun sun{.elevation_deg = 60, .azimuth_deg = 180, .irradiance_w_m2 = e0};
    const double tangent = 0.5 / std::sqrt(n_water * n_water - 0.25);  // of the angle in flat water
    const glm::dvec3 eye{4 + 60 * tangent, 4, -60};
    // What facets hide of each other and show of themselves is known to 10 % (render/kernels/view_ray.glsl): of steep
    // waves as much as that.
    for (const auto& [steepest, tolerance] : {std::pair{0.08, 0.02}, {0.25, 0.1}}) {
        const Surface surface = choppy(steepest);
        const double expected = shine_power(sun, steepest);
        for (const int rows : {40, 160, 640}) {
            // The image is a few waves wide, and pixels half a wave would see them in step: from places over a wave.
            constexpr int places = 16;
            double power = 0;
            for (int k = 0; k < places; ++k) {
                const glm::dvec3 aside{wavelength * k / places, wavelength * (5 * k % places) / places, 0};
                Camera camera = camera_at(eye + aside, glm::dvec3{4, 4, 0} + aside, {rows, rows});
                camera.fov_deg = 35;
                power += draw(surface, sun, camera, 80).power / places;
            }
            RecordProperty("through_" + std::to_string(steepest) + "_at_" + std::to_string(rows),
                           std::to_string(power / expected));
            EXPECT_NEAR(power / expected, 1, tolerance) << rows << " rows, slopes up to " << steepest;
        }
    }
}

}  // namespace
}  // namespace waterlight
