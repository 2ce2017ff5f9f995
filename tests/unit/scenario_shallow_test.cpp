// What a scenario says to the model shallow-water, and what it may not say.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scenarios/memory.hpp"
#include "scenarios/resolve.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

/// Lines 5 and 6 of a scenario.
class RejectedShallow : public ::testing::TestWithParam<Bad> {};

TEST_P(RejectedShallow, NamesPlaceKeyFoundAndAllowed) { expect_rejection(GetParam()); }

#define SHALLOW "[waves]\nmodel = \"shallow-water\"\n"  // lines 5 and 6

INSTANTIATE_TEST_SUITE_P(
    Scenario, RejectedShallow,
    ::testing::Values(
        Bad{"SidesThatDifferOfAiry", "[waves]\nboundary = { west = \"wall\", east = \"absorbing\" }\n",
            "pool.toml:6:21: waves.boundary.west:", "equal sides, or model shallow-water"},
        Bad{"OneSideOfAiryOverItsAxis", "[waves]\nboundary = { x = \"wall\", east = \"absorbing\" }\n",
            "pool.toml:6:", "equal sides"},
        Bad{"InflowOfAiry", "[waves]\nboundary = { x = \"inflow\" }\n",
            "pool.toml:6:18: waves.boundary.x:", "model shallow-water"},
        Bad{"PeriodicAtOneSide", SHALLOW "boundary = { y = \"periodic\", north = \"wall\" }\n",
            "pool.toml:7:", "periodic at both or none"},
        Bad{"UnknownSide", SHALLOW "boundary = { left = \"wall\" }\n",
            "pool.toml:7:21: waves.boundary.left: found an unknown key", "west"},
        Bad{"CflBeyondTheLimit", SHALLOW "cfl = 1.01\n", "pool.toml:7:7: waves.cfl:", "number in (0, 1]"},
        Bad{"ManningOfAiry", "[waves]\nmodel = \"airy\"\nmanning = 0.02\n",
            "pool.toml:7:11: waves.manning:", "model shallow-water"},
        Bad{"NegativeManning", SHALLOW "manning = -0.02\n", "pool.toml:7:11: waves.manning:", ">= 0"},
        Bad{"WetOfNothing", SHALLOW "wet_m = 0\n", "pool.toml:7:9: waves.wet_m:", "> 0"},
        Bad{"WetOfLinear", "[waves]\nmodel = \"linear\"\nwet_m = 1e-3\n",
            "pool.toml:7:9: waves.wet_m:", "model shallow-water"},
        Bad{"FrozenSineOfShallowWater", SHALLOW "[[waves.sine]]\namplitude_m = 0.1\nwavelength_m = 1\nfrozen = true\n",
            "pool.toml:10:", "model prescribed"},
        Bad{"SineBesideAnExactState",
            SHALLOW "[[waves.sine]]\namplitude_m = 0.1\nwavelength_m = 1\n[[waves.initial]]\ntype = \"riemann\"\nat_m "
                    "= [1, 1]\n",
            "pool.toml:7:", "one of both"},
        Bad{"SpectrumOfShallowWater", SHALLOW "boundary = { x = \"periodic\", y = \"periodic\" }\n[waves.spectrum]\n",
            "pool.toml:8:1: waves.spectrum:", "model airy"},
        Bad{"MarginOfShallowWater", SHALLOW "boundary = { x = \"absorbing\" }\nmargin_m = 1\n",
            "pool.toml:8:12: waves.margin_m:", "model linear or airy"},
        Bad{"InflowWithoutSide", SHALLOW "[[waves.inflow]]\ntype = \"level\"\nelevation_m = 0.1\n",
            "pool.toml:7:1: waves.inflow[0].side: found nothing", "west, east, south, north"},
        Bad{"InflowThroughAWall", SHALLOW "[[waves.inflow]]\ntype = \"level\"\nside = \"east\"\nelevation_m = 0.1\n",
            "pool.toml:9:8: waves.inflow[0].side:", "waves.boundary.east = \"inflow\""},
        Bad{"InflowOfNothing", SHALLOW "boundary = { north = \"inflow\" }\n",
            "pool.toml:7:22: waves.boundary.north:", "[[waves.inflow]] with side = \"north\""},
        Bad{"InflowTwice",
            SHALLOW "boundary = { west = \"inflow\" }\n"
                    "[[waves.inflow]]\ntype = \"flow\"\nside = \"west\"\nvelocity_m_s = [1, 0]\n"
                    "[[waves.inflow]]\ntype = \"level\"\nside = \"west\"\nelevation_m = 0.1\n",
            "pool.toml:14:8: waves.inflow[1].side:", "one inflow a side"},
        Bad{"InflowOfAnotherType",
            SHALLOW "boundary = { west = \"inflow\" }\n[[waves.inflow]]\ntype = \"river\"\nside = \"west\"\n",
            "pool.toml:9:8: waves.inflow[0].type:", "wave, discharge, level, flow, piston"},
        Bad{"WaveOfNothing",
            SHALLOW "boundary = { west = \"inflow\" }\n[[waves.inflow]]\ntype = \"wave\"\nside = \"west\"\n",
            "pool.toml:8:1: waves.inflow[0]: found nothing that comes in",
            "one of file, period_s and solitary_height_m"},
        Bad{"DischargeTwice",
            SHALLOW "boundary = { west = \"inflow\" }\n[[waves.inflow]]\ntype = \"discharge\"\nside = \"west\"\n"
                    "discharge_m2_s = 1\nfile = \"a.txt\"\n",
            "pool.toml:8:1: waves.inflow[0]: found more than one source", "one of file and discharge_m2_s"},
        Bad{"ScaleWithoutAFile",
            SHALLOW "boundary = { west = \"inflow\" }\n[[waves.inflow]]\ntype = \"piston\"\nside = \"west\"\n"
                    "period_s = 1\nscale = 2\n",
            "pool.toml:12:9: waves.inflow[0].scale:", "file beside it"},
        Bad{"AmplitudeWithoutAPeriod",
            SHALLOW "boundary = { west = \"inflow\" }\n[[waves.inflow]]\ntype = \"wave\"\nside = \"west\"\n"
                    "file = \"a.txt\"\namplitude_m = 2\n",
            "pool.toml:12:15: waves.inflow[0].amplitude_m:", "period_s beside it"},
        Bad{"GroundOfAiry", "[[domain.ground]]\ntype = \"cone\"\nat_m = [1, 1]\n[waves]\nmodel = \"airy\"\n",
            "pool.toml:5:1: domain.ground:", "model shallow-water"},
        Bad{"BathymetryOfAiry", "bathymetry = \"a.vti\"\n[waves]\nmodel = \"airy\"\n",
            "pool.toml:5:14: domain.bathymetry:", "model shallow-water"},
        Bad{"SurveyOfNothing", "[domain.survey]\ndatum_m = 3\n" SHALLOW,
            "pool.toml:5:1: domain.survey:", "domain.bathymetry beside it"},
        Bad{"SurveyUpOrDown", "bathymetry = \"a.vti\"\n[domain.survey]\npositive = \"left\"\n" SHALLOW,
            "pool.toml:7:12: domain.survey.positive:", "auto, up, down"},
        Bad{"UnknownShape", "[[domain.ground]]\ntype = \"corn\"\nat_m = [1, 1]\n" SHALLOW,
            "pool.toml:6:8: domain.ground[0].type:", "did you mean \"cone\"?"},
        Bad{"BlockWithoutSize", "[[domain.ground]]\ntype = \"block\"\nat_m = [1, 1]\n" SHALLOW,
            "pool.toml:5:1: domain.ground[0].size_m: found nothing", "required"},
        Bad{"CrestWiderThanToe", "[[domain.ground]]\ntype = \"cone\"\nat_m = [1, 1]\ncrest_radius_m = 2\n" SHALLOW,
            "pool.toml:8:18: domain.ground[0].crest_radius_m:", "at most toe_radius_m = 1"},
        Bad{"InitialOfAiry", "[waves]\nmodel = \"airy\"\n[[waves.initial]]\ntype = \"still\"\n",
            "pool.toml:7:1: waves.initial:", "model shallow-water"},
        Bad{"ExactBesideAnother",
            SHALLOW "[[waves.initial]]\ntype = \"still\"\n"
                    "[[waves.initial]]\ntype = \"thacker\"\ncentre_m = [4, 3]\n",
            "pool.toml:9:1: waves.initial[1]:", "one exact state alone"},
        Bad{"ExactOverOtherGround",
            "[[domain.ground]]\ntype = \"cone\"\nat_m = [1, 1]\n" SHALLOW
            "[[waves.initial]]\ntype = \"riemann\"\nat_m = [4, 3]\n",
            "pool.toml:5:1: domain.ground:", "one of both"},
        Bad{"ExactErrorWithoutExactState", SHALLOW "[[check]]\nquantity = \"waves.exact_l1\"\nbelow = 1\n",
            "pool.toml:8:12: check[0].quantity:", "an exact state in waves.initial"},
        Bad{"RunupOfAiry", "[[check]]\nquantity = \"waves.max_runup\"\nbelow = 1\n",
            "pool.toml:6:12: check[0].quantity:", "model shallow-water"},
        Bad{"ArrivalOfAiry",
            "[[probe]]\nname = \"a\"\nat_m = [1, 1]\n[[check]]\nquantity = \"probe.a.arrival_time\"\nbelow = 1\n",
            "pool.toml:9:12: check[0].quantity:", "model shallow-water"},
        Bad{"ExtremesOfAiry", "[output]\nfields = [\"max_speed\"]\n",
            "pool.toml:6:10: output.fields:", "model shallow-water"}),
    [](const auto& bad) { return bad.param.name; });

