// What a run of the model shallow-water leaves behind, and what it says about itself.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/vti_reader.hpp"
#include "tests/scenarios/program.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

/// A wave runs up a beach that begins at x = 2 and is at still water's height at x = 3.
const std::string beach =
    "title = \"beach\"\n[domain]\nsize_m = [4.0, 0.5]\ncells = [160, 20]\ndepth_m = 0.1\n"
    "[[domain.ground]]\ntype = \"beach\"\nat_m = [2.0, 0.0]\nslope = 0.1\n"
    "[waves]\nmodel = \"shallow-water\"\nduration_s = 3.0\n"
    "[[waves.initial]]\ntype = \"dam\"\nat_m = [0.5, 0.0]\nbehind_level_m = 0.04\n"
    "[output]\nevery_s = 0.5\nprobe_every_s = 0.125\nformats = [\"vti\", \"png\"]\n"
    "fields = [\"velocity\", \"depth\", \"max_elevation\", \"arrival_time\"]\n"
    "[[probe]]\nname = \"deep\"\nat_m = [1.5, 0.25]\n[[probe]]\nname = \"shore\"\nat_m = [3.02, 0.25]\n"
    "[[probe]]\nname = \"hill\"\nat_m = [3.9, 0.25]\n"
    "[[check]]\nquantity = \"waves.volume_drift\"\nbelow = 1e-5\n";

std::vector<std::vector<std::string>> rows_of(const fs::path& table) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(read_file(table));
    for (std::string line; std::getline(text, line);) {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
}

class ShallowOutputs : public ::testing::Test {
  protected:
    Outcome run(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"run", scenario_.string(), "--out", out_.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    }
    nlohmann::json report() const { return nlohmann::json::parse(read_file(out_ / "report.json")); }

    Scratch folder_{std::string("shallow ") + testing::UnitTest::GetInstance()->current_test_info()->name()};
    fs::path scenario_ = folder_.write("beach.toml", beach);
    fs::path out_ = folder_ / "out";
};

TEST_F(ShallowOutputs, SurfaceHasVelocityAndDepthAndGroundWhereItIsDry) {
    const Outcome outcome = run();
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    const fs::path first = out_ / "surface/surface_000000.vti";
    EXPECT_NE(read_file(first).find("\"velocity\""), std::string::npos);
    const VtiField elevation = read_vti(first, "elevation"), depth = read_vti(first, "depth");
    EXPECT_NEAR(elevation.values(0, 0), 0.04, 1e-6);
    EXPECT_NEAR(depth.values(0, 0), 0.14, 1e-6);
    EXPECT_NEAR(elevation.values(159, 5), 0.1 * (4 - 0.0125 - 2) - 0.1, 1e-6);
    EXPECT_EQ(depth.values(159, 5), 0);
}

TEST_F(ShallowOutputs, ExtremesAreWrittenOnceWithTheGround) {
    ASSERT_EQ(run().exit, 0);
    const fs::path file = out_ / "extremes.vti";
    const VtiField highest = read_vti(file, "max_elevation"), arrival = read_vti(file, "arrival_time");
    const VtiField bed = read_vti(file, "bed");
    EXPECT_EQ(arrival.time_s, 3.0);
    EXPECT_EQ(read_file(file).find("\"max_speed\""), std::string::npos) << "not asked for";
    EXPECT_NEAR(bed.values(0, 0), -0.1, 1e-6);
    EXPECT_GE(highest.values(0, 5), 0.04F - 1e-6F);
    EXPECT_TRUE(std::isnan(highest.values(159, 5))) << "never wet";
    EXPECT_TRUE(std::isnan(arrival.values(159, 5)));
    // A wave of 1 m/s and a little more comes from the dam at x = 0.5.
    EXPECT_GT(arrival.values(60, 5), 0.5F);
    EXPECT_LT(arrival.values(60, 5), 1.0F);
    ASSERT_EQ(run({"--set", "output.fields=[\"depth\"]"}).exit, 0);
    EXPECT_FALSE(fs::exists(file)) << "that of the longer run is gone";
}

