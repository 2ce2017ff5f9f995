// From a scenario to the settings of the model shallow-water.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/build_shallow.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

const std::string ten_seconds = least + "[waves]\nmodel = \"shallow-water\"\nduration_s = 10\n";

ShallowWaterSettings settings_of(const std::string& text) { return shallow_settings(parse(ten_seconds + text)); }

double least_of(const Field<double>& field) { return *std::min_element(field.values().begin(), field.values().end()); }
double greatest_of(const Field<double>& field) {
    return *std::max_element(field.values().begin(), field.values().end());
}

TEST(BuildShallow, LeavesTheModelItsOwnDefaults) {
    const ShallowWaterSettings s = settings_of(""), own;
    EXPECT_EQ(s.cfl, own.cfl);
    EXPECT_EQ(s.wet_m, own.wet_m);
    EXPECT_EQ(s.manning, 0);
    EXPECT_TRUE(s.keep_records);
    EXPECT_EQ(least_of(s.bed_m), -2);
    EXPECT_EQ(least_of(s.depth_m), 2);
    EXPECT_TRUE(std::holds_alternative<WallSide>(s.sides.west));
}

TEST(BuildShallow, GroundIsTheFloorWithItsShapes) {
    const ShallowWaterSettings s = settings_of(
        "[[domain.ground]]\ntype = \"cone\"\nat_m = [4, 3]\ntoe_radius_m = 1\nheight_m = 3\ncrest_radius_m = 0.5\n");
    EXPECT_EQ(greatest_of(s.bed_m), 1);
    EXPECT_EQ(least_of(s.bed_m), -2);
    EXPECT_EQ(least_of(s.depth_m), 0) << "the cone stands out of the water";
}

TEST(BuildShallow, ExactStatesStandOnTheFloorOfTheDomain) {
    const ShallowWaterSettings dam =
        settings_of("[[waves.initial]]\ntype = \"riemann\"\nat_m = [4, 0]\nleft_depth_m = 2.5\nright_depth_m = 1\n");
    EXPECT_EQ(least_of(dam.bed_m), -2);
    EXPECT_EQ(greatest_of(dam.bed_m), -2);
    EXPECT_DOUBLE_EQ(dam.depth_m(0, 0), 2.5);
    EXPECT_DOUBLE_EQ(dam.depth_m(63, 0), 1);
    const ShallowWaterSettings bowl =
        settings_of("[[waves.initial]]\ntype = \"thacker\"\ncentre_m = [4, 3]\na_m = 2\neta_m = 0.1\n");
    EXPECT_NEAR(least_of(bowl.bed_m), -2, 0.02) << "the middle of the bowl is as deep as the domain";
    EXPECT_NEAR(bowl.bed_m(47, 24),
                2 * (std::pow(bowl.grid.x_m(47) - 4, 2) + std::pow(bowl.grid.y_m(24) - 3, 2)) / 4 - 2, 1e-12);
}

TEST(BuildShallow, ExactDepthGoesOnFromTheStartOfTheRun) {
    const std::string vortex = "[[waves.initial]]\ntype = \"vortex\"\ncentre_m = [3, 3]\ndirection_deg = 0\ntime_s = ";
    const Scenario late = parse(ten_seconds + vortex + "1.0\n");
    const Field<double> start = *exact_depth(late, 0), later = *exact_depth(late, 0.5);
    const Field<double> same = *exact_depth(parse(ten_seconds + vortex + "1.5\n"), 0);
    const ShallowWaterSettings s = shallow_settings(late);
    for (std::size_t n = 0; n < start.size(); ++n) {
        ASSERT_DOUBLE_EQ(start.data()[n], s.depth_m.data()[n]);
        ASSERT_DOUBLE_EQ(later.data()[n], same.data()[n]);
    }
    EXPECT_FALSE(exact_depth(parse(ten_seconds), 0).has_value());
}

const std::string from_west =
    "boundary = { x = \"absorbing\", west = \"inflow\" }\n[[waves.inflow]]\nside = \"west\"\n";

TEST(BuildShallow, AnOscillationSwellsToItsAmplitudeAndOutlastsTheRun) {
    const ShallowWaterSettings s =
        settings_of(from_west + "type = \"wave\"\namplitude_m = 0.25\nperiod_s = 3\nramp_periods = 2\n");
    EXPECT_TRUE(std::holds_alternative<OpenSide>(s.sides.east));
    const TimeSeries& wave = std::get<IncidentSide>(s.sides.west).elevation_m;
    EXPECT_EQ(wave.at(0), 0);
    EXPECT_GE(wave.end_s(), 10);
    for (const double t : {6.1, 7.77, 9.3})
        EXPECT_NEAR(wave.at(t), 0.25 * std::sin(2 * std::numbers::pi * t / 3), 1e-3 * 0.25);
    EXPECT_NEAR(wave.at(0.75), 0.25 * 0.5 * (1 - std::cos(std::numbers::pi * 0.75 / 6)), 1e-3 * 0.25);
}

TEST(BuildShallow, ASolitaryWaveComesInAtItsTimeAndThenTheSideIsOpen) {
    const ShallowWaterSettings s = settings_of(from_west + "type = \"wave\"\nsolitary_height_m = 0.2\ncrest_s = 5\n");
    const TimeSeries& wave = std::get<IncidentSide>(s.sides.west).elevation_m;
    const double kappa = std::sqrt(0.75 * 0.2 / 8), speed = std::sqrt(9.81 * 2.2);
    for (const double t : {2.0, 4.5, 5.0, 6.2})
        EXPECT_NEAR(wave.at(t), 0.2 / std::pow(std::cosh(kappa * speed * (t - 5)), 2), 1e-3 * 0.2) << t;
    EXPECT_NEAR(wave.value.back(), 0, 1e-6 * 0.2);
}

TEST(BuildShallow, EveryInflowReachesItsSide) {
    const auto west = [](const std::string& what) { return settings_of(from_west + what).sides.west; };
    EXPECT_EQ(std::get<DischargeSide>(west("type = \"discharge\"\ndischarge_m2_s = 3\n")).discharge_m2_s.at(7), 3);
    EXPECT_EQ(std::get<LevelSide>(west("type = \"level\"\nelevation_m = -0.5\n")).elevation_m.at(7), -0.5);
    const auto flow = std::get<FlowSide>(west("type = \"flow\"\nelevation_m = 0.5\nvelocity_m_s = [9, 1]\n"));
    EXPECT_EQ(flow.elevation_m, 0.5);
    EXPECT_EQ(flow.velocity_m_s, glm::dvec2(9, 1));
    const auto piston = std::get<PistonSide>(west("type = \"piston\"\namplitude_m = 0.1\nperiod_s = 2\n"));
    EXPECT_NEAR(piston.displacement_m.at(2.5), 0.1, 1e-12);
}

}  // namespace
}  // namespace waterlight::test
