// Flat water: a pixel's radiance in closed form, in three colours, with sun, sky, absorption and scattering.
#include "tests/support/render_scenes.hpp"
#include "tests/support/water_optics.hpp"

namespace waterlight {
namespace {

using namespace test;

/// The model of docs/pictures.md, one colour of it.
struct CalmColour {
    double n = 4.0 / 3.0;
    double sun_e0 = 900, sun_elevation = 50 * radian;
    double sky = 0;         // irradiance, uniform
    double absorption = 0;  // of the field and of the colour
    double scattering = 0, g = 0.9;
    double albedo = 0.5, depth = 2;
    double lit = 1;  // part of the floor that sunlight reaches past the rims of walls

    double extinction() const { return absorption + scattering; }
    double sun_cos_above() const { return std::sin(sun_elevation); }
    double sun_cos() const { return std::sqrt(1 - std::pow(std::cos(sun_elevation) / n, 2)); }
    /// On a horizontal plane, `below` metres under the surface.
    double sun_at(double below) const {
        const double entering = sun_e0 * sun_cos_above() * (1 - reflected_part(sun_cos_above(), 1, n));
        return entering * std::exp(-extinction() * below / sun_cos());
    }
    /// Horizontal metres of sunlight's way for each metre down.
    glm::dvec2 sun_travel(double azimuth) const {
        return -glm::dvec2{std::cos(azimuth), std::sin(azimuth)} * (std::cos(sun_elevation) / n / sun_cos());
    }
    double passage(double length) const { return std::exp(-1.2 * absorption * length); }
    /// Of the sky and of what the floor sends up and the surface throws back, bounce by bounce.
    double diffuse_on_floor() const {
        const double thrown_back = diffusely_reflected_part(n, 1);
        double light = passage(depth) * (1 - diffusely_reflected_part(1, n)) * sky, sum = light;
        double up = albedo * (lit * sun_at(depth) + light);
        for (int bounce = 0; bounce < 60; ++bounce) {
            light = passage(depth) * thrown_back * passage(depth) * up;
            sum += light;
            up = albedo * light;
        }
        return sum;
    }
    double floor_radiance() const { return albedo * (sun_at(depth) + diffuse_on_floor()) / pi; }
    /// `facing`: cosine between the wall's normal and the sunlight in the water, where it is lit.
    double wall_radiance(double below, double facing) const {
        const double down = diffuse_on_floor() / passage(depth - below);
        const double up = albedo * (lit * sun_at(depth) + diffuse_on_floor()) * passage(depth - below);
        return albedo * (sun_at(below) / sun_cos() * facing + 0.5 * (down + up)) / pi;
    }
    /// Scattered once towards the eye along `way` metres of sight that goes down by `sight_cos` per metre; `cosine`
    /// between the light's way and the light's to the eye. Henyey & Greenstein.
    double scattered(double way, double sight_cos, double cosine) const {
        const double phase = (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
        const double kappa = extinction() * (1 + sight_cos / sun_cos());
        return scattering * phase * sun_at(0) / sun_cos() * (1 - std::exp(-kappa * way)) / kappa;
    }
};

class PictureRadiance : public GpuTest {
  protected:
    double azimuth = 40 * radian;
    static constexpr glm::dvec3 colour{0.3, 0.06, 0.01};
    CalmColour calm;
    Look look = plain_look(0.5);
    Scene scene;

    void draw_and_expect(const Surface& surface, const Camera& camera, bool wall) {
        scene.surface = &surface;
        scene.depth_m = calm.depth;
        scene.sun = {calm.sun_elevation / radian, azimuth / radian, calm.sun_e0};
        scene.optics.refractive_index = calm.n;
        scene.optics.absorption_per_m = calm.absorption;
        scene.optics.scattering_per_m = calm.scattering;
        scene.optics.phase.g = calm.g;
        look.floor.albedo = look.walls.albedo = glm::dvec3(calm.albedo);
        look.sky.irradiance_w_m2 = calm.sky;
        look.colour_per_m = colour;
        SceneRenderer renderer(context);
        renderer.draw(scene, look, camera);
        const Radiance seen = renderer.read_radiance();
        const Pinhole pinhole(camera);
        for (const glm::ivec2 at : {glm::ivec2{32, 32}, {5, 32}, {60, 50}, {32, 3}})
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(radiance_at(seen, at.x, at.y)[c] / expected(pinhole, at, c, wall), 1, 0.005)
                    << at.x << " " << at.y << ", colour " << c;
    }

