// How far the sight through the surface moves from pixel to pixel, against differences of the sight itself.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "render/kernels/view_ray.hpp"

namespace waterlight {
namespace {

constexpr double step = 1e-6;

/// A ray and the slope that it meets, as functions of a pixel's number.
glm::dvec3 ray(double u) { return glm::normalize(glm::dvec3{0.6 + 0.3 * u, -0.2 + 0.5 * u, -0.7 + 0.1 * u}); }
glm::dvec2 slope(double u) { return {0.15 + 0.4 * u, -0.1 - 0.7 * u}; }
glm::dvec3 turn_d() { return (ray(step) - ray(-step)) / (2 * step); }
glm::dvec3 turn_normal() { return f64::turn_of_normal(f64::normal_of(slope(0)), {0.4, -0.7}); }

void expect_same(glm::dvec3 found, glm::dvec3 expected) {
    EXPECT_LT(glm::length(found - expected), 1e-8 * glm::length(expected));
}

TEST(PictureRays, ANormalTurnsAsItsSlopeChanges) {
    expect_same(turn_normal(), (f64::normal_of(slope(step)) - f64::normal_of(slope(-step))) / (2 * step));
}

TEST(PictureRays, RefractedAndReflectedRaysTurnAsTheirDifferencesSay) {
    for (const double n : {1.0, 4.0 / 3.0, 1.5}) {
        const auto refracted = [n](double u) {
            return f64::refract_ray(ray(u), f64::normal_of(slope(u)), n, 1).direction;
        };
        expect_same(f64::turn_refracted(ray(0), f64::normal_of(slope(0)), n, turn_d(), turn_normal()),
                    (refracted(step) - refracted(-step)) / (2 * step));
    }
    const auto reflected = [](double u) { return f64::reflect_ray(ray(u), f64::normal_of(slope(u))); };
    expect_same(f64::turn_reflected(ray(0), f64::normal_of(slope(0)), turn_d(), turn_normal()),
                (reflected(step) - reflected(-step)) / (2 * step));
}

TEST(PictureRays, NoMoreLightPassesThanThereIs) {
    for (int i = 0; i <= 2000; ++i)
        for (int k = 1; k <= 2000; ++k) {
            const float n = 1 + 2e-4F * static_cast<float>(k) / 2000, cosine = static_cast<float>(i) / 2000;
            const glm::vec3 d{std::sqrt(1 - cosine * cosine), 0, -cosine};
            const float through = f32::refract_ray(d, {0, 0, 1}, n, 1).transmittance;
            ASSERT_TRUE(through >= 0 && through <= 1) << through << " at n = " << n << ", cosine " << cosine;
        }
}

TEST(PictureRays, APlaceMovesOnItsPlaneAsItsRayTurns) {
    const glm::dvec3 eye{1, 2, 3}, normal = f64::normal_of({0.2, -0.3});
    const auto way = [&](double u) { return -glm::dot(eye, normal) / glm::dot(ray(u), normal); };
    const auto place = [&](double u) { return eye + way(u) * ray(u); };
    expect_same(f64::moved_onto(way(0) * turn_d(), ray(0), normal), (place(step) - place(-step)) / (2 * step));
}

/// The integral over the directions above (1) or below (-1) the water, by midpoints.
double over_directions(double side, const std::function<double(glm::dvec3)>& of) {
    constexpr int rings = 600, sectors = 1200;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double z = (i + 0.5) / rings, across = std::sqrt(1 - z * z);
            const double azimuth = 2 * std::numbers::pi * (j + 0.5) / sectors;
            sum += of({across * std::cos(azimuth), across * std::sin(azimuth), side * z});
        }
    return sum * 2 * std::numbers::pi / (rings * sectors);
}

// A level metre of rough water takes the sun's E0 sin(elevation), however rough, where no facet turns away from it. All
// of it goes on, in some direction, before reflectance and transmittance: radiance times the part that is seen adds up.
TEST(PictureRays, FacetsSendOnAllThatTheyTake) {
    const glm::dvec3 to_sun = glm::normalize(glm::dvec3{0.4, 0.2, 1});
    for (const double variance : {0.002, 0.02}) {
        const double reflected = over_directions(1, [&](glm::dvec3 to_eye) {
            return f64::sun_in_reflection(to_eye, to_sun, {0, 0}, variance, 0).radiance *
                   f64::visible_part(to_eye, {0, 0}, variance, 1);
        });
        EXPECT_NEAR(reflected / to_sun.z, 1, 2e-3) << "variance " << variance;
        constexpr double n = 4.0 / 3.0;
        const double refracted = over_directions(-1, [&](glm::dvec3 to_eye) {
            return n * n * f64::sun_in_refraction(to_eye, to_sun, {0, 0}, variance, 0, n).radiance *
                   f64::visible_part(to_eye, {0, 0}, variance, -1);
        });
        EXPECT_NEAR(refracted / to_sun.z, 1, 2e-3) << "variance " << variance;
    }
}

}  // namespace
}  // namespace waterlight
