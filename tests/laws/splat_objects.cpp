// Caustics mapping of glass, mirrors and what is opaque.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include "caustics/truth.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/splat_maps.hpp"

namespace waterlight {
namespace {

using namespace test;

using std::numbers::pi;
constexpr double radius = 0.3, index = 1.5;
const Grid pool = make_grid(16, 16, 2, 2);

/// A sphere in the middle of still water without refraction of its own, its centre this far above the floor.
SplatSettings ball(Material material, double above_floor_m, int pixels, int vertices) {
    SplatSettings s = splat_settings(pool, pixels, pixels, 90);
    s.floor.optics.refractive_index = 1;
    s.floor.depth_m = 1;
    s.options.grid = vertices;
    s.floor.objects = std::make_shared<ObjectSet>(std::vector<Object>{
        {.name = "ball", .shape = Sphere{radius}, .material = material, .centre_m = {1, 1, above_floor_m - 1}}});
    return s;
}

double fresnel_reflectance(double cos_i, double cos_t, double n) {
    const double s = (cos_i - n * cos_t) / (cos_i + n * cos_t), p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    return 0.5 * (s * s + p * p);
}

/// Power (W, for 1000 W/m2) that falls within each ring of the floor below a glass sphere, by rays in the plane of the
/// axis: reflected outside, through, and reflected once and twice within. Textbook formulas, no code of ours.
std::vector<double> rings_below_glass(double above_floor_m, double ring_m, int rings) {
    std::vector<double> power(rings);
    const auto add = [&](double r, double w) {
        const int k = static_cast<int>(std::floor(r / ring_m));
        if (k < rings) power[k] += w;
    };
    constexpr int rays = 400000;
    for (int n = 0; n < rays; ++n) {
        const double b = radius * (n + 0.5) / rays, light = 1000 * 2 * pi * b * radius / rays;
        const double i = std::asin(b / radius), t = std::asin(b / radius / index);
        const double reflected = fresnel_reflectance(std::cos(i), std::cos(t), index);
        // After p parts of its way inside it leaves so far around the sphere from the top, and goes on at the angle i
        // to the normal there.
        for (int p = 0; p <= 8; ++p) {
            const double at = i + p * (pi - 2 * t), heading = at + i;
            const double share = p == 0 ? reflected : (1 - reflected) * (1 - reflected) * std::pow(reflected, p - 1);
            const double x = radius * std::sin(at), z = above_floor_m + radius * std::cos(at);
            const double dx = std::sin(heading), dz = std::cos(heading);
            if (dz >= 0) continue;
            add(std::abs(x + dx * z / -dz), share * light);
        }
    }
    // Beside the sphere light comes straight.
    for (int k = 0; k < rings; ++k) {
        const double inner = std::max(radius, k * ring_m), outer = std::max(radius, (k + 1) * ring_m);
        power[k] += 1000 * pi * (outer * outer - inner * inner);
    }
    return power;
}

std::vector<double> rings_of(const SplatSettings& s, const FloorMap& map, double ring_m, int rings) {
    std::vector<double> power(rings);
    const double area = s.floor.plan.pitch_m.x * s.floor.plan.pitch_m.y;
    constexpr int parts = 8;  // of a pixel along each axis
    for (int j = 0; j < s.floor.plan.height; ++j)
        for (int i = 0; i < s.floor.plan.width; ++i)
            for (int b = 0; b < parts; ++b)
                for (int a = 0; a < parts; ++a) {
                    const glm::dvec2 at = s.floor.plan.position_m({i + (a + .5) / parts, j + (b + .5) / parts});
                    const int k = static_cast<int>(glm::length(at - glm::dvec2{1, 1}) / ring_m);
                    if (k < rings) power[k] += map.irradiance(i, j) * area / (parts * parts);
                }
    return power;
}

// Floor before the focus (n R / (2 (n - 1)) = 0.45 m from the centre), at it and behind it. Outside the focus and the
// rim of the shadow, where the profile jumps, rings agree to 3 % or half a per cent of the sun's light; within the
// focus the power up to each radius does.
TEST(SplatObjects, AGlassSphereFocusesAsRaysInItsPlaneDo) {
    constexpr double ring = 0.02;
    constexpr int rings = 40;
    for (const double above : {0.36, 0.45, 0.6}) {
        const SplatSettings s = ball({.type = Material::Type::glass, .index = index}, above, 200, 700);
        const FloorMap map = splat_map(s, sample(pool, walls, flat));
        const std::vector<double> found = rings_of(s, map, ring, rings),
                                  expected = rings_below_glass(above, ring, rings);
        double found_sum = 0, expected_sum = 0, square = 0, worst_sum = 0;
        int compared = 0;
        for (int k = 0; k < rings; ++k) {
            found_sum += found[k];
            expected_sum += expected[k];
            worst_sum = std::max(worst_sum, std::abs(found_sum - expected_sum) / (1000 * pi * radius * radius));
            const double r = (k + .5) * ring, per_w = 1 / (2 * pi * r * ring);
            if (k < 3 || std::abs(r - radius) < 1.5 * ring) continue;
            EXPECT_NEAR(found[k] * per_w, expected[k] * per_w, 5 + 0.03 * expected[k] * per_w) << above << " " << r;
            square += std::pow(found[k] / expected[k] - 1, 2);
            ++compared;
        }
        std::printf(
            "floor %.2f m below the centre: rings outside the focus to %.2g %% (rms), power within radii to "
            "%.2g %% of the sphere's\n",
            above, 100 * std::sqrt(square / compared), 100 * worst_sum);
        EXPECT_LT(worst_sum, 0.02) << above;
        EXPECT_LT(map.ledger.closure(), 1e-5);
        EXPECT_NEAR(map.ledger.incident_w, 4000, 1e-6);
        EXPECT_LT(map.ledger.lost_w, 2e-4 * 4000);
    }
}

TEST(SplatObjects, AnOpaqueBallTakesItsDiscOfLightAndTheFloorIsDark) {
    const SplatSettings s = ball({.type = Material::Type::diffuse}, 0.5, 100, 800);
    const FloorMap map = splat_map(s, sample(pool, walls, flat));
    EXPECT_NEAR(map.ledger.objects_w, 1000 * pi * radius * radius, 0.01 * 1000 * pi * radius * radius);
    EXPECT_EQ(map.irradiance(50, 50), 0);
    EXPECT_NEAR(map.irradiance(10, 50), 1000, 1);
    EXPECT_NEAR(map.ledger.floor_w, 4000 - map.ledger.objects_w, 1e-3 * 4000);
    EXPECT_LT(map.ledger.closure(), 1e-6);
}

// A mirror ball sends down what it meets beyond 45 degrees, half of its disc; the rest goes up.
TEST(SplatObjects, AMirrorBallSendsHalfOfItsLightUp) {
    const SplatSettings s = ball({.type = Material::Type::mirror, .reflectance = 0.9}, 0.5, 100, 800);
    const FloorMap map = splat_map(s, sample(pool, walls, flat));
    const double disc = 1000 * pi * radius * radius;
    EXPECT_NEAR(map.ledger.objects_w, 0.1 * disc, 0.01 * 0.1 * disc);
    EXPECT_NEAR(map.ledger.reflected_w + map.ledger.outside_w + map.ledger.floor_w, 4000 - 0.1 * disc, 1e-3 * 4000);
    const double down = map.ledger.floor_w - (4000 - disc);
    EXPECT_GT(down, 0.1 * disc);
    EXPECT_LT(down, 0.45 * disc) << "some of it goes to the walls";
    EXPECT_LT(map.ledger.closure(), 1e-6);
}

// What does not touch the light changes nothing: a ball of the water's own index.
TEST(SplatObjects, InvisibleGlassLeavesTheMapOfTheWaterAlone) {
    const Surface surface = sample(make_grid(128, 128, 1, 1), {}, egg_crate(.004, .5));
    SplatSettings s = splat_settings(surface.grid, 64, 64, 70);
    s.options.grid = 128;
    const FloorMap alone = splat_map(s, surface);
    s.floor.objects =
        std::make_shared<ObjectSet>(std::vector<Object>{{.name = "ghost",
                                                         .shape = Sphere{0.2},
                                                         .material = {.type = Material::Type::glass, .index = 4.0 / 3},
                                                         .centre_m = {.5, .5, -.5}}});
    const FloorMap with = splat_map(s, surface);
    Field<double> expected(64, 64);
    for (std::size_t k = 0; k < expected.size(); ++k) expected.data()[k] = alone.irradiance.data()[k];
    const double rmse = relative_rmse(with.irradiance, expected);
    std::printf("traced against the lattice on the water: relative RMSE %.3g %%\n", 100 * rmse);
    EXPECT_LT(rmse, 0.02);
    EXPECT_NEAR(with.ledger.floor_w, alone.ledger.floor_w, 2e-3 * alone.ledger.floor_w);
    EXPECT_LT(with.ledger.closure(), 1e-6);
}

TEST(SplatObjects, EachSideKeepsItsAccountAndTheBytesDoNotDependOnThreads) {
    for (const Boundary sides : {Boundary{}, walls, Boundary{Side::absorbing, Side::periodic}}) {
        const Surface surface = sample(make_grid(64, 64, 2, 2), sides, egg_crate(.01, .5));
        SplatSettings s = ball({.type = Material::Type::glass, .index = 1.5, .absorption_per_m = 0.2}, 0.7, 60, 60);
        s.floor.sun.elevation_deg = 45;
        s.floor.optics = {};
        s.floor.optics.absorption_per_m = 0.1;
        for (const bool lamp : {false, true}) {
            if (lamp) s.lamp = Lamp{.at_m = {0.7, 0.9, 2}};
            omp_set_num_threads(1);
            const FloorMap one = splat_map(s, surface);
            omp_set_num_threads(3);
            const FloorMap three = splat_map(s, surface);
            omp_set_num_threads(omp_get_num_procs());
            EXPECT_LT(one.ledger.closure(), 1e-5);
            EXPECT_GT(one.ledger.objects_w, 0);
            EXPECT_GT(one.ledger.floor_w, 0.2 * one.ledger.incident_w);
            EXPECT_EQ(
                0, std::memcmp(one.irradiance.data(), three.irradiance.data(), sizeof(float) * one.irradiance.size()));
        }
    }
}

}  // namespace
}  // namespace waterlight
