// Values reach the settings that they name, and the rest keeps its defaults.
#include "tests/unit/scenario_support.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scenarios/memory.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight::test {
namespace {

TEST(ScenarioReader, LeastScenarioHasTheDefaultsOfTheStructs) {
    const Scenario s = parse(least);
    const Water water;
    const Sun sun;
    EXPECT_EQ(s.domain.size_m, glm::dvec2(8, 6));
    EXPECT_EQ(s.domain.cells, glm::ivec2(64, 48));
    EXPECT_EQ(s.water.depth_m, 2);
    EXPECT_EQ(s.water.gravity_m_s2, water.gravity_m_s2);
    EXPECT_EQ(s.light.irradiance_w_m2, sun.irradiance_w_m2);
    EXPECT_FALSE(s.floor.has_value());
    EXPECT_TRUE(s.waves.sources.empty());
}

TEST(ScenarioReader, ReadsEverySection) {
    const Scenario s = parse(least + R"(
[water]
refractive_index = 1.34
fresnel = false
absorption_per_m = 0.1
[waves]
model = "airy"
boundary = { x = "wall", y = "absorbing" }
duration_s = 10
margin_m = 1.5
[[waves.sine]]
amplitude_m = 0.01
wavelength_m = 0.5
direction_deg = 30
[[waves.standing]]
amplitude_m = 0.02
half_waves_x = 3
[[waves.source]]
type = "drop"
at_m = [4.0, 3.0]
radius_m = 0.15
[[waves.source]]
type = "rain"
drops_per_m2_s = 5
radius_m = [0.01, 0.02]
[[waves.source]]
type = "wavemaker"
from_m = [1, 0]
to_m = [1, 6]
period_s = 0.8
[light]
elevation_deg = 60.0
azimuth_deg = 30.0
[caustics.floor]
pixels = [1024, 768]
window = { samples = 7, channels = 5 }
angle_deg = 10
[output]
every_s = 0.05
formats = ["exr"]
compression = "zlib"
[[probe]]
name = "centre"
at_m = [4, 3]
[[check]]
quantity = "probe.centre.elevation"
below = 1
)");
    EXPECT_EQ(s.optics.refractive_index, 1.34);
    EXPECT_FALSE(s.optics.fresnel);
    EXPECT_EQ(s.waves.model, ModelChoice::airy);
    EXPECT_EQ(resolve_boundary(s), (Boundary{Side::wall, Side::absorbing}));
    EXPECT_EQ(s.waves.margin_m, 1.5);
    ASSERT_EQ(s.waves.sines.size(), 1U);
    EXPECT_EQ(s.waves.sines[0].direction_deg, 30);
    ASSERT_EQ(s.waves.standing.size(), 1U);
    EXPECT_EQ(s.waves.standing[0].half_waves_x, 3);
    ASSERT_EQ(s.waves.sources.size(), 3U);
    EXPECT_EQ(std::get<Drop>(s.waves.sources[0]).radius_m, 0.15);
    EXPECT_EQ(std::get<Rain>(s.waves.sources[1]).radius_m, glm::dvec2(0.01, 0.02));
    EXPECT_EQ(std::get<Wavemaker>(s.waves.sources[2]).to_m, glm::dvec2(1, 6));
    EXPECT_EQ(s.light.azimuth_deg, 30);
    ASSERT_TRUE(s.floor.has_value());
    EXPECT_EQ(s.floor->window, (FloorWindow{7, 5}));
    EXPECT_TRUE(s.output.wants("exr"));
    EXPECT_FALSE(s.output.wants("png"));
    EXPECT_EQ(s.output.compression, Compression::zlib);
    ASSERT_EQ(s.checks.size(), 1U);
    EXPECT_EQ(s.checks[0].below, 1.0);
}

TEST(ScenarioReader, AutoTakesPrescribedForAFormulaAndAiryOtherwise) {
    EXPECT_EQ(resolve_model(parse(least)).model, ModelChoice::airy);
    for (const char* formula : {"[waves]\nslope = [0.1, 0]\n", "[waves]\nfile = \"a.vti\"\n", "[waves.gerstner]\n"})
        EXPECT_EQ(resolve_model(parse(least + formula)).model, ModelChoice::prescribed) << formula;
    EXPECT_FALSE(resolve_model(parse(least)).reasons.empty());
}

TEST(ScenarioReader, OpenSidesAreWallsButPeriodicForPrescribedAndForASea) {
    const Boundary walls{Side::wall, Side::wall}, periodic{Side::periodic, Side::periodic};
    EXPECT_EQ(resolve_boundary(parse(least)), walls);
    EXPECT_EQ(resolve_boundary(parse(least + "[waves]\nmodel = \"prescribed\"\n")), periodic);
    EXPECT_EQ(resolve_boundary(parse(least + "[waves.spectrum]\n")), periodic);
    EXPECT_EQ(resolve_boundary(parse(least + "[waves.gerstner]\n")), periodic);
    EXPECT_EQ(resolve_boundary(parse(least + "[waves]\nboundary = { y = \"periodic\" }\n")),
              (Boundary{Side::wall, Side::periodic}));
}

TEST(ScenarioReader, FloorPlanCoversTheDomainOrThePartAskedFor) {
    const FloorPlan whole = floor_settings(parse(least + "[caustics.floor]\npixels = [80, 30]\n")).plan;
    EXPECT_EQ(whole.origin_m, glm::dvec2(0, 0));
    EXPECT_EQ(whole.pitch_m, glm::dvec2(0.1, 0.2));
    const std::string part =
        "[caustics.floor]\npixels = [20, 10]\ncentre_m = [3, 2]\nsize_m = [2, 1]\nangle_deg = 90\n";
    const FloorPlan turned = floor_settings(parse(least + part)).plan;
    const glm::dvec2 centre = turned.position_m({10, 5});
    EXPECT_NEAR(centre.x, 3, 1e-12);
    EXPECT_NEAR(centre.y, 2, 1e-12);
    EXPECT_NEAR(turned.position_m({0, 0}).x, 3.5, 1e-12) << "a quarter turn swaps width and height";
    EXPECT_NEAR(turned.position_m({0, 0}).y, 1, 1e-12);
}

class DataFiles : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::create_directories(folder_ / "data");
        std::filesystem::create_directories(folder_ / "scenarios");
        std::ofstream(scenario_path()) << least << "[waves]\nfile = \"sea.vti\"\n";
        unsetenv("WATERLIGHT_DATA");
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        unsetenv("WATERLIGHT_DATA");
    }
    std::filesystem::path scenario_path() const { return folder_ / "scenarios" / "sea.toml"; }
    std::filesystem::path folder_;
};

