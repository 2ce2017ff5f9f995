// A run that is killed at any moment goes on to the same bytes; one that is asked to stop does so in good order.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/child.hpp"
#include "tests/support/run_files.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

const std::string common =
    "[domain]\nsize_m = [2.0, 1.5]\ncells = [32, 24]\ndepth_m = 0.3\n"
    "[caustics.floor]\npixels = [32, 24]\n"
    "[output]\nevery_s = 0.05\nprobe_every_s = 0.02\ncheckpoint_every_s = 1e-6\n"
    "formats = [\"vti\", \"png\", \"png16\", \"exr\"]\n"
    "[[probe]]\nname = \"corner\"\nat_m = [0.2, 0.2]\n"
    "[[check]]\nquantity = \"waves.mass_drift\"\nbelow = 1e-3\n";
const std::string disturbed =
    "[[waves.source]]\ntype = \"rain\"\ndrops_per_m2_s = 20\nradius_m = [0.1, 0.2]\nheight_m = [-0.01, -0.002]\n";

struct Kind {
    std::string name, waves;
    std::vector<std::string> arguments = {};
};

void PrintTo(const Kind& kind, std::ostream* stream) { *stream << kind.name; }

const std::vector<Kind> kinds{
    {"linear",
     "[waves]\nmodel = \"linear\"\nduration_s = 0.5\nboundary = { x = \"absorbing\", y = \"wall\" }\n" + disturbed},
    {"airy",
     "[waves]\nmodel = \"airy\"\nduration_s = 0.5\nboundary = { x = \"absorbing\", y = \"wall\" }\n" + disturbed},
    {"shallow", "[waves]\nmodel = \"shallow-water\"\nduration_s = 0.5\nmanning = 0.02\n" + disturbed},
    {"shallow_vulkan",
     "[waves]\nmodel = \"shallow-water\"\nduration_s = 1\n" + disturbed,
     {"--backend", "vulkan", "--validate"}},
    {"estimates",
     "[waves]\nmodel = \"shallow-water\"\nduration_s = 0.5\n" + disturbed + "[accuracy]\nestimate = true\n"},
    {"prescribed", "[waves]\nmodel = \"prescribed\"\nduration_s = 0.5\n[waves.gerstner]\nwaves = 6\n"},
    {"pictures",
     "[waves]\nmodel = \"airy\"\nduration_s = 0.5\n" + disturbed +
         "[picture]\noverlay = \"elevation\"\nrange_high = 0.01\n[camera]\nposition_m = [1.0, -0.5, "
         "0.8]\ntarget_m = [1.0, 0.8, 0.0]\npixels = [24, 16]\n",
     {"--set", "output.image=true"}},
    {"beams", "[waves]\nmodel = \"airy\"\nduration_s = 0.5\n" + disturbed +
                  "[caustics.beams]\ngrid = [16, 12]\nvolume_cells = [16, 12, 4]\n[water]\nabsorption_per_m = 0.1\n"
                  "scattering_per_m = 0.2\n[camera]\nposition_m = [1.0, 0.1, -0.2]\ntarget_m = [1.0, 1.0, "
                  "-0.1]\npixels = [24, 16]\n"}};

class Resume : public ::testing::Test {
  protected:
    explicit Resume(const std::string& waves = kinds[1].waves)
        : scenario_(folder_.write("run.toml", "title = \"resume\"\n" + waves + common)) {}

    std::vector<std::string> arguments(const std::string& out, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"run", scenario_.string(), "--out", (folder_ / out).string()};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Outcome run(const std::string& out, const std::vector<std::string>& more = {}) const {
        return run_program(arguments(out, more));
    }
    Outcome resume(const std::string& out, std::vector<std::string> more = {}) const {
        more.emplace_back("--resume");
        return run(out, more);
    }
    std::string differences_from(const std::string& reference, const std::string& out) const {
        return differences(files_of(folder_ / reference), files_of(folder_ / out));
    }
    /// Killed once there is a checkpoint.
    void leave_checkpoint(const std::string& out, int signal = SIGKILL) const {
        Child child(arguments(out), folder_ / "log");
        ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / out / "checkpoint.bin"); }));
        child.kill(signal);
        child.wait();
        ASSERT_TRUE(fs::exists(folder_ / out / "checkpoint.bin")) << "it ended before it was killed";
    }
    /// One line that holds all of the parts.
    static void expect_one_line(const std::string& output, const std::vector<std::string>& parts) {
        EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
        for (const std::string& part : parts) EXPECT_NE(output.find(part), std::string::npos) << output;
    }

    Scratch folder_{"resume", quick_place()};
    fs::path scenario_;
};

