// What lies under a pixel: rays against water of known form.
#include "render/pick.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using glm::dvec2;
using glm::dvec3;

const Grid pool = make_grid(96, 64, 6, 4);
const Camera over_pool{.position_m = {-1, -2, 3}, .target_m = {3, 2, 0}, .size = {300, 200}};
const Camera under_water{.position_m = {1, 1, -1.2}, .target_m = {4, 2.5, 0.1}, .size = {300, 200}};
const Camera down_on_pool{.position_m = {3, 2, 5}, .target_m = {3, 2, 0}, .size = {300, 200}};

Surface sampled(const test::Formula& formula) { return test::sample(pool, {Side::wall, Side::wall}, formula); }

bool is_within(dvec2 at) {
    return at.x >= pool.x0_m && at.y >= pool.y0_m && at.x <= pool.x0_m + pool.width_m() &&
           at.y <= pool.y0_m + pool.height_m();
}

/// Every twentieth pixel.
template <class Check>
void for_pixels(const Camera& camera, Check check) {
    for (int j = 0; j < camera.size.y; j += 20)
        for (int i = 0; i < camera.size.x; i += 20) check(dvec2(i, j));
}

TEST(PickWater, FindsATiltedPlaneInClosedForm) {
    for (const dvec2 slope : {dvec2(0, 0), dvec2(0.1, 0), dvec2(-0.04, 0.07)}) {
        const Surface surface = sampled(test::tilted(slope));
        for (const Camera& camera : {over_pool, under_water, down_on_pool}) {
            int hits = 0, misses = 0;
            for_pixels(camera, [&](dvec2 pixel) {
                const dvec3 ray = camera.rays().at(pixel.x, pixel.y), from = camera.position_m;
                const double t = (glm::dot(slope, dvec2(from)) - from.z) / (ray.z - glm::dot(slope, dvec2(ray)));
                const dvec3 expected = from + t * ray;
                const auto found = pick_water(surface, camera, pixel);
                const bool exists = t > 0 && is_within(dvec2(expected));
                ASSERT_EQ(found.has_value(), exists) << pixel.x << ' ' << pixel.y;
                if (exists) {
                    EXPECT_LT(glm::distance(*found, expected), 1e-6);
                }
                ++(exists ? hits : misses);
            });
            EXPECT_GT(hits, 20);
            EXPECT_GT(misses, 0);
        }
    }
}

// The nearest place of the ray at which it is in the formula's surface, by steps a hundredth of a cell long.
std::optional<dvec3> first_meeting(const test::Formula& formula, const Camera& camera, dvec2 pixel) {
    const dvec3 ray = glm::normalize(camera.rays().at(pixel.x, pixel.y));
    const auto height = [&](double t) {
        const dvec3 p = camera.position_m + t * ray;
        return p.z - formula(dvec2(p)).elevation_m;
    };
    const double step = 0.01 * pool.dx_m;
    for (double t = 0; t < 15; t += step)
        if ((height(t) > 0) != (height(t + step) > 0)) return camera.position_m + (t + 0.5 * step) * ray;
    return std::nullopt;
}

TEST(PickWater, FindsTheNearestPlaceOfASine) {
    const test::Formula formula = test::sines({{0.08, 1.2, 30}});
    const Surface surface = sampled(formula);
    // Bilinear heights err by a (k dx)^2 / 4 at most on the diagonal of a cell, and grazing rays stretch that.
    const double k = 2 * std::numbers::pi / 1.2, error = 0.08 * k * k * pool.dx_m * pool.dx_m / 4 + 0.01 * pool.dx_m;
    for (const Camera& camera : {over_pool, under_water}) {
        int hits = 0;
        for_pixels(camera, [&](dvec2 pixel) {
            const auto expected = first_meeting(formula, camera, pixel);
            if (!expected || !is_within(dvec2(*expected))) return;
            const dvec3 normal = glm::normalize(dvec3(-formula(dvec2(*expected)).slope, 1));
            const double grazing = std::abs(glm::dot(normal, glm::normalize(camera.rays().at(pixel.x, pixel.y))));
            if (grazing < 0.2) return;  // past a crest or just not: which is a matter of rounding
            const auto found = pick_water(surface, camera, pixel);
            ASSERT_TRUE(found) << pixel.x << ' ' << pixel.y;
            EXPECT_LT(glm::distance(*found, *expected), error / grazing) << pixel.x << ' ' << pixel.y;
            ++hits;
        });
        EXPECT_GT(hits, 20);
    }
}

TEST(PickWater, LooksPastWaterThatIsBehind) {
    Camera away = over_pool;
    away.target_m = 2.0 * over_pool.position_m - over_pool.target_m;
    for_pixels(away, [&](dvec2 pixel) { EXPECT_FALSE(pick_water(sampled(test::flat), away, pixel)); });
}

TEST(PickLevel, MeetsAHeightAheadOnly) {
    const auto found = pick_level(0.5, down_on_pool, {149.5, 99.5});
    ASSERT_TRUE(found);
    EXPECT_LT(glm::distance(*found, dvec3(3, 2, 0.5)), 1e-12);
    EXPECT_FALSE(pick_level(6, down_on_pool, {149.5, 99.5}));
    EXPECT_FALSE(pick_level(1, {.position_m = {0, 0, 0}, .target_m = {1, 0, 0}, .size = {3, 3}}, {1, 1}));
}

}  // namespace
}  // namespace waterlight
