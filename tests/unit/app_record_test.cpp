// What a run reads off its frames, and how checks judge it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "app/readings.hpp"
#include "app/report.hpp"
#include "sim/error.hpp"

namespace waterlight::test {
namespace {

Surface plane(Boundary boundary, double slope_x, double slope_y) {
    Surface s(make_grid(8, 4, 4.0, 2.0), boundary);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 8; ++i)
            s.elevation(i, j) = static_cast<float>(slope_x * s.grid.x_m(i) + slope_y * s.grid.y_m(j));
    s.slope_x.fill(static_cast<float>(slope_x));
    s.slope_y.fill(static_cast<float>(slope_y));
    return s;
}

TEST(Readings, ElevationIsExactOnAPlaneBetweenCellCentres) {
    const Surface s = plane({Side::wall, Side::wall}, 0.25, -0.5);
    for (const glm::dvec2 at : {glm::dvec2(1.0, 1.0), glm::dvec2(0.25, 0.25), glm::dvec2(3.7, 1.3)})
        EXPECT_NEAR(elevation_at(s, at), 0.25 * at.x - 0.5 * at.y, 1e-6);
}

TEST(Readings, BesideDryGroundElevationIsThatOfTheCellItself) {
    Surface s = plane({Side::wall, Side::wall}, 0, 0);
    s.depth.emplace(8, 4);
    s.depth->fill(0.5F);
    (*s.depth)(6, 1) = 0;
    s.elevation(6, 1) = 2;  // a rock
    s.slope_x(4, 1) = 1;
    EXPECT_EQ(elevation_at(s, {3.4, 0.7}), 2);
    EXPECT_EQ(elevation_at(s, {2.9, 0.7}), 0) << "between the rock and the water the water is not bent upwards";
    EXPECT_GT(elevation_at(s, {2.4, 0.75}), 0.05) << "away from it the surface is smooth";
}

/// cos(k x) with one half wave between walls, or one wave between periodic sides of 4 m.
Surface cosine(Side side, int cells) {
    const double k = (side == Side::wall ? 1 : 2) * std::numbers::pi / 4;
    Surface s(make_grid(cells, 1, 4, 1), {side, side});
    for (int i = 0; i < cells; ++i) {
        s.elevation(i, 0) = static_cast<float>(std::cos(k * s.grid.x_m(i)));
        s.slope_x(i, 0) = static_cast<float>(-k * std::sin(k * s.grid.x_m(i)));
    }
    return s;
}

TEST(Readings, ElevationIsOfFourthOrderUpToTheSides) {
    for (const Side side : {Side::wall, Side::periodic}) {
        for (const double x : {0.0, 1.0, 4.0}) {
            const double exact = std::cos((side == Side::wall ? 1 : 2) * std::numbers::pi / 4 * x);
            const double coarse = std::abs(elevation_at(cosine(side, 8), {x, 0.5}) - exact);
            const double fine = std::abs(elevation_at(cosine(side, 16), {x, 0.5}) - exact);
            EXPECT_LT(coarse, 2e-3);
            EXPECT_LT(fine, coarse / 12 + 1e-6);
        }
    }
}

TEST(Readings, ASurfaceThatIsNotANumberStopsTheRunAndSaysWhere) {
    Surface s = plane({Side::wall, Side::wall}, 1, 0);
    EXPECT_NO_THROW(require_finite(s, 7));
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        s.slope_y(5, 2) = bad;
        try {
            require_finite(s, 7);
            ADD_FAILURE() << "accepted";
        } catch (const WorldError& error) {
            for (const char* part : {"slope along y", "cell (5, 2)", "t = 0 s", "step 7"})
                EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
}

TEST(Readings, LightThatIsNotANumberStopsTheRunAndSaysWhere) {
    Field<float> light(7, 5);
    const Instant now{1.5, 30};
    EXPECT_NO_THROW(require_finite("light", light, now));
    light(5, 2) = std::numeric_limits<float>::infinity();
    try {
        require_finite("light", light, now);
        ADD_FAILURE() << "accepted";
    } catch (const WorldError& error) {
        EXPECT_STREQ(error.what(), "the light is not finite: inf in cell (5, 2) at t = 1.5 s, step 30");
    }
}

TEST(Readings, ALedgerThatIsNotANumberIsNotClosed) {
    LightLedger ledger{.incident_w = 1, .floor_w = 1};
    EXPECT_NO_THROW(require_finite("the walls", ledger, {}));
    ledger.outside_w = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(require_finite("the walls", ledger, {}), WorldError);
    EXPECT_THROW(require_finite("the walls", LightLedger{.floor_w = 1}, {}), WorldError) << "light out of nothing";
    EXPECT_NO_THROW(require_finite("the walls", LightLedger{}, {})) << "no sun";
}

TEST(Readings, IrradianceIsThatOfThePixel) {
    Field<float> map(4, 2);
    map(3, 1) = 7;
    const FloorPlan plan = cover(make_grid(8, 4, 4.0, 2.0), 4, 2);
    EXPECT_EQ(pixel_at(plan, map, {3.5, 1.5}), 7);
    EXPECT_EQ(pixel_at(plan, map, {4.0, 2.0}), 7);
    EXPECT_EQ(pixel_at(plan, map, {2.9, 1.5}), 0);
    EXPECT_TRUE(std::isnan(pixel_at(plan, map, {4.1, 1.5})));
}

TEST(Readings, Statistics) {
    Field<float> map(2, 2);
    map(0, 0) = 1;
    map(1, 0) = 3;
    map(0, 1) = 1;
    map(1, 1) = 3;
    const FloorStatistics s = statistics_of(map);
    EXPECT_DOUBLE_EQ(s.mean, 2);
    EXPECT_DOUBLE_EQ(s.min, 1);
    EXPECT_DOUBLE_EQ(s.max, 3);
    EXPECT_DOUBLE_EQ(s.cv, 0.5);
}

bool passes(const Check& check, double value) { return judge({check}, std::vector<double>{value}).at(0).pass; }

Check equal(double value, double tolerance, double relative_tolerance) {
    Check check;
    check.quantity = "q";
    check.equals = value;
    check.tolerance = tolerance;
    check.relative_tolerance = relative_tolerance;
    return check;
}

Check between(std::optional<double> above, std::optional<double> below) {
    Check check;
    check.quantity = "q";
    check.above = above;
    check.below = below;
    return check;
}

TEST(Checks, EqualsTakesTheLargerTolerance) {
    const Check check = equal(10, 0.1, 0.05);
    EXPECT_TRUE(passes(check, 10.5));
    EXPECT_TRUE(passes(check, 9.5));
    EXPECT_FALSE(passes(check, 10.6));
}

TEST(Checks, BoundsAreStrictAndEachHasItsResult) {
    EXPECT_FALSE(passes(between({}, 1), 1.0));
    EXPECT_TRUE(passes(between(1, {}), 1.1));
    EXPECT_EQ(judge({between(1, 2)}, std::vector<double>{1.5}).size(), 2U);
}

TEST(Checks, NotANumberFails) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(passes(between({}, 1), nan));
    EXPECT_FALSE(passes(equal(1, 1, 0), nan));
}

}  // namespace
}  // namespace waterlight::test