class Killed : public Resume, public ::testing::WithParamInterface<Kind> {
  protected:
    Killed() : Resume(GetParam().waves) {}
};

TEST_P(Killed, AtTwentyMomentsItEndsInTheSameBytes) {
    const std::vector<std::string>& more = GetParam().arguments;
    const auto start = std::chrono::steady_clock::now();
    const Outcome plain = run("plain", more);
    ASSERT_EQ(plain.exit, 0) << plain.output;
    const double whole_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::vector<std::string> with_resume = more;
    with_resume.emplace_back("--resume");
    std::mt19937 random(7);
    std::uniform_real_distribution<double> moment(0, whole_s);
    int went_on = 0, ended = 0;
    // Twenty, and more until some came after a checkpoint.
    for (int kills = 0; kills < 20 || (went_on < 3 && kills < 200);) {
        Child child(arguments("killed", with_resume), folder_ / "log");
        std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
        child.kill(SIGKILL);
        const int exit = child.wait();
        if (child.output().find("going on from") != std::string::npos) ++went_on;
        if (exit == -SIGKILL) {
            ++kills;
            continue;
        }
        ASSERT_EQ(exit, 0) << child.output();
        ++ended;
        ASSERT_EQ(differences_from("plain", "killed"), "") << "after " << kills << " kills";
        fs::remove_all(folder_ / "killed");
    }
    const Outcome last = resume("killed", more);
    ASSERT_EQ(last.exit, 0) << last.output;
    EXPECT_EQ(differences_from("plain", "killed"), "") << "after the kills and " << ended << " ends";
    EXPECT_GE(went_on, 3) << "hardly a kill came after a checkpoint";
}

INSTANTIATE_TEST_SUITE_P(Models, Killed, ::testing::ValuesIn(kinds), [](const auto& kind) { return kind.param.name; });

TEST_F(Resume, WithoutACheckpointItSaysSoAndStartsFromTheBeginning) {
    ASSERT_EQ(run("plain").exit, 0);
    const Outcome outcome = resume("new");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_NE(outcome.output.find("no checkpoint in"), std::string::npos) << outcome.output;
    EXPECT_EQ(differences_from("plain", "new"), "");
}

TEST_F(Resume, AnotherScenarioOrBackEndIsRefusedAndNothingIsTouched) {
    leave_checkpoint("out");
    auto before = files_of(folder_ / "out");
    // What the kill cut off, the next run clears away.
    std::erase_if(before, [](const auto& file) { return file.first.ends_with(".part"); });
    const Outcome other = resume("out", {"--set", "light.elevation_deg=50"});
    EXPECT_EQ(other.exit, 2);
    expect_one_line(other.output, {"checkpoint.bin is of another run", "the scenario or one of its --set differs"});
    const Outcome device = resume("out", {"--backend", "vulkan"});
    EXPECT_EQ(device.exit, 2);
    expect_one_line(device.output, {"the back-end or its device differs"});
    EXPECT_EQ(differences(before, files_of(folder_ / "out")), "");
}