TEST_F(DataFiles, AreSoughtBesideTheScenarioAndThenBelowTheDataFolder) {
    const auto beside = folder_ / "scenarios" / "sea.vti", below = folder_ / "data" / "sea.vti";
    setenv("WATERLIGHT_DATA", (folder_ / "data").c_str(), 1);
    std::ofstream(below) << "x";
    EXPECT_EQ(read_scenario(scenario_path()).waves.file, below.string());
    std::ofstream(beside) << "x";
    EXPECT_EQ(read_scenario(scenario_path()).waves.file, beside.string());
}

TEST_F(DataFiles, MissingOnesAreReportedWithBothPlacesAndTheVariable) {
    setenv("WATERLIGHT_DATA", (folder_ / "data").c_str(), 1);
    try {
        read_scenario(scenario_path());
        FAIL() << "accepted";
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(scenario_path().string() + ":6:8: waves.file: found no file"), std::string::npos)
            << message;
        EXPECT_NE(message.find((folder_ / "scenarios" / "sea.vti").string()), std::string::npos) << message;
        EXPECT_NE(message.find((folder_ / "data" / "sea.vti").string()), std::string::npos) << message;
        EXPECT_NE(message.find("$WATERLIGHT_DATA"), std::string::npos) << message;
    }
}

TEST(ScenarioMemory, IsEstimatedByCellAndPixelAndRefusedBeforeItIsTaken) {
    const Scenario small = parse(least + "[caustics.floor]\npixels = [10, 10]\n");
    const Scenario large = parse(least + "[caustics.floor]\npixels = [10, 20]\n", {"domain.cells=[640,480]"});
    EXPECT_DOUBLE_EQ(estimate_memory(large).cells, 100 * estimate_memory(small).cells);
    EXPECT_DOUBLE_EQ(estimate_memory(large).pixels, 2 * estimate_memory(small).pixels);
    EXPECT_NO_THROW(check_memory(small, estimate_memory(small).total()));
    EXPECT_THROW(check_memory(small, estimate_memory(small).total() - 1), InputError);
    EXPECT_GT(machine_memory(), 1e6);
}

}  // namespace
}  // namespace waterlight::test
