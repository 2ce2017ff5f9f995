// Shapes of the ground: exact heights, slopes, how they combine, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "sim/bathymetry.hpp"
#include "sim/error.hpp"

namespace waterlight::testing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The height at a place over a flat floor at -depth_m.
double height(const GroundShape& shape, glm::dvec2 at_m, double depth_m) {
    return ground_with(shape, at_m, -depth_m, depth_m);
}

/// The rise per metre along x and y, by central differences, which are exact on a plane.
glm::dvec2 slope(const GroundShape& shape, glm::dvec2 at_m, double depth_m) {
    const double h = 1e-3;
    const auto along = [&](glm::dvec2 step) {
        return (height(shape, at_m + step, depth_m) - height(shape, at_m - step, depth_m)) / (2 * h);
    };
    return {along({h, 0}), along({0, h})};
}

/// The island of Briggs et al. (1995): 7.2 m across its toe, 2.2 m across its crest, 1:4, in 0.32 m of water.
TEST(GroundShapes, ConicalIsland) {
    const GroundShape island{
        ConeGround{.at_m = {12.96, 13.8}, .toe_radius_m = 3.6, .crest_radius_m = 1.1, .height_m = 0.625}};
    EXPECT_DOUBLE_EQ(height(island, {12.96, 13.8}, 0.32), 0.305);
    EXPECT_DOUBLE_EQ(height(island, {12.96 + 1.0999, 13.8}, 0.32), 0.305);
    EXPECT_EQ(height(island, {12.96 + 3.6001, 13.8}, 0.32), -0.32);
    EXPECT_NEAR(height(island, {12.96, 13.8 - 2.32}, 0.32), 0, 1e-14) << "the shore at rest";
    for (const double angle : {0.0, 0.7, 2.0, 4.5}) {
        const glm::dvec2 out{std::cos(angle), std::sin(angle)};
        const glm::dvec2 rise = slope(island, glm::dvec2{12.96, 13.8} + 2.0 * out, 0.32);
        EXPECT_NEAR(rise.x, -0.25 * out.x, 1e-7);
        EXPECT_NEAR(rise.y, -0.25 * out.y, 1e-7);
    }
}

TEST(GroundShapes, ConeWithoutCrestAndCylinder) {
    const GroundShape cone{ConeGround{.toe_radius_m = 2, .height_m = 1}};
    EXPECT_DOUBLE_EQ(height(cone, {0, 0}, 3), -2);
    EXPECT_DOUBLE_EQ(height(cone, {0, 1}, 3), -2.5);
    const GroundShape cylinder{ConeGround{.toe_radius_m = 2, .crest_radius_m = 2, .height_m = 1}};
    EXPECT_EQ(height(cylinder, {0, 2}, 3), -2);
    EXPECT_EQ(height(cylinder, {0, 2.001}, 3), -3);
}

/// SWASHES (Delestre et al. 2013): z = max(0, 0.2 - 0.05 (x - 10)^2), here with still water 2 m above z = 0.
TEST(GroundShapes, SteadyBump) {
    const GroundShape bump{BumpGround{.at_m = {10, 0}, .half_width_m = {2, infinity}, .height_m = 0.2}};
    for (const double x : {0.0, 7.9, 8.0, 8.3, 9.0, 10.0, 11.75, 12.0, 13.0, 25.0}) {
        for (const double y : {-3.0, 0.0, 1e6}) {
            const double published = std::max(0.0, 0.2 - 0.05 * (x - 10) * (x - 10));
            EXPECT_NEAR(height(bump, {x, y}, 2), published - 2, 4e-16);
        }
    }
}

