// Pictures of the shaft that a ball leaves dark, and of what it hides: in still water the light that a ray gathers is
// that of its way less the part in the shadow, in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "caustics/beam_image.hpp"
#include "caustics/kernels/phase.hpp"
#include "sim/error.hpp"
#include "tests/support/shadow_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

constexpr double absorption = .1, scattering = .05, extinction = absorption + scattering;

/// Metres of a ray.
struct Span {
    double from, to;
};

/// Where |a + t b| <= reach.
std::optional<Span> within(glm::dvec3 a, glm::dvec3 b, double reach) {
    const double bb = glm::dot(b, b), ab = glm::dot(a, b), root = ab * ab - bb * (glm::dot(a, a) - reach * reach);
    if (!(root > 0)) return std::nullopt;
    return Span{(-ab - std::sqrt(root)) / bb, (-ab + std::sqrt(root)) / bb};
}

/// Still water of 12 x 12 x 3 m, seen steeply from within, with a ball in it or above.
struct Shaft {
    glm::dvec3 centre;
    double radius = .4;
    ShadowPool pool;
    BeamImageSettings image;
    glm::dvec3 sun, light;  ///< ways, unit
    double path;            ///< of light in the water per metre of descent

    explicit Shaft(glm::dvec3 at, double elevation_deg) : centre(at) {
        pool.beams.grid = {90, 80};
        pool.beams.depth_m = 3;
        pool.beams.sun = {elevation_deg, 30, 1};
        pool.beams.optics.absorption_per_m = absorption;
        pool.beams.optics.scattering_per_m = scattering;
        pool.beams.objects = objects_of({ball(radius, centre)});
        image.optics = pool.beams.optics;
        image.objects = pool.beams.objects;
        image.camera = {{4.5, 4.3, -1}, {6.2, 5.9, -2.6}, 55, {120, 90}};
        sun = pool.beams.sun.direction();
        path = pool.light().path;
        light = glm::dvec3{pool.light().travel, -1} / path;
    }

    BeamImage picture(bool with_ball) const {
        BeamSettings s = pool.beams;
        BeamImageSettings look = image;
        if (!with_ball) {
            s.objects = nullptr;
            look.objects = nullptr;
        }
        Beams beams;
        make_beams(s, sample(make_grid(48, 48, 12, 12), {Side::absorbing, Side::absorbing}, flat), beams);
        BeamImage out;
        draw_beams(look, beams, out);
        return out;
    }

    glm::dvec3 ray(int i, int j) const { return glm::normalize(image.camera.rays().at(i, j)); }
    double to_floor(glm::dvec3 r) const { return (3 + image.camera.position_m.z) / -r.z; }
    /// Where a place's light comes through the surface, and its way from the ball's middle there, across the sun's
    /// rays; of a ball in the water across its light. Linear in the place.
    glm::dvec3 across(glm::dvec3 place) const {
        glm::dvec3 way = light;
        if (centre.z > 0) {
            place += place.z * path * light;
            way = sun;
        }
        const glm::dvec3 off = place - centre;
        return off - glm::dot(off, way) * way;
    }
    /// The ray's part in the cylinder of the shadow, before and behind the ball.
    std::optional<Span> in_cylinder(glm::dvec3 r, double radius_m) const {
        const glm::dvec3 a = across(image.camera.position_m), b = across(image.camera.position_m + r) - a;
        return within(a, b, radius_m);
    }

    struct Law {
        double lit = 0;   ///< of all the way
        double dark = 0;  ///< of that in the shadow or behind the ball
        bool hidden = false;
    };
    Law law(int i, int j) const {
        const glm::dvec3 eye = image.camera.position_m, r = ray(i, j);
        const double kappa = extinction * (1 - r.z * path);
        const double source = scattering * f64::henyey_greenstein(.9, -glm::dot(light, r)) * pool.entering() * path *
                              std::exp(extinction * eye.z * path);
        const auto gathered = [&](double from, double to) {
            return source * (std::exp(-kappa * from) - std::exp(-kappa * to)) / kappa;
        };
        const double end = to_floor(r);
        Law l{gathered(0, end), 0, false};
        double seen = end;
        const auto met = within(eye - centre, r, radius);
        if (met && centre.z < 0 && met->from > 0) {
            seen = std::min(seen, met->from);
            l.hidden = true;
            l.dark = gathered(seen, end);
        }
        auto shadow = in_cylinder(r, radius);
        if (!shadow) return l;
        shadow->from = std::clamp(shadow->from, 0.0, seen);
        shadow->to = std::clamp(shadow->to, 0.0, seen);
        // A ray that does not meet the ball passes the cylinder on one side of it.
        const glm::dvec3 middle = eye + (l.hidden ? seen : .5 * (shadow->from + shadow->to)) * r;
        if (centre.z > 0 || glm::dot(middle - centre, light) > 0) l.dark += gathered(shadow->from, shadow->to);
        return l;
    }
};

