// Beams of reflected light above the water: energy, the closed form of a picture, and the focus over a trough.
#include <gtest/gtest.h>

#include "caustics/beam_image.hpp"
#include "caustics/beam_point.hpp"
#include "caustics/beam_volume.hpp"
#include "caustics/kernels/optics.hpp"
#include "caustics/kernels/phase.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

TEST(ReflectedLight, LeavesUnderTheAngleAtWhichItCame) {
    for (const glm::dvec2 slope : {glm::dvec2{0, 0}, {.1, -.2}, {-.3, .05}}) {
        for (const double elevation : {90.0, 40.0, 20.0}) {
            const glm::dvec3 s = Sun{elevation, 70, 1}.direction();
            const glm::dvec3 normal = glm::normalize(glm::dvec3{-slope, 1});
            const f64::Refraction out = f64::reflect_sun(s, slope, 4.0 / 3, 1);
            const f64::Refraction in = f64::refract_sun(s, slope, 4.0 / 3, 1);
            const glm::dvec3 r = glm::dvec3{out.travel.x, out.travel.y, 1} / out.path;
            EXPECT_NEAR(glm::length(r), 1, 1e-12);
            EXPECT_NEAR(glm::dot(r, normal), -glm::dot(s, normal), 1e-12);
            EXPECT_NEAR(glm::dot(glm::cross(r, s), normal), 0, 1e-12) << "in the plane of incidence";
            EXPECT_NEAR(out.transmittance + in.transmittance, 1, 1e-14);
        }
    }
    EXPECT_EQ(f64::reflect_sun(Sun{10, 0, 1}.direction(), {.3, 0}, 4.0 / 3, 1).path, 0) << "down to other water";
}

TEST(ReflectedBeams, WithTheRefractedTheyCarryAllThatCame) {
    const Surface surface = sample(make_grid(128, 128, 2, 2), periodic, egg_crate(.004, .5));
    for (const double elevation : {90.0, 45.0, 15.0, 3.0}) {
        BeamSettings s;
        s.grid = {60, 50};
        s.sun = {elevation, 25, 1};
        Beams in, out, all;
        make_beams(s, surface, in);
        make_reflected_beams(s, surface, out);
        s.optics.fresnel = false;
        make_beams(s, surface, all);
        EXPECT_LT(out.ledger.closure(), 1e-12);
        EXPECT_NEAR(out.ledger.incident_w / in.ledger.incident_w, 1, 1e-12);
        int pairs = 0;
        for (std::size_t i = 0; i < all.flux.size(); ++i) {
            if (!(out.flux.data()[i] > 0)) continue;
            EXPECT_NEAR((in.flux.data()[i] + out.flux.data()[i]) / all.flux.data()[i], 1, 1e-5);
            ++pairs;
        }
        EXPECT_GT(pairs, 100);
        if (elevation < 10) continue;  // where some light leaves below the horizon
        EXPECT_EQ(out.ledger.discarded_w, 0);
        EXPECT_NEAR((in.ledger.floor_w + out.ledger.floor_w) / in.ledger.incident_w, 1, 1e-6) << elevation;
    }
}

TEST(ReflectedBeams, CarryTheirFluxThroughEveryHeight) {
    const Surface surface = sample(make_grid(128, 128, 2, 2), periodic, egg_crate(.004, .5));
    for (const double elevation : {90.0, 30.0}) {
        BeamSettings s;
        s.grid = {80, 70};
        s.depth_m = 3;
        s.sun = {elevation, 25, 1};
        Beams beams;
        make_reflected_beams(s, surface, beams);
        BeamVolume volume;
        fill_volume(beams, {32, 32, 24}, volume);
        for (const SliceLedger& slice : volume.ledger) {
            EXPECT_NEAR(slice.flux_w / (beams.ledger.incident_w - beams.ledger.reflected_w), 1, 1e-6);
            EXPECT_NEAR(slice.inside_w / slice.flux_w, 1, 1e-9);
        }
    }
}