TEST(GroundShapes, TurnedAndGaussianBumps) {
    const GroundShape ridge{
        BumpGround{.at_m = {1, 1}, .half_width_m = {2, infinity}, .direction_deg = 30, .height_m = 0.4}};
    const glm::dvec2 across{std::cos(std::numbers::pi / 6), std::sin(std::numbers::pi / 6)};
    const glm::dvec2 along{-across.y, across.x};
    EXPECT_NEAR(height(ridge, glm::dvec2{1, 1} + across + 5.0 * along, 1), 0.3 - 1, 1e-14);
    const GroundShape oval{BumpGround{.half_width_m = {1, 2}, .direction_deg = 90, .height_m = 1}};
    EXPECT_EQ(height(oval, {1, 0}, 0), 0.75);
    EXPECT_EQ(height(oval, {0, 1}, 0), 0);
    const GroundShape smooth{BumpGround{.half_width_m = {2, 2}, .height_m = 3, .profile = BumpProfile::gaussian},
                             Combine::add};
    EXPECT_DOUBLE_EQ(height(smooth, {2, 0}, 1), 3 * std::exp(-1.0) - 1);
}

/// Thacker's bowl: z = -h0 (1 - r^2 / a^2).
TEST(GroundShapes, Bowl) {
    const GroundShape bowl{BowlGround{.at_m = {2, 2}, .radius_m = 1, .depth_m = 0.1}};
    EXPECT_EQ(height(bowl, {2, 2}, 0.1), -0.1);
    EXPECT_EQ(height(bowl, {3, 2}, 0.1), 0);
    EXPECT_NEAR(height(bowl, {2.6, 2.8}, 0.1), 0, 1e-16);
    EXPECT_DOUBLE_EQ(height(bowl, {4, 4}, 0.1), -0.1 * (1 - 8));
    const glm::dvec2 rise = slope(bowl, {2.3, 1.6}, 0.1);
    EXPECT_NEAR(rise.x, 2 * 0.1 * 0.3, 1e-12);
    EXPECT_NEAR(rise.y, 2 * 0.1 * -0.4, 1e-12);
}

TEST(GroundShapes, PlaneAndBeach) {
    const GroundShape plane{PlaneGround{.at_m = {1, 2}, .slope = {0.1, -0.05}, .level_m = -0.2}};
    EXPECT_DOUBLE_EQ(height(plane, {3, 6}, 10), -0.2);
    EXPECT_DOUBLE_EQ(height(plane, {11, 2}, 10), 0.8);
    const GroundShape beach{BeachGround{.at_m = {5, 0}, .direction_deg = 90, .slope = 0.05}};
    EXPECT_EQ(height(beach, {100, -1}, 1), -1);
    EXPECT_EQ(height(beach, {-100, 0}, 1), -1);
    EXPECT_DOUBLE_EQ(height(beach, {7, 20}, 1), 0);
    const glm::dvec2 rise = slope({BeachGround{.direction_deg = 30, .slope = 0.2}}, {3, 3}, 1);
    EXPECT_NEAR(rise.x, 0.2 * std::sqrt(3) / 2, 1e-12);
    EXPECT_NEAR(rise.y, 0.1, 1e-12);
}

TEST(GroundShapes, StepAndBlock) {
    const GroundShape cliff{StepGround{.at_m = {4, 0}, .direction_deg = 180, .height_m = 3}};
    EXPECT_EQ(height(cliff, {4, 7}, 1), 2);
    EXPECT_EQ(height(cliff, {3.9, -7}, 1), 2);
    EXPECT_EQ(height(cliff, {4.001, 0}, 1), -1);
    const GroundShape block{BlockGround{.at_m = {1, 1}, .size_m = {4, 2}, .direction_deg = 90, .height_m = 0.5}};
    EXPECT_EQ(height(block, {2, 3}, 1), -0.5) << "its corner";
    EXPECT_EQ(height(block, {2.001, 3}, 1), -1);
    EXPECT_EQ(height(block, {3, 1}, 1), -1) << "it is turned";
}