class ShadowPictures : public testing::TestWithParam<double> {};

TEST_P(ShadowPictures, TheShaftIsDarkByTheLawOfSingleScattering) {
    for (const glm::dvec3 centre : {glm::dvec3{5.8, 5.6, -1.7}, glm::dvec3{5.8, 5.6, .9}}) {
        Shaft shaft(centre, GetParam());
        if (centre.z > 0) {
            // So that its shadow is in the picture.
            shaft.centre += glm::dvec3{.9 / shaft.sun.z * glm::dvec2(shaft.sun) - 1.7 * shaft.pool.light().travel, 0};
            shaft.pool.beams.objects = objects_of({ball(shaft.radius, shaft.centre)});
            shaft.image.objects = shaft.pool.beams.objects;
        }
        const BeamImage with = shaft.picture(true), without = shaft.picture(false);
        double most = 0, sum = 0, dark = 0;
        int shaded = 0, hidden = 0, untouched = 0;
        const double beam = std::hypot(12.0 / 90, 12.0 / 80) * 1.5;
        for (int j = 0; j < 90; ++j)
            for (int i = 0; i < 120; ++i) {
                const glm::dvec3 r = shaft.ray(i, j);
                if (r.z > -.25) continue;
                const Shaft::Law law = shaft.law(i, j);
                const double error = (with.radiance(i, j) - (law.lit - law.dark)) / law.lit;
                most = std::max(most, std::abs(error));
                sum += error * law.lit;
                dark += law.dark;
                shaded += law.dark > .1 * law.lit && !law.hidden ? 1 : 0;
                hidden += law.hidden ? 1 : 0;
                if (law.hidden || shaft.in_cylinder(r, shaft.radius + beam)) continue;
                EXPECT_EQ(with.radiance(i, j), without.radiance(i, j)) << i << " " << j;
                ++untouched;
            }
        RecordProperty("largest_error_percent_" + std::to_string(centre.z), std::to_string(100 * most));
        RecordProperty("error_of_darkness_percent_" + std::to_string(centre.z), std::to_string(100 * sum / dark));
        EXPECT_LT(most, 1e-2) << "of the ray's light without the ball";
        EXPECT_LT(std::abs(sum) / dark, 3e-3) << "in all";
        EXPECT_GT(shaded, 300);
        EXPECT_GT(untouched, 300);
        EXPECT_EQ(hidden > 300, centre.z < 0) << hidden;
    }
}

INSTANTIATE_TEST_SUITE_P(Suns, ShadowPictures, testing::Values(90.0, 50.0), elevation_of);

TEST(ShadowPicture, ABallHidesWhatIsBehindItThoughItsShadowIsElsewhere) {
    // Only the camera knows of it.
    Shaft shaft({5.8, 5.6, -1.7}, 60);
    shaft.pool.beams.objects = nullptr;
    const BeamImage with = shaft.picture(true), without = shaft.picture(false);
    int hidden = 0;
    for (int j = 0; j < 90; ++j)
        for (int i = 0; i < 120; ++i) {
            if (!shaft.law(i, j).hidden) {
                // Rays are cut in blocks, which rounds.
                EXPECT_NEAR(with.radiance(i, j) / without.radiance(i, j), 1, 2e-6);
                continue;
            }
            EXPECT_LT(with.radiance(i, j), .9 * without.radiance(i, j));
            ++hidden;
        }
    EXPECT_GT(hidden, 300);
}

TEST(ShadowPicture, ObjectsRepeatBeyondPeriodicSidesAsBeamsDo) {
    ShadowPool pool;
    pool.beams.optics.absorption_per_m = absorption;
    pool.beams.optics.scattering_per_m = scattering;
    BeamImageSettings image;
    image.optics = pool.beams.optics;
    image.range_m = 14;
    // The same ball by the same camera, a period apart.
    BeamImage pictures[2];
    for (int k = 0; k < 2; ++k) {
        pool.beams.objects = image.objects = objects_of({ball(.3, {2.5, 1.5, -1})});
        image.camera = {{1.23 - 4 * k, 1.37 + 3 * k, -.8}, {2.2 - 4 * k, 1.5 + 3 * k, -.9}, 60, {80, 60}};
        draw_beams(image, pool.made(), pictures[k]);
    }
    double error = 0, all = 0;
    for (std::size_t i = 0; i < pictures[0].radiance.size(); ++i) {
        error += std::abs(pictures[0].radiance.data()[i] - pictures[1].radiance.data()[i]);
        all += pictures[0].radiance.data()[i];
    }
    EXPECT_LT(error / all, 1e-3);
}

TEST(ShadowPicture, ACameraInAnObjectIsRefused) {
    Shaft shaft({5.8, 5.6, -1.7}, 60);
    shaft.image.camera.position_m = {5.9, 5.5, -1.8};
    EXPECT_THROW(shaft.picture(true), InputError);
}

}  // namespace
}  // namespace waterlight