const std::string all_keys = R"([domain]
size_m = [8.0, 6.0]
cells = [64, 48]
depth_m = 2.0
bathymetry = "ground.asc"
[domain.survey]
positive = "down"
datum_m = 1.5
offset_m = [-1, 2]
outside = "extend"
[[domain.ground]]
type = "cone"
at_m = [4, 3]
toe_radius_m = 2
crest_radius_m = 0.5
height_m = 2.5
[[domain.ground]]
type = "block"
at_m = [1, 1]
size_m = [0.5, 0.25]
combine = "min"
base_m = 0.25
[waves]
model = "shallow-water"
boundary = { x = "absorbing", west = "inflow", north = "inflow", south = "inflow" }
duration_s = 3
cfl = 0.5
manning = 0.025
wet_m = 0.01
[[waves.inflow]]
type = "wave"
side = "west"
file = "wave.txt"
scale = 2
[[waves.inflow]]
type = "piston"
side = "north"
amplitude_m = 0.125
period_s = 4
[[waves.inflow]]
type = "flow"
side = "south"
elevation_m = 0.5
velocity_m_s = [0, 3]
[[waves.initial]]
type = "still"
level_m = -0.25
[[waves.initial]]
type = "solitary"
crest_m = [1, 1]
height_m = 0.2
direction_deg = 90
[[waves.source]]
type = "drop"
at_m = [4, 3]
[output]
probe_every_s = 0.01
fields = ["elevation", "max_elevation"]
)";

