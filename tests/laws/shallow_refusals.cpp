// What the shallow-water model refuses, and how it stops.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "sim/error.hpp"
#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The text of the InputError that the settings give; empty where they are taken.
std::string refusal(const ShallowWaterSettings& settings) {
    try {
        make_shallow_water<float>(settings);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// That of a flume of four cells after `change`.
template <class Change>
std::string refusal_after(const Change& change) {
    ShallowWaterSettings settings = flume(4, 4);
    change(settings);
    return refusal(settings);
}

/// Four values, the second of which is `second`.
Field<double> values(double others, double second) {
    Field<double> field(4, 1);
    field.fill(others);
    field(1, 0) = second;
    return field;
}

TEST(ShallowRefusals, NumbersOutOfRange) {
    EXPECT_EQ(refusal(flume(4, 4)), "");
    EXPECT_EQ(refusal_after([](auto& s) { s.cfl = 1; }), "");
    EXPECT_EQ(refusal_after([](auto& s) { s.cfl = 1.01; }), "cfl: found 1.01; allowed: above 0, at most 1");
    EXPECT_EQ(refusal_after([](auto& s) { s.cfl = 0; }), "cfl: found 0; allowed: above 0, at most 1");
    EXPECT_EQ(refusal_after([](auto& s) { s.cfl = nan; }), "cfl: found nan; allowed: above 0, at most 1");
    EXPECT_EQ(refusal_after([](auto& s) { s.manning = -0.01; }), "manning: found -0.01; allowed: >= 0");
    EXPECT_EQ(refusal_after([](auto& s) { s.wet_m = 0; }), "wet_m: found 0; allowed: > 0");
    EXPECT_EQ(refusal_after([](auto& s) { s.water.gravity_m_s2 = 0; }), "gravity: found 0; allowed: > 0");
    EXPECT_EQ(refusal_after([](auto& s) { s.water.density_kg_m3 = nan; }), "density: found nan; allowed: > 0");
    EXPECT_EQ(refusal_after([](auto& s) { s.water.density_kg_m3 = 0; }), "density: found 0; allowed: > 0");
    EXPECT_EQ(refusal_after([](auto& s) { s.water.depth_m = std::numeric_limits<double>::infinity(); }),
              "depth: found inf; allowed: > 0 and finite; deep water is for airy");
}

TEST(ShallowRefusals, FieldsThatAreNotWater) {
    EXPECT_EQ(refusal_after([](auto& s) { s.depth_m = values(1, nan); }), "depth: found nan; allowed: finite numbers");
    EXPECT_EQ(refusal_after([](auto& s) { s.depth_m = values(1, -1e-9); }), "depth: found -1e-09; allowed: >= 0");
    EXPECT_EQ(refusal_after([](auto& s) { s.bed_m = values(-1, nan); }), "bed: found nan; allowed: finite numbers");
    EXPECT_EQ(refusal_after([](auto& s) { s.velocity_x_m_s = values(0, nan); }),
              "velocity along x: found nan; allowed: finite numbers");
    EXPECT_EQ(refusal_after([](auto& s) { s.velocity_y_m_s = values(0, std::numeric_limits<double>::infinity()); }),
              "velocity along y: found inf; allowed: finite numbers");
    EXPECT_EQ(refusal_after([](auto& s) { s.bed_m = Field<double>(3, 1); }),
              "bed: found 3 x 1 values; allowed: as many as cells, 4 x 1");
}

TEST(ShallowRefusals, SidesAndSourcesThatCannotBe) {
    EXPECT_EQ(refusal_after([](auto& s) { s.sides.west = PeriodicSide{}; }),
              "sides: found one periodic side without its opposite; allowed: both or none of an axis");
    EXPECT_EQ(refusal_after([](auto& s) {
                  s.sides.west = DischargeSide{{{0, 1}, {1, -0.5}}};
              }),
              "discharge of a side: found -0.5; allowed: >= 0 m2/s");
    EXPECT_EQ(refusal_after([](auto& s) { s.sources = {Drop{{0, 0}, -1, 1, 0}}; }), "drop: radius_m must be above 0");
    EXPECT_EQ(refusal_after([](auto& s) {
                  s.bed_m = values(1, 1);
                  s.sources = {Wavemaker{{2, 0}, {2, 1}, 0.01, 1}};
              }),
              "wavemaker: found dry ground in its middle; allowed: water");
}

TEST(ShallowRefusals, SeriesOfSides) {
    const auto west = [](const ShallowSide& side) { return refusal_after([&](auto& s) { s.sides.west = side; }); };
    EXPECT_EQ(west(FlowSide{nan, {0, 0}}), "flow of a side: found nan; allowed: finite numbers");
    EXPECT_EQ(west(FlowSide{0, {nan, 0}}), "flow of a side: found nan; allowed: finite numbers");
    EXPECT_EQ(west(LevelSide{}), "level of a side: found 0 times and 0 values; allowed: as many of both, at least one");
    EXPECT_EQ(west(LevelSide{{{0, 1}, {0}}}),
              "level of a side: found 2 times and 1 values; allowed: as many of both, at least one");
    EXPECT_EQ(west(IncidentSide{{{0, 1}, {0, nan}}}), "incident wave of a side: found nan; allowed: finite numbers");
    EXPECT_EQ(west(PistonSide{{{0, 2, 2}, {0, 1, 2}}}), "piston of a side: found 2; allowed: times that increase");
}

/// The text of the WorldError with which a run stops.
std::string failure(ShallowWaterModel& model, double end_s) {
    try {
        model.advance(end_s);
    } catch (const WorldError& error) {
        return error.what();
    }
    return "";
}

// Water that comes in at 1e10 times the speed of its own waves.
TEST(ShallowRefusals, CollapsingTimeStepNamesTheCell) {
    ShallowWaterSettings settings = flume(4, 4);
    settings.velocity_x_m_s = values(0, 1e11);
    const auto model = make_shallow_water<double>(settings);
    const std::string text = failure(*model, 1);
    EXPECT_EQ(text.find("shallow-water: the time step fell to 8e-12 s at t = 0 s, step 1: cell (1, 0) at (1.5, 0.5) m: "
                        "depth 1 m, velocity (1e+11, 0) m/s, ground -1 m"),
              0u)
        << text;
}

TEST(ShallowRefusals, NumbersThatAreNotFiniteStopTheRun) {
    ShallowWaterSettings settings = flume(4, 4);
    settings.depth_m = values(1, 1e38);
    settings.velocity_x_m_s = values(0, 1e30);
    const auto model = make_shallow_water<float>(settings);
    const std::string text = failure(*model, 1);
    EXPECT_NE(text.find("a number is not finite at t = 0 s, step 1: cell (1, 0)"), std::string::npos) << text;
}

}  // namespace
}  // namespace waterlight::testing