TEST(GroundShapes, Combine) {
    const BlockGround block{.size_m = {2, 2}, .height_m = 0.5};
    EXPECT_EQ(ground_with({block, Combine::max}, {0, 0}, -0.2, 1), -0.2) << "the ground stands out already";
    EXPECT_EQ(ground_with({block, Combine::min}, {0, 0}, -0.2, 1), -0.5);
    EXPECT_EQ(ground_with({block, Combine::add}, {0, 0}, -0.2, 1), 0.3);
    EXPECT_EQ(ground_with({block, Combine::max, 2.0}, {0, 0}, -0.2, 1), 2.5);
    EXPECT_EQ(ground_with({block, Combine::max, 2.0}, {5, 0}, -0.2, 1), -0.2) << "no ground beside the block";
    EXPECT_EQ(ground_with({block, Combine::min, -9.0}, {5, 0}, -0.2, 1), -0.2);
    const GroundShape pit{ConeGround{.toe_radius_m = 1, .height_m = -2}, Combine::min};
    EXPECT_EQ(height(pit, {0, 0}, 1), -3);
    EXPECT_EQ(ground_with({PlaneGround{.level_m = 0.25}, Combine::add}, {3, 3}, -0.5, 1), -0.25);
}

TEST(GroundShapes, MakeTheGroundInTheirOrder) {
    Bathymetry bathymetry;
    bathymetry.depth_m = 2;
    const Grid grid = make_grid(4, 2, 4, 2);
    EXPECT_EQ(ground_heights(bathymetry, grid)(3, 1), -2);
    bathymetry.shapes = {{StepGround{.at_m = {2, 0}, .height_m = 3}},
                         {BlockGround{.at_m = {2, 0}, .size_m = {2, 2}, .height_m = -1}, Combine::add}};
    const Field<double> heights = ground_heights(bathymetry, grid);
    const double expected[2][4] = {{-2, -3, 0, 1}, {-2, -2, 1, 1}};
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 4; ++i) EXPECT_EQ(heights(i, j), expected[j][i]) << i << ", " << j;
    }
}

std::string complaint(const GroundShape& shape) {
    try {
        require_valid(shape);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(GroundShapes, NameWhatIsOutOfRange) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(complaint({ConeGround{.toe_radius_m = -1}}), "cone: toe_radius_m must be above 0, found -1");
    EXPECT_EQ(complaint({ConeGround{.toe_radius_m = 2, .crest_radius_m = 3}}),
              "cone: crest_radius_m must be in [0, toe_radius_m = 2], found 3");
    EXPECT_EQ(complaint({ConeGround{.crest_radius_m = none}}),
              "cone: crest_radius_m must be in [0, toe_radius_m = 1], found nan");
    EXPECT_EQ(complaint({ConeGround{.height_m = none}}), "cone: height_m must be a finite number, found nan");
    EXPECT_EQ(complaint({BumpGround{.half_width_m = {2, 0}}}),
              "bump: half_width_m must be above 0 or infinite, found 0");
    EXPECT_EQ(complaint({BumpGround{.at_m = {infinity, 0}}}), "bump: at_m must be a finite number, found inf");
    EXPECT_EQ(complaint({BowlGround{.radius_m = 0}}), "bowl: radius_m must be above 0, found 0");
    EXPECT_EQ(complaint({PlaneGround{.slope = {0, none}}}), "plane: slope must be a finite number, found nan");
    EXPECT_EQ(complaint({BeachGround{.slope = none}}), "beach: slope must be a finite number, found nan");
    EXPECT_EQ(complaint({StepGround{.direction_deg = infinity}}),
              "step: direction_deg must be a finite number, found inf");
    EXPECT_EQ(complaint({BlockGround{.size_m = {1, -1}}}), "block: size_m must be above 0, found -1");
    EXPECT_EQ(complaint({BlockGround{}, Combine::max, none}), "ground: base_m must be a finite number, found nan");
    EXPECT_EQ(complaint({BumpGround{.half_width_m = {infinity, infinity}}}), "");
}

TEST(GroundShapes, RefuseGroundThatIsNoHeight) {
    const auto said = [](const Bathymetry& bathymetry) -> std::string {
        try {
            ground_heights(bathymetry, make_grid(2, 2, 2, 2));
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(said({.depth_m = infinity, .file = {}, .shapes = {}}),
              "the ground: depth_m must be a finite number, found inf");
    const GroundShape steep{PlaneGround{.slope = {1.7e308, 1.7e308}}};
    EXPECT_EQ(said({.depth_m = 1, .file = {}, .shapes = {steep}}),
              "the ground at (1.5, 0.5) m must be a finite height, found inf");
}

}  // namespace
}  // namespace waterlight::testing
