// What a run leaves behind, and what it says about itself.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "caustics/kernels/water_colour.hpp"
#include "sim/vti_reader.hpp"
#include "tests/scenarios/program.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

const std::string small =
    "title = \"small\"\n[domain]\nsize_m = [1.0, 1.0]\ncells = [32, 32]\ndepth_m = 0.5\n"
    "[waves]\nduration_s = 0.5\n[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 4\n"
    "[caustics.floor]\npixels = [48, 40]\n[output]\nformats = [\"vti\", \"png\", \"exr\"]\nfields = [\"slope\"]\n"
    "[[probe]]\nname = \"corner\"\nat_m = [0.0, 0.0]\n"
    "[[check]]\nquantity = \"waves.mass_drift\"\nbelow = 1e-6\n";

class Outputs : public ::testing::Test {
  protected:
    Outcome run(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"run", scenario_.string(), "--out", out_.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    }
    nlohmann::json report() const { return nlohmann::json::parse(read_file(out_ / "report.json")); }

    Scratch folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
    fs::path scenario_ = folder_.write("small.toml", small);
    fs::path out_ = folder_ / "out";
};

TEST_F(Outputs, HasEveryFileOfEveryFrame) {
    const Outcome outcome = run();
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    for (const char* file : {"surface.pvd", "floor.pvd", "probes.csv", "report.json"})
        EXPECT_TRUE(fs::exists(out_ / file)) << file;
    const std::vector<const char*> names{"surface/surface_00000{}.vti",   "floor/floor_00000{}.vti",
                                         "images/irradiance_00000{}.png", "images/irradiance_00000{}.exr",
                                         "images/elevation_00000{}.png",  "images/elevation_00000{}.exr"};
    for (int i = 0; i < 6; ++i)
        for (const char* name : names) EXPECT_TRUE(fs::exists(out_ / fmt::format(fmt::runtime(name), i))) << name << i;
    EXPECT_NE(read_file(out_ / "surface/surface_000000.vti").find("\"slope\""), std::string::npos);
    const std::string probes = read_file(out_ / "probes.csv");
    EXPECT_EQ(probes.substr(0, probes.find('\n')), "time_s,corner.elevation_m,corner.irradiance_w_m2");
    EXPECT_EQ(std::count(probes.begin(), probes.end(), '\n'), 7);
}

TEST_F(Outputs, DepthIsStillDepthAndElevation) {
    ASSERT_EQ(run({"--set", "output.fields=[\"depth\"]"}).exit, 0);
    const fs::path last = out_ / "surface/surface_000005.vti";
    const VtiField depth = read_vti(last, "depth"), elevation = read_vti(last, "elevation");
    float highest = 0;
    for (std::size_t i = 0; i < depth.values.size(); ++i) {
        EXPECT_FLOAT_EQ(depth.values.data()[i], 0.5F + elevation.values.data()[i]);
        highest = std::max(highest, elevation.values.data()[i]);
    }
    EXPECT_GT(highest, 0.001F);
}

TEST_F(Outputs, ReportKeepsItsContract) {
    ASSERT_EQ(run({"--set", "title=renamed"}).exit, 0);
    const nlohmann::json r = report();
    for (const char* key : {"version", "scenario", "device", "backend", "model", "steps", "simulated_s", "wall_s",
                            "ledger", "mass_drift_m", "energy_drift", "floor", "checks"})
        EXPECT_TRUE(r.contains(key)) << key;
    for (const char* stage : {"waves", "caustics.floor", "caustics.beams", "render", "export"})
        EXPECT_TRUE(r["wall_s"].contains(stage)) << stage;
    EXPECT_EQ(r["scenario"]["text"], small);
    EXPECT_EQ(r["scenario"]["overrides"][0], "title=renamed");
    EXPECT_EQ(r["scenario"]["title"], "renamed");
    EXPECT_EQ(r["model"]["name"], "airy");
    EXPECT_FALSE(r["model"]["reasons"].empty());
    EXPECT_EQ(r["frames"], 6);
    EXPECT_NEAR(r["simulated_s"].get<double>(), 0.5, 1e-12);
    EXPECT_EQ(r["checks"][0]["name"], "waves.mass_drift");
    EXPECT_EQ(r["checks"][0]["pass"], true);
    const auto ledger = r["ledger"]["last_frame"];
    EXPECT_LT(ledger["closure"].get<double>(), 1e-4);
    EXPECT_NEAR(ledger["incident_w"].get<double>(), 1000, 1e-2) << "1 m2 of sun overhead";
}