TEST_F(ShallowOutputs, RunupLineCrossesTheBeachWhereTheReportSaysItIsHighest) {
    ASSERT_EQ(run().exit, 0);
    const auto rows = rows_of(out_ / "runup.csv");
    EXPECT_EQ(rows.at(0), (std::vector<std::string>{"line", "x_m", "y_m", "elevation_m"}));
    ASSERT_GE(rows.size(), 21U);
    const double highest = report()["quantities"]["waves.max_runup"];
    EXPECT_GT(highest, 0.0);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].at(0), "0") << "one line from side to side";
        const double x = std::stod(rows[i].at(1)), ground = std::stod(rows[i].at(3));
        EXPECT_NEAR(ground, 0.1 * (x - 2) - 0.1, 1e-6);
        EXPECT_NEAR(ground, highest, 0.0025 + 1e-6) << "within a cell of 25 mm on a slope of 1 : 10";
    }
    const double area = report()["quantities"]["waves.inundated_area"];
    EXPECT_NEAR(area, (highest / 0.1 + 0.0125) * 0.5, 0.5 * 0.025);
}

TEST_F(ShallowOutputs, ProbesAreReadBetweenFramesToo) {
    ASSERT_EQ(run().exit, 0);
    const auto rows = rows_of(out_ / "probes.csv");
    ASSERT_EQ(rows.size(), 26U) << "3 s by 0.125 s, the start and the heading";
    for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_NEAR(std::stod(rows[i][0]), 0.125 * (i - 1.0), 1e-12);
    EXPECT_FALSE(fs::exists(out_ / "surface/surface_000007.vti"));
    EXPECT_NEAR(std::stod(rows[1][2]), 0.1 * 1.025 - 0.1 - 0.0005, 0.0025) << "dry ground has its own height";
    const auto q = report()["quantities"];
    double highest = -1;
    for (std::size_t i = 1; i < rows.size(); ++i) highest = std::max(highest, std::stod(rows[i][1]));
    EXPECT_EQ(q["probe.deep.max_elevation"].get<double>(), highest);
    EXPECT_GT(q["probe.deep.arrival_time"].get<double>(), 0.5);
    EXPECT_GT(q["probe.shore.arrival_time"].get<double>(), q["probe.deep.arrival_time"].get<double>());
    EXPECT_TRUE(q["probe.hill.arrival_time"].is_null()) << "the water never came there";
}

TEST_F(ShallowOutputs, ReportTellsWhatIsConservedAndWhatIsNot) {
    ASSERT_EQ(run().exit, 0);
    const auto closed = report();
    EXPECT_LT(closed["quantities"]["waves.volume_drift"].get<double>(), 1e-5);
    EXPECT_FALSE(closed["energy_drift"].is_null());
    EXPECT_NEAR(closed["shallow_water"]["start"]["volume_m3"].get<double>(), 0.5 * (0.1 * 2 + 0.05 + 0.04 * 0.5), 1e-5);
    EXPECT_EQ(closed["quantities"]["waves.min_depth"], 0.0);
    EXPECT_TRUE(closed["quantities"]["waves.exact_l1"].is_null());
    ASSERT_EQ(run({"--set", "waves.boundary.west=absorbing", "--set", "check=[]"}).exit, 0);
    EXPECT_TRUE(report()["quantities"]["waves.volume_drift"].is_null());
    EXPECT_TRUE(report()["energy_drift"].is_null());
    ASSERT_EQ(run({"--set", "waves.manning=0.03"}).exit, 0);
    EXPECT_TRUE(report()["energy_drift"].is_null()) << "friction takes energy";
}

TEST_F(ShallowOutputs, TheTruthBesideItIsOfTheCpu) {
    const std::vector<std::string> truth{"--set", "caustics.floor={method=\"truth\", pixels=[8,8]}",
                                         "--set", "waves.duration_s=0.25",
                                         "--set", "output.every_s=0.25"};
    std::vector<std::string> on_vulkan = truth;
    on_vulkan.insert(on_vulkan.end(), {"--backend", "vulkan"});
    const Outcome refused = run(on_vulkan);
    EXPECT_EQ(refused.exit, 2);
    EXPECT_NE(refused.output.find("--backend: found vulkan beside method = \"truth\"; allowed: auto or cpu"),
              std::string::npos)
        << refused.output;
    const Outcome taken = run(truth);
    ASSERT_EQ(taken.exit, 0) << taken.output;
    EXPECT_EQ(report()["backend"]["name"], "cpu");
    EXPECT_EQ(report()["backend"]["reason"], "the truth is computed in double precision on the CPU");
}