TEST_F(Resume, ADamagedCheckpointIsRefused) {
    leave_checkpoint("out");
    const fs::path file = folder_ / "out" / "checkpoint.bin";
    const std::string whole = read_file(file);
    const auto expect_refused = [&](std::string bytes, const std::string& what) {
        std::ofstream(file, std::ios::binary) << bytes;
        const Outcome outcome = resume("out");
        EXPECT_EQ(outcome.exit, 3);
        expect_one_line(outcome.output, {"checkpoint.bin " + what});
    };
    for (const double place : {0.1, 0.5, 0.999}) {
        std::string damaged = whole;
        damaged[static_cast<std::size_t>(place * static_cast<double>(whole.size()))] ^= 4;
        expect_refused(damaged, "is damaged: its checksum is wrong");
    }
    expect_refused(whole.substr(0, whole.size() / 2), "is damaged: it has");
    expect_refused(whole + "x", "is damaged: it has");
    expect_refused("", "is not a checkpoint");
    expect_refused("[domain]\nsize_m = [1, 1] # and so on, as long as a header\n", "is not a checkpoint");
    std::string newer = whole;
    newer[24] = 2;
    expect_refused(newer, "has format 2; this program reads format 1");
    std::ofstream(file, std::ios::binary) << whole;
    EXPECT_EQ(resume("out").exit, 0) << "the whole one still serves";
}

TEST_F(Resume, AFrameOrARowThatIsGoneIsNamed) {
    leave_checkpoint("out");
    fs::rename(folder_ / "out" / "floor" / "floor_000000.vti", folder_ / "kept");
    const Outcome frame = resume("out");
    EXPECT_EQ(frame.exit, 3);
    expect_one_line(frame.output.substr(frame.output.find('\n') + 1), {"floor_000000.vti", "is gone"});
    fs::rename(folder_ / "kept", folder_ / "out" / "floor" / "floor_000000.vti");
    fs::resize_file(folder_ / "out" / "probes.csv", 10);
    const Outcome row = resume("out");
    EXPECT_EQ(row.exit, 3);
    expect_one_line(row.output.substr(row.output.find('\n') + 1), {"probes.csv", "missing"});
}

TEST_F(Resume, ASignalFinishesTheFrameAndGoesOnLater) {
    ASSERT_EQ(run("plain").exit, 0);
    for (const auto& [signal, name] : {std::pair{SIGINT, "SIGINT"}, std::pair{SIGTERM, "SIGTERM"}}) {
        // No checkpoint but the one that the signal asks for.
        const std::vector<std::string> rare{"--set", "output.checkpoint_every_s=0"};
        ASSERT_EQ(run("plain", rare).exit, 0);
        Child child(arguments("out", rare), folder_ / "log");
        ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / "out" / "surface" / "surface_000001.vti"); }));
        child.kill(signal);
        EXPECT_EQ(child.wait(), 128 + signal) << child.output();
        EXPECT_NE(child.output().find(std::string("waterlight: stopped by ") + name), std::string::npos);
        const auto report = nlohmann::json::parse(read_file(folder_ / "out" / "report.json"));
        EXPECT_EQ(report["interrupted"]["signal"], name);
        EXPECT_EQ(report["interrupted"]["time_s"], report["simulated_s"]);
        EXPECT_TRUE(report["checks"].empty()) << "what is half done is not judged";
        EXPECT_LT(report["simulated_s"].get<double>(), 0.5);
        const Outcome outcome = resume("out", rare);
        EXPECT_EQ(outcome.exit, 0) << outcome.output;
        EXPECT_EQ(differences_from("plain", "out"), "");
        fs::remove_all(folder_ / "out");
    }
}

TEST_F(Resume, ASecondSignalEndsItAtOnce) {
    // The frame after the first takes minutes.
    Child child(arguments("out", {"--set", "waves.model=\"linear\"", "--set", "waves.duration_s=1e5", "--set",
                                  "output.every_s=1e5", "--set", "output.probe_every_s=1e5"}),
                folder_ / "log");
    ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / "out" / "floor.pvd"); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // by now it computes that frame
    child.kill(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(::kill(child.process(), 0), 0) << "the first lets it finish its frame";
    const auto start = std::chrono::steady_clock::now();
    child.kill(SIGTERM);
    EXPECT_EQ(child.wait(), 128 + SIGTERM) << child.output();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST_F(Resume, StartingAnewDropsTheCheckpointAndSaysSo) {
    leave_checkpoint("out");
    const Outcome outcome = run("out");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_NE(outcome.output.find("--resume would have gone on with"), std::string::npos) << outcome.output;
    EXPECT_FALSE(fs::exists(folder_ / "out" / "checkpoint.bin"));
}

}  // namespace
}  // namespace waterlight::test
