// Flat water in closed form at many angles, in three colours: what it reflects, what is seen through it on the floor
// and on a wall, and the light that it scatters once.
#include <functional>

#include "tests/support/picture_places.hpp"
#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

using std::numbers::pi;
using test::n_water;
constexpr double depth = 2, scattering = 0.08, absorption = 0.12, g = 0.7, wall_albedo = 0.6;
const glm::dvec3 colour{0.34, 0.06, 0.01};

/// One colour below flat water under a slanting sun.
struct Calm {
    double albedo, sky, added;  // of the floor; irradiance of the sky, W/m2; absorption by colour, 1/m
    Sun sun;

    double c() const { return absorption + scattering + added; }
    double sine() const { return std::cos(sun.elevation_deg * pi / 180); }
    double mu_s() const { return std::sqrt(1 - sine() * sine() / (n_water * n_water)); }
    /// The unit vector of the light in the water.
    glm::dvec3 light() const {
        const glm::dvec3 s = sun.direction();
        return {s.x / n_water, s.y / n_water, -mu_s()};
    }
    /// The sun's just below the surface, on a horizontal plane.
    double entering() const {
        return sun.irradiance_w_m2 * -sun.direction().z * (1 - test::reflectance(sine(), n_water));
    }
    double direct(double z) const { return entering() * std::exp(c() * z / mu_s()); }

    /// Diffuse light on the floor: the sky's, less what absorption takes on 1.2 times the depth, and the surface's
    /// returns of what the floor sends up, one after the other.
    double diffuse_on_floor() const {
        double r_ext = 0;
        constexpr int parts = 4000;
        for (int k = 0; k < parts; ++k) r_ext += test::reflectance(std::sqrt((k + 0.5) / parts), n_water) / parts;
        const double returned = 1 - (1 - r_ext) / (n_water * n_water),
                     passage = std::exp(-1.2 * (absorption + added) * depth);
        double sum = passage * (1 - r_ext) * sky, sent = direct(-depth) + sum;
        for (int k = 0; k < 60; ++k) {
            sent *= albedo * passage * passage * returned;
            sum += sent;
        }
        return sum;
    }
    double floor() const { return albedo / pi * (direct(-depth) + diffuse_on_floor()); }

    /// Scattered once towards the eye on the way from height z along d.
    double scattered(double z, glm::dvec3 d, double way) const {
        const double cosine = -glm::dot(light(), d);
        const double phase = (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
        const double kappa = c() * (1 - d.z / mu_s());
        return scattering * phase * direct(z) / mu_s() * (1 - std::exp(-kappa * way)) / kappa;
    }
    double through(double radiance, double z, glm::dvec3 d, double way) const {
        return radiance * std::exp(-c() * way) + scattered(z, d, way);
    }
};

glm::dvec3 refracted(glm::dvec3 d) {
    const glm::dvec2 level = glm::dvec2(d) / n_water;
    return {level, -std::sqrt(1 - glm::dot(level, level))};
}

class PictureCalm : public GpuTest {
  protected:
    using Law = std::function<double(const Calm&, glm::dvec3 d)>;

    Sun sun{.elevation_deg = 50, .azimuth_deg = 180, .irradiance_w_m2 = 900};
    double floor_albedo = 0.5, sky = 300, tolerance = 0.005;
    const WaterOptics optics{
        .refractive_index = n_water, .absorption_per_m = absorption, .scattering_per_m = scattering, .phase = {.g = g}};
    BeamVolume* volume = nullptr;
    BeamImage* beams = nullptr;

    Beams beams_of(const Surface& surface) const {
        BeamSettings settings;
        settings.grid = {64, 48};
        settings.depth_m = depth;
        settings.sun = sun;
        settings.optics = optics;
        Beams made;
        make_beams(settings, surface, made);
        return made;
    }

