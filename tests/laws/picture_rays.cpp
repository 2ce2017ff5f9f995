// How far the sight through the surface moves from pixel to pixel, against differences of the sight itself.
#include <gtest/gtest.h>

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
            return f64::refract_sight(ray(u), f64::normal_of(slope(u)), n, 1).direction;
        };
        expect_same(f64::turn_refracted(ray(0), f64::normal_of(slope(0)), n, turn_d(), turn_normal()),
                    (refracted(step) - refracted(-step)) / (2 * step));
    }
    const auto reflected = [](double u) { return f64::reflect_sight(ray(u), f64::normal_of(slope(u))); };
    expect_same(f64::turn_reflected(ray(0), f64::normal_of(slope(0)), turn_d(), turn_normal()),
                (reflected(step) - reflected(-step)) / (2 * step));
}

TEST(PictureRays, APlaceMovesOnItsPlaneAsItsRayTurns) {
    const glm::dvec3 eye{1, 2, 3}, normal = f64::normal_of({0.2, -0.3});
    const auto way = [&](double u) { return -glm::dot(eye, normal) / glm::dot(ray(u), normal); };
    const auto place = [&](double u) { return eye + way(u) * ray(u); };
    expect_same(f64::moved_onto(way(0) * turn_d(), ray(0), normal), (place(step) - place(-step)) / (2 * step));
}

}  // namespace
}  // namespace waterlight
