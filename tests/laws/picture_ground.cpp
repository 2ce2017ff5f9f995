// Pictures over uneven ground: beams and rays end there. In flat water the light that a ray gathers depends only on its
// way to the ground, in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "caustics/beam_image.hpp"
#include "caustics/kernels/optics.hpp"
#include "caustics/kernels/phase.hpp"
#include "sim/error.hpp"
#include "tests/support/sloping_pool.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

constexpr double absorption = .1, scattering = .05, extinction = absorption + scattering;

/// Flat water 10 m long under a slanting sun, over a plane that rises along x and y.
struct FlatSlope {
    SlopingPool pool;
    BeamSettings settings;
    Beams beams;
    BeamImageSettings image;

    FlatSlope() {
        settings.grid = {48, 48};
        settings.depth_m = 4;
        settings.sun = {60, 30, 1};
        settings.optics.absorption_per_m = absorption;
        settings.optics.scattering_per_m = scattering;
        // Beyond absorbing sides the water and its light go on.
        const Surface surface = sample(make_grid(40, 40, 10, 10), {Side::absorbing, Side::absorbing}, flat);
        make_beams(settings, surface, beams);
        pool.end(beams);
        image.optics = settings.optics;
        image.camera = {{3, 3, -1}, {6, 5, -2}, 40, {90, 60}};
    }

    /// L = b p(angle) E_n exp(-c d0 / mu_s) (1 - exp(-kappa S)) / kappa, kappa = c (1 + mu / mu_s), S the way to the
    /// ground.
    double law(int i, int j) const {
        const glm::dvec3 eye = image.camera.position_m, r = glm::normalize(image.camera.rays().at(i, j));
        const double rate = r.z - glm::dot(pool.slope, glm::dvec2(r));
        const double way = rate < 0 ? (pool.height(glm::dvec2(eye)) - eye.z) / rate : -eye.z / r.z;
        const f64::Refraction f = f64::refract_sun(settings.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const glm::dvec3 light = glm::dvec3{f.travel.x, f.travel.y, -1} / f.path;
        const double kappa = extinction * (1 - r.z * f.path);
        return scattering * f64::henyey_greenstein(.9, -glm::dot(light, r)) * f.incident * f.transmittance * f.path *
               std::exp(extinction * eye.z * f.path) * (1 - std::exp(-kappa * way)) / kappa;
    }

    /// Largest relative error of the rays that go down and whose water is lit from the domain all the way.
    double worst() const {
        BeamImage picture;
        draw_beams(image, beams, picture);
        double most = 0;
        for (int j = 0; j < 25; ++j)
            for (int i = 0; i < 90; ++i) most = std::max(most, std::abs(picture.radiance(i, j) / law(i, j) - 1));
        return most;
    }
};

TEST(PictureGround, BeamsEndOnTheGround) {
    // The rays themselves go on to the deepest floor: only the beams' lids end the light.
    EXPECT_LT(FlatSlope().worst(), 5e-3);
}

TEST(PictureGround, RaysEndOnTheGround) {
    // The beams go on to the deepest floor: only the rays' ends end the light.
    FlatSlope scene;
    make_beams(scene.settings, sample(make_grid(40, 40, 10, 10), {Side::absorbing, Side::absorbing}, flat),
               scene.beams);
    scene.image.ground = scene.pool.ground();
    EXPECT_LT(scene.worst(), 5e-3);
}

TEST(PictureGround, BothEndThere) {
    FlatSlope scene;
    scene.image.ground = scene.pool.ground();
    EXPECT_LT(scene.worst(), 5e-3);
}

TEST(PictureGround, WithoutEitherTheLightGoesOn) {
    FlatSlope scene;
    make_beams(scene.settings, sample(make_grid(40, 40, 10, 10), {Side::absorbing, Side::absorbing}, flat),
               scene.beams);
    EXPECT_GT(scene.worst(), 0.05) << "what the other tests see";
}

TEST(PictureGround, TheFirstMeetingIsFound) {
    // Steps of .3 m over a plane: t is exact to a thousandth of them.
    const SlopingPool pool;
    const Camera camera{{3, 3, -1}, {6, 5, -2}, 40, {30, 20}};
    PictureGround ground = pool.ground();
    ground.step_m = .3;
    const Field<float> reach = ground_reach(camera, ground, 50);
    for (int j = 0; j < 20; ++j)
        for (int i = 0; i < 30; ++i) {
            const glm::dvec3 r = camera.rays().at(i, j), eye = camera.position_m;
            const double rate = r.z - glm::dot(pool.slope, glm::dvec2(r)), range = 50 / glm::length(r);
            const double t = rate < 0 ? (pool.height(glm::dvec2(eye)) - eye.z) / rate : range;
            EXPECT_NEAR(reach(i, j), std::min(t, range), 5e-4) << i << " " << j;
        }
}

TEST(PictureGround, ACameraInTheGroundIsRefused) {
    FlatSlope scene;
    scene.image.ground = scene.pool.ground();
    scene.image.camera.position_m = {9, 9, -3};
    BeamImage picture;
    EXPECT_THROW(draw_beams(scene.image, scene.beams, picture), InputError);
}

}  // namespace
}  // namespace waterlight