TEST_F(Outputs, TheLedgerHasARowAFrameAndClosesInEach) {
    ASSERT_EQ(run({"--set", "caustics.beams.grid=[32,32]", "--set", "water.absorption_per_m=0.3", "--set",
                   "water.scattering_per_m=0.1"})
                  .exit,
              0);
    std::ifstream file(out_ / "ledger.csv");
    std::string line;
    std::getline(file, line);
    EXPECT_NE(line.find("floor.absorbed_w,floor.scattered_w"), std::string::npos) << line;
    EXPECT_NE(line.find("beams.absorbed_w,beams.scattered_w"), std::string::npos) << line;
    int rows = 0;
    for (; std::getline(file, line); ++rows) {
        std::vector<double> v;
        std::istringstream numbers(line);
        for (std::string number; std::getline(numbers, number, ',');) v.push_back(std::stod(number));
        ASSERT_EQ(v.size(), 23U);
        for (const std::size_t first : {1U, 12U}) {
            // incident + entered = all the others but the closure itself.
            double out = 0;
            for (std::size_t k = first + 2; k < first + 10; ++k) out += v[k];
            EXPECT_NEAR(out, v[first] + v[first + 1], 1e-4 * v[first]);
            EXPECT_LT(v[first + 10], 1e-4);
            EXPECT_NEAR(v[first + 3], 3 * v[first + 4], 1e-9 * v[first]) << "absorbed to scattered as 0.3 to 0.1";
            EXPECT_NEAR(v[first], 1000, 1) << "1 m2 of sun overhead";
        }
    }
    EXPECT_EQ(rows, 6);
    EXPECT_LE(report()["ledger"]["worst_closure"].get<double>(), 1e-4);
    EXPECT_LE(report()["beams"]["ledger"]["worst_closure"].get<double>(), 1e-4);
}

TEST_F(Outputs, InColourEachWavelengthHasItsMapAndTheirSumIsTheMap) {
    ASSERT_EQ(run({"--set", "light.colour=\"rgb\"", "--set", "light.disc_deg=0.2665"}).exit, 0);
    const fs::path last = out_ / "floor/floor_000005.vti";
    const VtiField sum = read_vti(last, "irradiance"), red = read_vti(last, "irradiance_650nm"),
                   green = read_vti(last, "irradiance_550nm"), blue = read_vti(last, "irradiance_450nm");
    for (std::size_t i = 0; i < sum.values.size(); ++i)
        EXPECT_NEAR(sum.values.data()[i], red.values.data()[i] + green.values.data()[i] + blue.values.data()[i], 1e-3);
    EXPECT_TRUE(fs::exists(out_ / "images/colour_000005.png"));
    EXPECT_LE(report()["ledger"]["worst_closure"].get<double>(), 1e-4);
}