TEST_F(ShallowOutputs, ABadDataFileIsNamedWithItsLine) {
    const fs::path wave = folder_.write("wave.txt", "time elevation\n0 0\n1 0.1\n0.5 0.2\n");
    const Outcome outcome = run({"--set", "check=[]", "--set", "waves.boundary.west=inflow", "--set",
                                 "waves.inflow[0]={type=\"wave\", side=\"west\", file=\"wave.txt\"}"});
    EXPECT_EQ(outcome.exit, 2) << outcome.output;
    EXPECT_NE(outcome.output.find(wave.string() + ":4"), std::string::npos) << outcome.output;
    EXPECT_FALSE(fs::exists(out_));
}

// Between frames the light is made for the probes alone.
TEST(ProbeRows, BetweenFramesHaveTheirIrradiance) {
    const Scratch folder("probe rows");
    const fs::path scenario = folder.write(
        "rows.toml",
        "[domain]\nsize_m = [1.0, 1.0]\ncells = [16, 16]\ndepth_m = 0.5\n[waves]\nduration_s = 0.35\n"
        "[[waves.standing]]\namplitude_m = 0.01\n[caustics.floor]\npixels = [16, 16]\n"
        "[output]\nevery_s = 0.1\nprobe_every_s = 0.03\nformats = []\n[[probe]]\nname = \"a\"\nat_m = [0.5, 0.5]\n");
    const Outcome outcome = run_program({"run", scenario.string(), "--out", (folder / "out").string()});
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    const auto rows = rows_of(folder / "out/probes.csv");
    std::vector<double> times;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        times.push_back(std::stod(rows[i][0]));
        EXPECT_NEAR(std::stod(rows[i].at(2)), 979, 30) << "near that of flat water: " << rows[i][0];
    }
    const std::vector<double> expected{0,   0.03, 0.06, 0.09, 0.1, 0.12, 0.15, 0.18,
                                       0.2, 0.21, 0.24, 0.27, 0.3, 0.33, 0.35};
    ASSERT_EQ(times.size(), expected.size());
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], 1e-12);
}

TEST(ProbeRows, InTheWaterHaveScalarIrradianceToo) {
    const Scratch folder("probes in the water");
    const fs::path scenario =
        folder.write("rows.toml",
                     "[domain]\nsize_m = [1.0, 1.0]\ncells = [16, 16]\ndepth_m = 0.5\n[waves]\nslope = [0.0, 0.0]\n"
                     "duration_s = 0.1\n[light]\nelevation_deg = 30.0\n[caustics.beams]\ngrid = [8, 8]\n"
                     "[output]\nevery_s = 0.1\nprobe_every_s = 0.05\nformats = []\n"
                     "[[probe]]\nname = \"a\"\nat_m = [0.5, 0.5]\ndepth_m = 0.25\n"
                     "[[check]]\nquantity = \"probe.a.scalar_irradiance\"\nequals = 618.30\ntolerance = 0.1\n");
    const Outcome outcome = run_program({"run", scenario.string(), "--out", (folder / "out").string()});
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    const auto rows = rows_of(folder / "out/probes.csv");
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0].at(3), "a.scalar_irradiance_w_m2");
    // Flat water, the sun at 30 degrees: the light goes down at 49.5 degrees, and lights a plane that faces it by more.
    for (std::size_t i = 1; i < rows.size(); ++i)
        EXPECT_NEAR(std::stod(rows[i].at(2)) / std::stod(rows[i].at(3)), std::sqrt(1 - .75 * 9 / 16), 1e-4);
}

}  // namespace
}  // namespace waterlight::test