TEST(ScenarioShallow, ReadsEveryKey) {
    const Scenario s = parse_scenario(all_keys, "pool.toml");
    check_combinations(s);
    EXPECT_EQ(resolve_model(s).model, ModelChoice::shallow_water);
    EXPECT_EQ(s.domain.bathymetry, "ground.asc");
    EXPECT_EQ(s.domain.survey.positive, Positive::down);
    EXPECT_EQ(s.domain.survey.datum_m, 1.5);
    EXPECT_EQ(s.domain.survey.offset_m, glm::dvec2(-1, 2));
    EXPECT_EQ(s.domain.survey.outside, OutsideFile::extend);
    ASSERT_EQ(s.domain.ground.size(), 2U);
    EXPECT_EQ(std::get<ConeGround>(s.domain.ground[0].ground).crest_radius_m, 0.5);
    EXPECT_FALSE(s.domain.ground[0].base_m.has_value());
    EXPECT_EQ(s.domain.ground[1].combine, Combine::min);
    EXPECT_EQ(s.domain.ground[1].base_m, 0.25);
    EXPECT_EQ(resolve_sides(s),
              (SideChoices{SideChoice::inflow, SideChoice::absorbing, SideChoice::inflow, SideChoice::inflow}));
    EXPECT_EQ(s.waves.cfl, 0.5);
    EXPECT_EQ(s.waves.manning, 0.025);
    EXPECT_EQ(s.waves.wet_m, 0.01);
    ASSERT_EQ(s.waves.inflows.size(), 3U);
    EXPECT_EQ(s.waves.inflows[0].signal.file, "wave.txt");
    EXPECT_EQ(s.waves.inflows[0].signal.scale, 2);
    EXPECT_EQ(s.waves.inflows[1].kind, InflowKind::piston);
    EXPECT_EQ(s.waves.inflows[1].side, DomainSide::north);
    EXPECT_EQ(s.waves.inflows[1].signal.period_s, 4);
    EXPECT_EQ(s.waves.inflows[2].velocity_m_s, glm::dvec2(0, 3));
    ASSERT_EQ(s.waves.initial.size(), 2U);
    EXPECT_EQ(std::get<StillWater>(s.waves.initial[0]).level_m, -0.25);
    EXPECT_EQ(std::get<SolitaryWave>(s.waves.initial[1]).direction_deg, 90);
    EXPECT_EQ(std::get<SolitaryWave>(s.waves.initial[1]).depth_m, 2) << "that of the domain";
    EXPECT_EQ(s.output.probe_every_s, 0.01);
    EXPECT_TRUE(s.output.shows("max_elevation"));
}