    /// Draws the scene and compares every pixel that `where` admits with the law, by colour.
    void expect_law(
        Side side, const Camera& camera, const Law& law,
        const std::function<bool(glm::dvec3)>& where = [](glm::dvec3) { return true; }) {
        const Surface surface = calm_surface(side);
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = depth;
        scene.sun = sun;
        scene.optics = optics;
        scene.volume = volume;
        scene.beams = beams;
        Look look = plain_look(floor_albedo);
        look.walls.albedo = glm::dvec3(wall_albedo);
        look.sky.irradiance_w_m2 = sky;
        look.colour_per_m = colour;
        SceneRenderer renderer(context);
        renderer.draw(scene, look, camera);
        const Radiance seen = renderer.read_radiance();
        const Camera::Rays rays = camera.rays();
        int pixels = 0;
        double worst = 0;
        for (int j = 0; j < camera.size.y; ++j)
            for (int i = 0; i < camera.size.x; ++i) {
                const glm::dvec3 d = glm::normalize(rays.at(i, j));
                if (!where(d)) continue;
                ++pixels;
                for (int k = 0; k < 3; ++k) {
                    const Calm calm{floor_albedo, sky, colour[k], sun};
                    worst = std::max(worst, std::abs(radiance_at(seen, i, j)[k] / law(calm, d) - 1));
                }
            }
        EXPECT_GE(pixels, 300);
        EXPECT_LT(worst, tolerance);
    }
};

double above(const Calm& calm, glm::dvec3 d) {
    const glm::dvec3 r = refracted(d);
    const double reflected = test::reflectance(std::sqrt(1 - d.z * d.z), n_water);
    const double below = calm.through(calm.floor(), 0, r, depth / -r.z);
    return reflected * calm.sky / pi + (1 - reflected) / (n_water * n_water) * below;
}

TEST_F(PictureCalm, FloorSeenFromAboveAtManyAngles) {
    for (const glm::dvec3 target : {glm::dvec3{4, 3, 0}, {7, 4, 0.5}, {3, 8, 1.2}})
        expect_law(Side::periodic, camera_at({4, 3, 3}, target, {33, 25}), above,
                   [](glm::dvec3 d) { return d.z < -0.05; });
}

// What a black floor sends up is nothing: the sky's mirror image and light from the water alone.
TEST_F(PictureCalm, WaterOverABlackFloor) {
    floor_albedo = 0;
    expect_law(Side::periodic, camera_at({4, 3, 3}, {6, 4, 0}, {33, 25}), above);
}

TEST_F(PictureCalm, TheSkyAlone) {
    sun.irradiance_w_m2 = 0;
    expect_law(Side::periodic, camera_at({4, 3, 3}, {6, 4, 0}, {33, 25}), above);
}

// No diffuse light: the floor is black and there is no sky, so that only the sun lights the wall.
TEST_F(PictureCalm, AWallSeenFromAbove) {
    floor_albedo = sky = 0;
    const Camera camera = camera_at({6, 3, 1.5}, {8, 3.2, -0.5}, {65, 49});
    const auto meeting = [&](glm::dvec3 d) {
        const glm::dvec3 eye = camera.position_m, r = refracted(d), at = eye - eye.z / d.z * d;
        return at + (8 - at.x) / r.x * r;
    };
    const auto on_wall = [&](glm::dvec3 d) {
        if (!(d.z < 0 && d.x > 0 && camera.position_m.x - camera.position_m.z / d.z * d.x < 7.8)) return false;
        const glm::dvec3 at = meeting(d);
        return at.z > -depth + 0.1 && at.y > 0.1 && at.y < 5.9;
    };
    const auto law = [&](const Calm& calm, glm::dvec3 d) {
        const glm::dvec3 r = refracted(d), at = meeting(d);
        const double irradiance = calm.direct(at.z) / calm.mu_s() * calm.light().x;
        const double below = calm.through(wall_albedo / pi * irradiance, 0, r, at.z / r.z);
        return (1 - test::reflectance(std::sqrt(1 - d.z * d.z), n_water)) / (n_water * n_water) * below;
    };
    expect_law(Side::wall, camera, law, on_wall);
}

// Down to the floor; up through Snell's window to the sky, and to the floor in the surface's mirror.
TEST_F(PictureCalm, SeenFromBelow) {
    constexpr double z = -0.8;
    const auto law = [](const Calm& calm, glm::dvec3 d) {
        if (d.z < 0) return calm.through(calm.floor(), z, d, (depth + z) / -d.z);
        const double reflected = test::reflectance(std::sqrt(1 - d.z * d.z), 1 / n_water);
        const double mirrored = calm.through(calm.floor(), 0, {d.x, d.y, -d.z}, depth / d.z);
        const double surface = n_water * n_water * (1 - reflected) * calm.sky / pi + reflected * mirrored;
        return calm.through(surface, z, d, -z / d.z);
    };
    // The sun itself, the window's edge and what is as good as level are seen by other tests.
    const auto where = [this](glm::dvec3 d) {
        const double sine = std::sqrt(1 - d.z * d.z);
        const Calm calm{floor_albedo, sky, 0, sun};
        return std::abs(d.z) > 0.05 && std::abs(n_water * sine - 1) > 0.01 && glm::dot(d, calm.light()) > -0.995;
    };
    for (const glm::dvec3 target : {glm::dvec3{5, 3, -0.2}, {5, 3.3, -1.3}, {4, 4, 0.5}, {2.5, 3, -0.8}})
        expect_law(Side::periodic, camera_at({4, 3, z}, target, {33, 25}), law, where);
}

// The fields of light that beams make take the place of the closed form: in five steps of a way and cells of 4 cm.
TEST_F(PictureCalm, LightOfAVolumeSeenFromAbove) {
    floor_albedo = sky = 0;
    tolerance = 0.02;
    BeamVolume filled;
    fill_volume(beams_of(calm_surface(Side::periodic)), {16, 12, 48}, filled);
    volume = &filled;
    expect_law(Side::periodic, camera_at({4, 3, 3}, {6, 4, 0}, {33, 25}), above);
}

// A picture of beams of half the size, enlarged and tinted.
TEST_F(PictureCalm, LightOfBeamsSeenFromBelow) {
    floor_albedo = sky = 0;
    tolerance = 0.02;
    constexpr double z = -0.3;
    for (const glm::dvec3 target : {glm::dvec3{5, 3, -1}, {3.5, 3.3, -1.3}}) {
        BeamImageSettings settings;
        settings.camera = camera_at({4, 3, z}, target, {66, 50});
        settings.optics = optics;
        BeamImage image;
        draw_beams(settings, beams_of(calm_surface(Side::periodic)), image);
        beams = &image;
        expect_law(
            Side::periodic, camera_at({4, 3, z}, target, {132, 100}),
            [](const Calm& calm, glm::dvec3 d) { return calm.scattered(z, d, (depth + z) / -d.z); },
            [](glm::dvec3 d) { return d.z < -0.2; });
    }
}

}  // namespace
}  // namespace waterlight
