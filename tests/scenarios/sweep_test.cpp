// A sweep as a user runs it: 24 settings, killed and started again; bounds, parts and jobs; what it refuses. And a run
// that estimates its own error.
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "sim/vti_reader.hpp"
#include "tests/scenarios/program.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Each result and when it was written.
std::map<std::string, fs::file_time_type> files_of(const fs::path& folder) {
    std::map<std::string, fs::file_time_type> files;
    std::error_code none_yet;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none_yet)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".json") || name.ends_with(".vti"))
            if (!name.starts_with(".")) files[entry.path().string()] = entry.last_write_time();
    }
    return files;
}

std::size_t results_in(const fs::path& out) { return files_of(out / "settings").size(); }

std::size_t rows_of(const fs::path& csv) {
    const std::string text = read_file(csv);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) - 1;
}

class Sweep : public ::testing::Test {
  protected:
    Words arguments(const Words& more = {}) const {
        Words all{"sweep",
                  scenario_,
                  "--out",
                  out_.string(),
                  "--set",
                  "waves.duration_s=0.3",
                  "--vary",
                  "domain.cells=[32,24],[48,36],[64,48]",
                  "--vary",
                  "waves.model=airy,linear",
                  "--vary",
                  "caustics.floor.pixels=[64,48],[128,96]",
                  "--vary",
                  "caustics.floor.window=auto,{samples=5,channels=4}",
                  "--reference-tolerance",
                  "0.02"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Outcome sweep(const Words& more = {}) const { return run_program(arguments(more)); }

    pid_t start(const Words& more = {}) const {
        const Words words = arguments(more);
        std::vector<char*> argv{const_cast<char*>(WATERLIGHT_PROGRAM)};
        for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
        argv.push_back(nullptr);
        pid_t child = 0;
        EXPECT_EQ(posix_spawn(&child, WATERLIGHT_PROGRAM, nullptr, nullptr, argv.data(), environ), 0);
        return child;
    }

    std::string scenario_ = (fs::path(WATERLIGHT_SOURCE) / "scenarios/pool.toml").string();
    Scratch folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
    fs::path out_ = folder_ / "out";
};

TEST_F(Sweep, Of24SettingsKilledAndStartedAgainRepeatsNothing) {
    const pid_t child = start();
    while (results_in(out_) < 4 && waitpid(child, nullptr, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    waitpid(child, nullptr, 0);
    const auto before = files_of(out_);
    const std::size_t had = results_in(out_);
    ASSERT_GE(had, 4U);
    ASSERT_LT(had, 24U) << "it was too quick to be killed";

    const Outcome outcome = sweep({"--tolerance", "0.3"});
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    const auto after = files_of(out_);
    for (const auto& [name, time] : before) {
        ASSERT_TRUE(after.contains(name)) << name;
        EXPECT_EQ(after.at(name), time) << name << " was written again";
    }
    EXPECT_EQ(results_in(out_), 24U);
    EXPECT_EQ(rows_of(out_ / "sweep.csv"), 24U);
    EXPECT_NE(outcome.output.find("The cheapest setting within 30 % is #"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("\n* "), std::string::npos) << "the front is marked";
    EXPECT_NE(read_file(out_ / "sweep.md").find("| domain.cells |"), std::string::npos);
    EXPECT_EQ(read_file(out_ / "sweep.svg").substr(0, 4), "<svg");
    EXPECT_EQ(read_file(out_ / "sweep.png").substr(1, 3), "PNG");

    // Once more: nothing to do.
    ASSERT_EQ(sweep().exit, 0);
    EXPECT_EQ(files_of(out_), after);
}

/// Errors tell what is wrong: waves on few cells, or that ignore dispersion, or light.
TEST_F(Sweep, JudgesWavesAndLightApart) {
    ASSERT_EQ(sweep().exit, 0);
    std::map<std::string, double> waves;  // by cells and model
    for (const auto& [name, time] : files_of(out_ / "settings")) {
        const auto json = nlohmann::json::parse(read_file(name));
        waves[json["overrides"][1].get<std::string>() + " " + json["overrides"][2].get<std::string>()] =
            json["errors"]["waves"];
        EXPECT_GT(json["errors"]["light"].get<double>(), 0.001);
        EXPECT_GT(json["wall_s"]["waves"].get<double>(), 0);
        EXPECT_GT(json["wall_s"]["caustics.floor"].get<double>(), 0);
    }
    ASSERT_EQ(waves.size(), 6U);
    const double fine = waves["domain.cells=[64,48] waves.model=airy"];
    EXPECT_LT(fine, 0.5 * waves["domain.cells=[32,24] waves.model=airy"]);
    EXPECT_GT(waves["domain.cells=[64,48] waves.model=linear"], 3 * fine) << "long waves' speed is wrong here";
}

TEST_F(Sweep, IsBoundedGoesOnAndCollects) {
    Outcome outcome = sweep({"--max-runs", "5"});
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(results_in(out_), 5U);
    EXPECT_NE(outcome.output.find("5 of 24 settings have run"), std::string::npos) << outcome.output;
    EXPECT_EQ(sweep({"--max-time", "0", "--quiet"}).output, "");
    outcome = sweep({"--collect", "--tolerance", "1e-6"});
    EXPECT_EQ(outcome.exit, 0) << "the settings that have not run may be better";
    EXPECT_EQ(rows_of(out_ / "sweep.csv"), results_in(out_));
    EXPECT_EQ(sweep({"--max-runs", "1", "--fresh"}).exit, 0);
    EXPECT_EQ(results_in(out_), 1U);
}

TEST_F(Sweep, PartsAndJobsMakeTheSameWhole) {
    ASSERT_EQ(sweep({"--part", "2/3"}).exit, 0);
    EXPECT_EQ(results_in(out_), 8U);
    EXPECT_FALSE(fs::exists(out_ / "sweep.csv"));
    const auto before = files_of(out_ / "settings");
    const Outcome outcome = sweep({"--jobs", "2", "--tolerance", "1e-6"});
    EXPECT_EQ(outcome.exit, 1) << outcome.output;
    EXPECT_NE(outcome.output.find("No setting is within 0.0001 %; the closest is #"), std::string::npos);
    EXPECT_EQ(rows_of(out_ / "sweep.csv"), 24U);
    const auto after = files_of(out_ / "settings");
    for (const auto& [name, time] : before) EXPECT_EQ(after.at(name), time) << name;
}

/// As of a disk that is full: what is missing is done by the same command later, and nothing is taken for a result.
TEST_F(Sweep, AFileThatMayNotGrowStopsIt) {
    const auto expect_stopped = [&](const Words& more, const std::string& limit) {
        const Outcome stopped = run_program(arguments(more), limit);
        EXPECT_EQ(stopped.exit, 3) << stopped.output;
        EXPECT_NE(stopped.output.find("cannot write " + out_.string()), std::string::npos) << stopped.output;
        EXPECT_EQ(std::count(stopped.output.begin(), stopped.output.end(), '\n'), 1) << stopped.output;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(out_))
            EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path() << " is half written";
    };
    expect_stopped({"--quiet"}, "ulimit -f 4; ");
    EXPECT_EQ(files_of(out_).size(), 0U);
    ASSERT_EQ(sweep({"--max-runs", "1", "--quiet"}).exit, 0);
    fs::remove_all(out_ / "truth");
    expect_stopped({"--quiet"},
                   "ulimit -f 16; ");  // results of settings fit, the light they are judged against does not
    EXPECT_EQ(results_in(out_), 1U);
    EXPECT_EQ(sweep({"--quiet", "--max-runs", "2"}).exit, 0);
    EXPECT_EQ(results_in(out_), 3U);
}

TEST_F(Sweep, KilledItsJobsEndToo) {
    const pid_t child = start({"--jobs", "2"});
    while (results_in(out_) < 2 && waitpid(child, nullptr, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    waitpid(child, nullptr, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const std::size_t had = results_in(out_);
    ASSERT_LT(had, 24U) << "it was too quick to be killed";
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    EXPECT_EQ(results_in(out_), had);
}

TEST_F(Sweep, RefusesAtOnceWhatIsWrong) {
    const std::vector<std::pair<Words, std::string>> wrong{
        {{"--vary", "light.elevation_deg=30,100"}, "--vary light.elevation_deg=100: light.elevation_deg: found 100"},
        {{"--vary", "light.elevation=30"}, "unknown key"},
        {{"--part", "4/3"}, "--part: found \"4/3\""},
        {{"--reference", "domain.cells=[0,0]"}, "domain.cells"},
        {{"--tolerance", "-1"}, "--tolerance"}};
    for (const auto& [more, says] : wrong) {
        const Outcome outcome = sweep(more);
        EXPECT_EQ(outcome.exit, 2) << outcome.output;
        EXPECT_NE(outcome.output.find(says), std::string::npos) << outcome.output;
        EXPECT_EQ(results_in(out_), 0U);
    }
}

// Maps of exact waves: what is left is the light, and the reference is the formula.
TEST(SweepOfAFormula, HasNoErrorOfWavesWhereCellsAreFine) {
    const Scratch folder("formula");
    const std::string scenario = (fs::path(WATERLIGHT_SOURCE) / "scenarios/frozen_sine.toml").string();
    const fs::path out = folder / "out";
    const Outcome outcome =
        run_program({"sweep", scenario, "--out", out.string(), "--vary", "domain.cells=[8,8],[64,16]", "--vary",
                     "caustics.floor.pixels=[64,16]", "--set", "caustics.floor.tolerance=1e-3"});
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("the formula of the waves"), std::string::npos) << outcome.output;
    for (const auto& [name, time] : files_of(out / "settings")) {
        const auto json = nlohmann::json::parse(read_file(name));
        const double waves = json["errors"]["waves"];
        if (json["overrides"][1] == "domain.cells=[64,16]")
            EXPECT_LT(waves, 1e-6);
        else
            EXPECT_GT(waves, 1e-5);
    }
}

// The method is a setting like any other: each is judged by the truth.
TEST(SweepOfMethods, JudgesThemAll) {
    const Scratch folder("methods");
    const std::string scenario = (fs::path(WATERLIGHT_SOURCE) / "scenarios/pool.toml").string();
    const fs::path out = folder / "out";
    const Words words{"sweep",
                      scenario,
                      "--out",
                      out.string(),
                      "--set",
                      "waves.duration_s=0.3",
                      "--set",
                      "domain.cells=[64,48]",
                      "--set",
                      "caustics.floor.pixels=[64,48]",
                      "--set",
                      "caustics.floor.photons={map=256, passes=4}",
                      "--vary",
                      "caustics.floor.method=two-pass,quads,splat,photons,truth",
                      "--reference-tolerance",
                      "0.02"};
    const Outcome outcome = run_program(words);
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    std::map<std::string, double> errors;
    for (const auto& [name, time] : files_of(out / "settings")) {
        const auto json = nlohmann::json::parse(read_file(name));
        errors[json["overrides"].back().get<std::string>()] = json["errors"]["light"];
    }
    ASSERT_EQ(errors.size(), 5U);
    for (const auto& [method, error] : errors) EXPECT_LT(error, 0.3) << method;
    EXPECT_LT(errors["caustics.floor.method=truth"], 0.01);
    EXPECT_GT(errors["caustics.floor.method=photons"], errors["caustics.floor.method=quads"]) << "noise";

    Words with_object = words;
    with_object.insert(with_object.end(), {"--set", "object=[{type=\"sphere\", name=\"s\", centre_m=[1, 1, -1]}]",
                                           "--vary", "light.elevation_deg=30,40"});
    std::erase(with_object, "caustics.floor.method=two-pass,quads,splat,photons,truth");
    std::erase(with_object, "--vary");
    with_object.insert(with_object.end() - 1, "--vary");
    const Outcome refused = run_program(with_object);
    EXPECT_EQ(refused.exit, 2) << refused.output;
    EXPECT_NE(refused.output.find("object: found it in a sweep"), std::string::npos) << refused.output;
}

TEST(ErrorField, IsWrittenBesideIrradianceAndElevationAndCanBeChecked) {
    const Scratch folder("error field");
    const auto scenario = folder.write(
        "small.toml",
        "[domain]\nsize_m = [1.0, 1.0]\ncells = [32, 32]\ndepth_m = 0.5\n[waves]\nmodel = \"linear\"\nduration_s = "
        "0.45\n[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 4\n[caustics.floor]\npixels = [48, 40]\n"
        "[output]\nevery_s = 0.15\nformats = [\"vti\"]\n[accuracy]\nestimate = true\n"
        "[[check]]\nquantity = \"accuracy.floor.estimated_rmse\"\nbelow = 0.3\nabove = 0.001\n"
        "[[check]]\nquantity = \"accuracy.waves.estimated_rmse\"\nbelow = 0.3\nabove = 0.001\n");
    const fs::path out = folder / "out";
    const Outcome outcome = run_program({"run", scenario.string(), "--out", out.string()});
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    const auto report = nlohmann::json::parse(read_file(out / "report.json"));
    const auto relative = [&](const char* file, const char* values) {
        const VtiField error = read_vti(out / file, "error"), field = read_vti(out / file, values);
        double square = 0, norm = 0;
        for (std::size_t n = 0; n < field.values.size(); ++n) {
            const double e = error.values.data()[n], v = field.values.data()[n] - e;
            square += e * e;
            norm += v * v;
        }
        return std::sqrt(square / norm);
    };
    const double floor = report["quantities"]["accuracy.floor.estimated_rmse"];
    const double waves = report["quantities"]["accuracy.waves.estimated_rmse"];
    EXPECT_NEAR(relative("floor/floor_000003.vti", "irradiance"), floor, 1e-3 * floor);
    EXPECT_NEAR(relative("surface/surface_000003.vti", "elevation"), waves, 0.1 * waves) << "that over the RMS of u_h";
    EXPECT_GT(report["wall_s"]["accuracy"].get<double>(), 0);
    const Outcome without =
        run_program({"run", scenario.string(), "--out", out.string(), "--set", "accuracy.estimate=false"});
    EXPECT_EQ(without.exit, 2) << "a check of what is not estimated";
}

}  // namespace
}  // namespace waterlight::test