TEST(ReflectedBeams, ATroughFocusesThemAndACrestSpreadsThem) {
    // Over a trough of a cos kx the light meets at 1 / (2 a k2) above its bottom: a mirror of radius 1 / (a k2).
    const double a = .01, wave = .5, k = 2 * std::numbers::pi / wave, curvature = a * k * k;
    const Surface surface = sample(make_grid(2048, 4, wave, .1), periodic, sines({{a, wave, 0}}));
    BeamSettings s;
    s.grid = {2048, 4};
    s.depth_m = 1;
    s.sun = {90, 0, 1};
    Beams beams;
    make_reflected_beams(s, surface, beams);
    const double reflectance = 1 - f64::refract_sun({0, 0, -1}, {0, 0}, 4.0 / 3, 1).transmittance;
    const auto at = [&](double x, double height) { return irradiance_at(beams, {x, .031, -height}).plane_w_m2; };
    for (const double height : {.05, .1, .2, .25}) {
        EXPECT_NEAR(at(.25 + 1e-6, height) / (reflectance / (1 - (height + a) * 2 * curvature)), 1, 2e-3) << height;
        EXPECT_NEAR(at(1e-6, height) / (reflectance / (1 + (height - a) * 2 * curvature)), 1, 2e-3) << height;
    }
    double brightest = 0, focus = 0;
    for (double height = .2; height < .4; height += .0005) {
        const double e = at(.25 + 1e-6, height);
        if (e > brightest) focus = height;
        brightest = std::max(brightest, e);
    }
    RecordProperty("focus_m", std::to_string(focus));
    EXPECT_NEAR(focus, 1 / (2 * curvature) - a, 1e-3);
    EXPECT_GT(brightest, 50 * reflectance);
}

/// Flat water under air that scatters, b = .02, a = .01, Henyey & Greenstein g = .7.
TEST(ReflectedBeams, OverFlatWaterThePictureIsTheClosedForm) {
    for (const double elevation : {90.0, 40.0}) {
        const Boundary open{Side::absorbing, Side::absorbing};
        const Surface surface = sample(make_grid(40, 40, 10, 10), open, flat);
        BeamSettings s;
        s.grid = {64, 64};
        s.depth_m = 6;
        s.sun = {elevation, 30, 1};
        s.optics.absorption_per_m = .01;
        s.optics.scattering_per_m = .02;
        s.optics.phase.g = .7;
        Beams beams;
        make_reflected_beams(s, surface, beams);
        BeamImageSettings picture;
        picture.optics = s.optics;
        Camera camera{{5, 5, 2}, {6.5, 5.3, .8}, 25, {31, 21}};
        picture.camera = mirrored(camera);
        BeamImage image;
        draw_beams(picture, beams, image);
        const glm::dvec3 sun = s.sun.direction();
        const f64::Refraction f = f64::reflect_sun(sun, {0, 0}, 4.0 / 3, 1);
        const glm::dvec3 light{sun.x, sun.y, -sun.z};
        const double across = f.incident * f.transmittance * f.path;
        for (const int i : {0, 15, 30}) {
            for (const int j : {0, 10, 20}) {
                // Down to the water: the light there is 2 m of height younger, so that kappa = c (1 + cos / sin el).
                const glm::dvec3 r = glm::normalize(camera.rays().at(i, j));
                ASSERT_LT(r.z, 0);
                const double way = -2 / r.z, kappa = .03 * (1 + r.z * f.path);
                const double law = .02 * f64::henyey_greenstein(.7, -glm::dot(light, r)) * across *
                                   std::exp(-.03 * 2 * f.path) * (1 - std::exp(-kappa * way)) / kappa;
                EXPECT_NEAR(image.radiance(i, j) / law, 1, 5e-3) << i << " " << j << " " << elevation;
            }
        }
    }
}

TEST(MirroredCamera, SeesTheMirroredWorldPixelByPixel) {
    for (const glm::dvec3 target : {glm::dvec3{4, 3, 1}, {1, 2, 0}, {-1, 2, 9}}) {
        const Camera camera{{1, 2, 3}, target, 40, {9, 7}};
        const Camera::Rays own = camera.rays(), other = mirrored(camera).rays();
        EXPECT_EQ(mirrored(camera).position_m.z, -3);
        for (const int i : {0, 8})
            for (const int j : {0, 6}) EXPECT_LT(glm::length(Camera::flipped(own.at(i, j)) - other.at(i, j)), 1e-15);
        EXPECT_EQ(mirrored(mirrored(camera)).rays().forward, own.forward);
    }
}

}  // namespace
}  // namespace waterlight
