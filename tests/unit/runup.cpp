// The run-up line lies where level water meets the ground, and says so in order.
#include "sim/runup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace waterlight::test {
namespace {

constexpr float never = std::numeric_limits<float>::quiet_NaN();

struct Shore {
    Grid grid;
    Field<float> bed, highest;
};

/// Ground of a given height under water that stood as high as `level`, where that is above the ground.
Shore shore(const Grid& grid, const std::function<double(glm::dvec2)>& ground,
            const std::function<double(glm::dvec2)>& level) {
    Shore s{grid, {grid.nx, grid.ny}, {grid.nx, grid.ny}};
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const glm::dvec2 at{grid.x_m(i), grid.y_m(j)};
            s.bed(i, j) = static_cast<float>(ground(at));
            s.highest(i, j) = level(at) > ground(at) ? static_cast<float>(level(at)) : never;
        }
    return s;
}

std::vector<RunupLine> lines_of(const Shore& s) { return runup_lines(s.grid, s.bed, s.highest); }

TEST(RunupLine, OfLevelWaterOnAPlaneBeachIsExact) {
    const auto beach = [](glm::dvec2 at) { return 0.1 * at.x - 0.03 * at.y - 0.25; };
    const Shore s = shore(make_grid(40, 20, 8, 4), beach, [](glm::dvec2) { return 0.11; });
    const std::vector<RunupLine> lines = lines_of(s);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_GE(lines[0].size(), 19U);
    for (const RunupPoint& p : lines[0]) {
        EXPECT_NEAR(beach(p.at_m), 0.11, 1e-6);
        EXPECT_NEAR(p.ground_m, 0.11, 1e-6);
    }
}

/// Largest distance of the line round a cone from the circle on which its ground is as high as the water.
double error_on_a_cone(int cells) {
    const auto cone = [](glm::dvec2 at) { return 0.6 - 0.25 * std::hypot(at.x - 3.01, at.y - 2.98); };
    const Shore s = shore(make_grid(cells, cells, 6, 6), cone, [](glm::dvec2) { return 0.1; });
    const std::vector<RunupLine> lines = lines_of(s);
    EXPECT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].front().at_m, lines[0].back().at_m) << "a closed line";
    double error = 0, turned = 0, before = 0;
    for (std::size_t i = 0; i < lines[0].size(); ++i) {
        const glm::dvec2 from_centre = lines[0][i].at_m - glm::dvec2(3.01, 2.98);
        error = std::max(error, std::abs(std::hypot(from_centre.x, from_centre.y) - 2));
        const double angle = std::atan2(from_centre.y, from_centre.x);
        if (i > 0) turned += std::remainder(angle - before, 2 * std::numbers::pi);
        before = angle;
    }
    EXPECT_NEAR(std::abs(turned), 2 * std::numbers::pi, 1e-9) << "once round, point after point";
    return error;
}

TEST(RunupLine, RoundAConeIsOfSecondOrder) {
    const double coarse = error_on_a_cone(30), fine = error_on_a_cone(120);
    EXPECT_LT(coarse, 3e-3) << "of cells of 0.2 m";
    EXPECT_GT(std::log2(coarse / fine) / 2, 1.8) << coarse << ' ' << fine;
}

TEST(RunupLine, OfWaterThatSlopesIsWithinItsShareOfACell) {
    const auto beach = [](glm::dvec2 at) { return 0.1 * (at.x - 2); };
    const auto level = [](glm::dvec2 at) { return 0.02 * (at.x - 2) + 0.16; };  // meets the beach at x = 4
    for (const int cells : {25, 50, 100}) {
        const Shore s = shore(make_grid(cells, 4, 5, 1), beach, level);
        const std::vector<RunupLine> lines = lines_of(s);
        ASSERT_EQ(lines.size(), 1U);
        for (const RunupPoint& p : lines[0]) EXPECT_NEAR(p.at_m.x, 4, 0.2 * s.grid.dx_m + 1e-5) << cells;
    }
}

TEST(RunupLine, StopsAtDryGroundThatTheWaterStoodAboveAndHalfWayToLowerGround) {
    Shore s{make_grid(2, 2, 2, 2), {2, 2}, {2, 2}};
    s.bed.fill(0);
    s.highest.fill(never);
    s.highest(0, 0) = s.highest(0, 1) = 0.5F;
    s.bed(1, 0) = 0.25F;
    s.bed(1, 1) = -1;
    const std::vector<RunupLine> lines = lines_of(s);
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_EQ(lines[0].size(), 2U);
    EXPECT_EQ(lines[0][0].at_m, glm::dvec2(1.5, 0.5));
    EXPECT_EQ(lines[0][0].ground_m, 0.25);
    EXPECT_EQ(lines[0][1].at_m, glm::dvec2(1.0, 1.5));
}

TEST(RunupLine, IsNoneWhereAllIsWetOrAllIsDry) {
    Shore s{make_grid(5, 4, 5, 4), {5, 4}, {5, 4}};
    EXPECT_TRUE(lines_of(s).empty());
    s.highest.fill(never);
    EXPECT_TRUE(lines_of(s).empty());
    EXPECT_FALSE(highest_runup(s.grid, s.bed, s.highest).has_value());
}

TEST(RunupLine, SeparatesDryCellsThatTouchAtACorner) {
    Shore s{make_grid(4, 4, 4, 4), {4, 4}, {4, 4}};
    s.bed.fill(-1);
    for (const auto& [i, j] : {std::pair(1, 1), std::pair(2, 2)}) {
        s.bed(i, j) = 1;
        s.highest(i, j) = never;
    }
    const std::vector<RunupLine> lines = lines_of(s);
    ASSERT_EQ(lines.size(), 2U);
    for (const RunupLine& line : lines) EXPECT_EQ(line.size(), 5U);
}

TEST(RunupLine, TakesAPlaceOnceWhereItStopsAtOneCentreFromTwoSides) {
    Shore s{make_grid(2, 2, 2, 2), {2, 2}, {2, 2}};
    s.bed.fill(0);
    s.highest.fill(0.5F);
    s.bed(1, 1) = 0.25F;
    s.highest(1, 1) = never;
    const std::vector<RunupLine> lines = lines_of(s);
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_EQ(lines[0].size(), 1U);
    EXPECT_EQ(lines[0][0].at_m, glm::dvec2(1.5, 1.5));
}

TEST(HighestRunup, IsTheHighestGroundThatWasWet) {
    const Shore s = shore(
        make_grid(50, 3, 5, 0.3), [](glm::dvec2 at) { return 0.2 * at.x - 0.5; }, [](glm::dvec2) { return 0.123; });
    const auto highest = highest_runup(s.grid, s.bed, s.highest);
    ASSERT_TRUE(highest.has_value());
    EXPECT_NEAR(highest->ground_m, 0.11, 1e-6);
    EXPECT_NEAR(highest->at_m.x, 3.05, 1e-12);
}

}  // namespace
}  // namespace waterlight::test