TEST_F(Outputs, WhatACameraSeesIsWrittenAsNumbersToo) {
    ASSERT_EQ(run({"--set", "water.scattering_per_m=0.1", "--set", "caustics.beams={grid=[16, 16]}", "--set",
                   "camera={position_m=[0.1, 0.5, -0.3], target_m=[0.9, 0.5, -0.3], pixels=[24, 16]}"})
                  .exit,
              0);
    const VtiField seen = read_vti(out_ / "camera/camera_000005.vti", "radiance");
    ASSERT_EQ(glm::ivec2(seen.values.nx(), seen.values.ny()), glm::ivec2(24, 16));
    double sum = 0;
    for (const float radiance : seen.values.values()) sum += radiance;
    const double mean = report()["quantities"]["camera.mean_radiance"];
    EXPECT_GT(mean, 0);
    EXPECT_NEAR(sum / (24 * 16), mean, 1e-6 * mean);
    EXPECT_NE(read_file(out_ / "camera.pvd").find("camera/camera_000003.vti"), std::string::npos);
}

TEST_F(Outputs, WallsHaveTheirMapsInPlaceAndTheirAccount) {
    ASSERT_EQ(run({"--set", "caustics.walls={pixel_m=0.02}", "--set", "light.elevation_deg=40", "--set",
                   "check=[{quantity=\"walls.west\", above=50.0}, {quantity=\"walls.ledger_closure\", below=1e-6}]"})
                  .exit,
              0);
    const std::string series = read_file(out_ / "walls.pvd");
    for (const char* wall : {"west", "east", "south", "north"}) {
        EXPECT_TRUE(fs::exists(out_ / fmt::format("walls/{}_000005.vti", wall))) << wall;
        EXPECT_TRUE(fs::exists(out_ / fmt::format("images/wall_{}_000005.png", wall))) << wall;
        EXPECT_NE(series.find(fmt::format("walls/{}_000003.vti", wall)), std::string::npos) << series;
    }
    const std::string west = read_file(out_ / "walls/west_000000.vti");
    EXPECT_NE(west.find("WholeExtent=\"0 0 0 50 0 30\""), std::string::npos) << west.substr(0, 600);
    EXPECT_LE(report()["walls"]["ledger"]["worst_closure"].get<double>(), 1e-6);
    EXPECT_NE(read_file(out_ / "ledger.csv").find("walls.walls_w"), std::string::npos);
}

TEST_F(Outputs, OfOneWavelengthTheMapIsThatOfOneColourBitForBit) {
    const std::vector<std::string> water{"--set", "water.absorption_by_band_per_m=[0.1]",
                                         "--set", "water.scattering_by_band_per_m=[0.0]",
                                         "--set", "light.wavelengths_nm=[550]"};
    ASSERT_EQ(run(water).exit, 0);
    const VtiField colour = read_vti(out_ / "floor/floor_000005.vti", "irradiance");
    const double index = f64::water_index(550, 20, 0);
    ASSERT_EQ(
        run({"--set", "water.absorption_per_m=0.1", "--set", fmt::format("water.refractive_index={}", index)}).exit, 0);
    const VtiField one = read_vti(out_ / "floor/floor_000005.vti", "irradiance");
    EXPECT_EQ(std::memcmp(one.values.data(), colour.values.data(), one.values.size() * sizeof(float)), 0);
}

TEST_F(Outputs, LastFrameFallsOnTheEndThoughItIsNoMultiple) {
    ASSERT_EQ(run({"--set", "output.every_s=0.2"}).exit, 0);
    EXPECT_EQ(report()["frames"], 4);
    EXPECT_DOUBLE_EQ(report()["simulated_s"], 0.5);
}

TEST_F(Outputs, AFailedCheckExitsOneAfterAllIsWritten) {
    const Outcome outcome = run({"--set", "check[0].below=-1"});
    EXPECT_EQ(outcome.exit, 1);
    EXPECT_NE(outcome.output.find("check FAILED: waves.mass_drift"), std::string::npos) << outcome.output;
    EXPECT_EQ(report()["checks"][0]["pass"], false);
    EXPECT_TRUE(fs::exists(out_ / "floor.pvd"));
}