TEST(ScenarioShallow, LightSeesAWallWhereOneSideOfAnAxisIsOne) {
    const auto seen = [](const std::string& sides, const std::string& more = "") {
        return resolve_boundary(parse(least + shallow_water + "boundary = { " + sides + " }\n" + more));
    };
    const std::string level = "[[waves.inflow]]\ntype = \"level\"\nside = \"west\"\nelevation_m = 0.1\n";
    const std::string piston = "[[waves.inflow]]\ntype = \"piston\"\nside = \"west\"\nperiod_s = 1\n";
    EXPECT_EQ(seen(""), (Boundary{Side::wall, Side::wall}));
    EXPECT_EQ(seen("x = \"periodic\""), (Boundary{Side::periodic, Side::wall}));
    EXPECT_EQ(seen("x = \"absorbing\""), (Boundary{Side::absorbing, Side::wall}));
    EXPECT_EQ(seen("x = \"absorbing\", east = \"wall\""), (Boundary{Side::wall, Side::wall}));
    EXPECT_EQ(seen("x = \"absorbing\", west = \"inflow\"", level), (Boundary{Side::absorbing, Side::wall}));
    EXPECT_EQ(seen("x = \"absorbing\", west = \"inflow\"", piston), (Boundary{Side::wall, Side::wall}));
}

TEST(ScenarioShallow, IsClosedWithoutOpenSides) {
    EXPECT_TRUE(is_closed(parse(least + shallow_water)));
    EXPECT_TRUE(is_closed(parse(least + shallow_water + "boundary = { x = \"periodic\" }\n")));
    EXPECT_FALSE(is_closed(parse(least + shallow_water + "boundary = { north = \"absorbing\" }\n")));
}

TEST(ScenarioShallow, SidesTakeNoMemoryWhereTheyHaveNoMargin) {
    const Scenario closed = parse(least + shallow_water);
    const Scenario open = parse(least + shallow_water + "boundary = { x = \"absorbing\", y = \"absorbing\" }\n");
    EXPECT_EQ(estimate_memory(closed).cells, estimate_memory(open).cells);
}

TEST(ScenarioShallow, DataFilesAreFoundBesideTheScenario) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(testing::TempDir()) / "scenario_shallow";
    fs::create_directories(folder);
    std::ofstream(folder / "island.toml") << all_keys;
    std::ofstream(folder / "ground.asc") << "x";
    unsetenv("WATERLIGHT_DATA");
    try {
        read_scenario(folder / "island.toml");
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("waves.inflow[0].file: found no file"), std::string::npos) << message;
        EXPECT_NE(message.find((folder / "wave.txt").string()), std::string::npos) << message;
    }
    std::ofstream(folder / "wave.txt") << "0 0\n";
    const Scenario s = read_scenario(folder / "island.toml");
    EXPECT_EQ(s.domain.bathymetry, (folder / "ground.asc").string());
    EXPECT_EQ(s.waves.inflows[0].signal.file, (folder / "wave.txt").string());
    fs::remove_all(folder);
}

}  // namespace
}  // namespace waterlight::test