    /// Of the pixel `at` of a camera above the water, of the floor or the wall y = 6.
    double expected(const Pinhole& pinhole, glm::ivec2 at, int c, bool wall) const {
        CalmColour m = calm;
        m.absorption += colour[c];
        const glm::dvec2 unlit = glm::abs(m.sun_travel(azimuth)) * m.depth / glm::dvec2(8, 6);
        if (wall) m.lit = (1 - unlit.x) * (1 - unlit.y);
        const glm::dvec3 d = pinhole.direction(at.x, at.y);
        const double reflected = reflected_part(-d.z, 1, m.n);
        const glm::dvec3 from = pinhole.eye + d * (pinhole.eye.z / -d.z);
        const glm::dvec2 across = glm::dvec2(d) / m.n;
        const glm::dvec3 in_water{across, -std::sqrt(1 - glm::dot(across, across))};
        const double way = wall ? (6 - from.y) / in_water.y : m.depth / -in_water.z;
        const glm::dvec3 light = m.sun_cos() * glm::dvec3(m.sun_travel(azimuth), -1);
        EXPECT_GT(way, 0) << "in the water";
        EXPECT_LT(-in_water.z * way, m.depth + 1e-9) << "before the floor";
        const double met = wall ? m.wall_radiance(-in_water.z * way, std::max(0.0, light.y)) : m.floor_radiance();
        const double from_below =
            met * std::exp(-m.extinction() * way) + m.scattered(way, -in_water.z, glm::dot(light, -in_water));
        return (1 - reflected) / (m.n * m.n) * from_below + reflected * m.sky / pi;
    }
};

TEST_F(PictureRadiance, TheFloorInSunAndSky) {
    calm.sky = 250;
    calm.absorption = 0.1;
    calm.albedo = 0.8;
    draw_and_expect(calm_surface(Side::periodic), camera_at({4, 1, 3}, {5, 3, -1}, {65, 65}), false);
    calm.n = 1.5;
    draw_and_expect(calm_surface(Side::periodic), camera_at({4, 3, 4}, {4.5, 3, -1}, {65, 65}), false);
}

TEST_F(PictureRadiance, TheFloorThroughTurbidWater) {
    calm.sky = 150;
    calm.absorption = 0.05;
    calm.scattering = 0.4;
    for (const double g : {0.0, 0.6, 0.9}) {
        calm.g = g;
        draw_and_expect(calm_surface(Side::periodic), camera_at({4, 1, 3}, {5, 3, -1}, {65, 65}), false);
    }
}

TEST_F(PictureRadiance, DeepWaterIsItsScatteredLight) {
    calm.scattering = 0.3;
    calm.absorption = 0.1;
    calm.g = 0.5;
    calm.depth = 60;
    draw_and_expect(calm_surface(Side::periodic), camera_at({4, 1, 3}, {5, 3, -1}, {65, 65}), false);
}

TEST_F(PictureRadiance, AWallInSunSkyAndTurbidWater) {
    Camera camera = camera_at({4, 1.5, 2}, {3.8, 6, -0.45}, {65, 65});
    camera.fov_deg = 8;
    calm.sky = 250;
    calm.absorption = 0.1;
    draw_and_expect(calm_surface(Side::wall), camera, true);  // its back to the sun
    calm.scattering = 0.2;
    draw_and_expect(calm_surface(Side::wall), camera, true);
}

TEST_F(PictureRadiance, AWallThatTheSunShinesOn) {
    Camera camera = camera_at({4, 1.5, 2}, {3.8, 6, -0.45}, {65, 65});
    camera.fov_deg = 8;
    calm.sky = 250;
    calm.absorption = 0.1;
    calm.scattering = 0.1;
    azimuth = -130 * radian;
    draw_and_expect(calm_surface(Side::wall), camera, true);
}

}  // namespace
}  // namespace waterlight