TEST_F(Outputs, AShorterRunRemovesFramesOfALongerOneButNothingElse) {
    ASSERT_EQ(run().exit, 0);
    std::ofstream(out_ / "images" / "mine.png") << "x";
    std::ofstream(out_ / "notes.txt") << "x";
    ASSERT_EQ(run({"--set", "waves.duration_s=0.2", "--set", "output.formats=[\"png\"]"}).exit, 0);
    EXPECT_TRUE(fs::exists(out_ / "images/irradiance_000002.png"));
    EXPECT_FALSE(fs::exists(out_ / "images/irradiance_000003.png"));
    EXPECT_FALSE(fs::exists(out_ / "images/irradiance_000000.exr"));
    EXPECT_FALSE(fs::exists(out_ / "surface.pvd"));
    EXPECT_FALSE(fs::exists(out_ / "surface/surface_000000.vti"));
    EXPECT_TRUE(fs::exists(out_ / "images/mine.png"));
    EXPECT_TRUE(fs::exists(out_ / "notes.txt"));
}

TEST_F(Outputs, AFolderThatCannotBeMadeExitsThree) {
    const Outcome outcome = run_program({"run", scenario_.string(), "--out", (scenario_ / "out").string()});
    EXPECT_EQ(outcome.exit, 3) << outcome.output;
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
}

TEST_F(Outputs, SaysOneLineASecondOrNothing) {
    EXPECT_EQ(run({"--quiet"}).output, "");
    const Outcome loud = run();
    EXPECT_NE(loud.output.find("frame 6 of 6"), std::string::npos) << loud.output;
    EXPECT_NE(loud.output.find("ParaView"), std::string::npos) << loud.output;
    EXPECT_EQ(loud.output.find('\r'), std::string::npos) << "a bar is for terminals";
}

TEST_F(Outputs, DoNotDependOnTheNumberOfThreads) {
    ASSERT_EQ(run({"--threads", "1"}).exit, 0);
    const std::string one = read_file(out_ / "images/irradiance_000005.exr");
    ASSERT_EQ(run({"--threads", "3"}).exit, 0);
    EXPECT_EQ(read_file(out_ / "images/irradiance_000005.exr"), one);
}

// From still water the elevation of a standing wave at its antinode is a cos(w t), by the dispersion relation.
TEST_F(Outputs, ProbesReadTheWave) {
    ASSERT_EQ(run().exit, 0);
    const double k = 4 * M_PI, tension = 0.0728 / 1000;
    const double w = std::sqrt((9.81 * k + tension * k * k * k) * std::tanh(k * 0.5));
    std::istringstream rows(read_file(out_ / "probes.csv"));
    std::string row;
    std::getline(rows, row);
    for (int i = 0; std::getline(rows, row); ++i)
        EXPECT_NEAR(std::stod(row.substr(row.find(',') + 1)), 0.01 * std::cos(w * 0.1 * i), 1e-6) << row;
}

TEST(Program, HelpAndVersionAreThereForEveryCommand) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"--help"}, {"run", "--help"}, {"sweep", "--help"}, {"schema", "--help"}, {"devices", "--help"}}) {
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.exit, 0);
        EXPECT_NE(outcome.output.find("Example:"), std::string::npos) << outcome.output;
    }
    EXPECT_EQ(run_program({"--version"}).output.substr(0, 11), "waterlight ");
}

TEST(Program, SchemaIsTheReferenceInTheDocs) {
    EXPECT_EQ(run_program({"schema", "--markdown"}).output,
              read_file(fs::path(WATERLIGHT_SOURCE) / "docs/scenario-reference.md"))
        << "run: ./waterlight schema --markdown > docs/scenario-reference.md";
    const auto json = nlohmann::json::parse(run_program({"schema", "--json"}).output);
    EXPECT_GT(json["keys"].size(), 50U);
}

TEST(Program, DevicesNamesTheProcessorAndTheChoice) {
    const Outcome outcome = run_program({"devices"});
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.output.substr(0, 3), "cpu");
    EXPECT_NE(outcome.output.find("--backend auto takes"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace waterlight::test
