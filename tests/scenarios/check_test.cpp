// The command `check`: what it runs, what it says, what it exits with.
#include <gtest/gtest.h>

#include <algorithm>

#include "gpu/device.hpp"
#include "tests/scenarios/program.hpp"
#include "tests/support/child.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

/// A standing wave of 0.01 m and light on its floor, a fraction of a second to run.
const std::string standing =
    "# A comment of the author's\n"
    "[domain]\nsize_m = [2.0, 1.0]\ncells = [32, 16]\ndepth_m = 1.0\n"
    "[waves]\nmodel = \"linear\"\nduration_s = 1.0\n[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 2\n"
    "[caustics.floor]\npixels = [64, 32]\n[output]\nevery_s = 0.05\nprobe_every_s = 0.01\n"
    "[[probe]]\nname = \"g\"\nat_m = [0.03125, 0.5]\n";

std::string check(const std::string& quantity, const std::string& expects) {
    return "[[check]]\nquantity = \"" + quantity + "\"\n" + expects + "\n";
}

std::string command(const std::string& text) {
    std::FILE* pipe = popen((text + " 2>&1").c_str(), "r");
    std::string output;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        output.append(buffer.data(), count);
    return pclose(pipe) == 0 ? output : "failed: " + output;
}

/// As Python's reader of XML sees it.
std::string read_junit(const fs::path& file) {
    return command("/usr/bin/python3 " + quoted(WATERLIGHT_SOURCE "/tests/support/read_junit.py") + " " +
                   quoted(file.string()));
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// Where a check stands that follows the scenario above.
const std::string first_line_of_check = std::string(":").append(std::to_string(count(standing, "\n") + 1)).append(":1");

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Each kind of check with an expectation that holds and one that does not, a little beyond it.
struct Pair {
    const char* name;
    const char* quantity;
    const char* holds;
    const char* fails;
    bool needs_vulkan = false;
};

void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.name; }

class Comparison : public ::testing::TestWithParam<Pair> {};

TEST_P(Comparison, PassesAndFails) {
    const Pair& pair = GetParam();
    if (pair.needs_vulkan && !gpu::survey().chosen) GTEST_SKIP() << "needs a Vulkan device";
    const Scratch folder(std::string("check ") + pair.name);
    folder.write("same.toml", standing);
    const fs::path good = folder.write("good.toml", standing + check(pair.quantity, pair.holds));
    const fs::path bad = folder.write("bad.toml", standing + check(pair.quantity, pair.fails));
    const Outcome passed = run_program({"check", good.string()}), failed = run_program({"check", bad.string()});
    EXPECT_EQ(passed.exit, 0) << passed.output;
    EXPECT_TRUE(has(passed.output, "1 check of 1 scenario: 1 passed")) << passed.output;
    EXPECT_EQ(failed.exit, 1) << failed.output;
    EXPECT_TRUE(has(failed.output, "FAILED " + bad.string() + first_line_of_check)) << failed.output;
    EXPECT_TRUE(has(failed.output, "value ") && has(failed.output, "expected ")) << failed.output;
}

// The exact elevation at (0.03125, 0.5) is 0.0099518 cos(9.83987 t); linear's grid of 32 cells is off by 1e-3.
INSTANTIATE_TEST_SUITE_P(
    All, Comparison,
    ::testing::Values(
        Pair{"Equals", "probe.g.elevation", "at_s = 0.0\nequals = 0.0099518\ntolerance = 1e-6",
             "at_s = 0.0\nequals = 0.0099518\ntolerance = 1e-9"},
        Pair{"EqualsRelative", "waves.volume", "equals = 2.0\nrelative_tolerance = 1e-4",
             "equals = 2.001\nrelative_tolerance = 4e-4"},
        Pair{"Below", "surface.elevation.max", "at_s = 0.0\nbelow = 0.00998", "at_s = 0.0\nbelow = 0.00995"},
        Pair{"Above", "surface.elevation.max", "at_s = 0.0\nabove = 0.00995", "at_s = 0.0\nabove = 0.00998"},
        Pair{"Between", "floor.mean_irradiance", "between = [979.0, 980.0]", "between = [980.0, 981.0]"},
        Pair{"TimeBetweenFrames", "probe.g.elevation", "at_s = 0.319\nequals = -0.00995\ntolerance = 2e-5",
             "at_s = 0.339\nequals = -0.00995\ntolerance = 2e-5"},
        Pair{"WindowMean", "probe.g.elevation", "window_s = [0.0, 0.63]\nequals = 0.0\ntolerance = 2e-4",
             "window_s = [0.0, 0.48]\nequals = 0.0\ntolerance = 2e-4"},
        Pair{"WindowRms", "probe.g.elevation",
             "window_s = [0.0, 0.63]\nover = \"rms\"\nequals = 0.00704\ntolerance = 1e-4",
             "window_s = [0.0, 0.30]\nover = \"max\"\nequals = 0.00704\ntolerance = 1e-4"},
        Pair{"WindowMin", "floor.cv", "window_s = [0.1, 0.9]\nover = \"min\"\nbelow = 0.002",
             "window_s = [0.1, 0.9]\nover = \"max\"\nbelow = 0.002"},
        Pair{"Exact", "surface.elevation.relative_l2", "reference = \"exact\"\nbelow = 0.02",
             "reference = \"exact\"\nbelow = 1e-3"},
        Pair{"Ledger", "floor.ledger.incident", "equals = 2000.0\ntolerance = 1.0", "equals = 1990.0\ntolerance = 1.0"},
        Pair{"Energy", "waves.energy", "equals = 0.4905\nrelative_tolerance = 0.01",
             "equals = 0.981\nrelative_tolerance = 0.01"},
        Pair{"Spectrum", "probe.g.significant_height", "equals = 0.0282\ntolerance = 1e-3",
             "equals = 0.0141\ntolerance = 1e-3"},
        Pair{"AnotherScenario", "surface.elevation.relative_linf",
             "at_s = 0.4\nreference = \"same.toml\"\nbelow = 1e-9",
             "at_s = 0.4\nreference = \"same.toml\"\nabove = 1e-9"},
        Pair{"Order", "surface.elevation.l2",
             "reference = \"exact\"\norder = { key = \"domain.cells\", values = [[16, 8], [32, 16], [64, 32]], "
             "at_least = 1.9 }",
             "reference = \"exact\"\norder = { key = \"domain.cells\", values = [[16, 8], [32, 16], [64, 32]], "
             "at_least = 2.1 }"},
        Pair{"OrderInAStep", "simulated_s",
             "order = { key = \"waves.duration_s\", values = [0.5, 1.0], at_least = 0.999 }",
             "order = { key = \"waves.duration_s\", values = [0.5, 1.0], at_least = 1.001 }"},
        Pair{"AgreementOfNumbers", "floor.cv", "agrees = { backend = \"vulkan\", relative_tolerance = 1e-4 }",
             "agrees = { backend = \"vulkan\", relative_tolerance = 1e-14 }", true},
        Pair{"AgreementOfFields", "floor.irradiance.relative_l2", "agrees = { backend = \"vulkan\", tolerance = 1e-4 }",
             "agrees = { backend = \"vulkan\", tolerance = 1e-14 }", true}),
    [](const auto& pair) { return pair.param.name; });

class Check : public ::testing::Test {
  protected:
    Check() : folder_(::testing::UnitTest::GetInstance()->current_test_info()->name()) {}
    fs::path write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / name).parent_path());
        return folder_.write(name, text);
    }
    static Outcome run(std::vector<std::string> arguments, const std::string& environment = "") {
        arguments.insert(arguments.begin(), "check");
        return run_program(arguments, environment);
    }
    std::string path(const std::string& name = "") const { return (folder_ / name).string(); }

    Scratch folder_;
};

const std::string holds = check("waves.volume", "equals = 2.0\ntolerance = 1e-6");
const std::string fails = check("waves.volume", "equals = 3.0\ntolerance = 1e-3");

TEST_F(Check, FieldsAndPicturesOfBothBackendsAgree) {
    if (!gpu::survey().chosen) GTEST_SKIP() << "needs a Vulkan device";
    const std::string water =
        "[water]\nscattering_per_m = 0.1\n[caustics.beams]\ngrid = [16, 8]\nvolume_cells = [16, 8, 4]\n"
        "[camera]\nposition_m = [0.1, 0.5, -0.5]\ntarget_m = [1.9, 0.5, -0.5]\npixels = [48, 32]\n";
    const auto agree = [](const std::string& quantity, const char* tolerance) {
        return check(quantity,
                     std::string("agrees = { backend = \"vulkan\", relative_tolerance = ") + tolerance + " }");
    };
    const std::string scene = standing + water;
    const std::string field = "volume.scalar_irradiance.relative_l2", picture = "camera.radiance.relative_l2";
    const std::string agreeing = agree("volume.plane_irradiance.max", "1e-4") + agree("camera.mean_radiance", "1e-2") +
                                 check(field, "agrees = { backend = \"vulkan\", tolerance = 1e-4 }") +
                                 check(picture, "agrees = { backend = \"vulkan\", tolerance = 1e-2 }");
    const Outcome good = run({write("a.toml", scene + agreeing).string()});
    EXPECT_EQ(good.exit, 0) << good.output;
    EXPECT_TRUE(has(good.output, "4 passed")) << good.output;
    for (const std::string& unequal :
         {agree("camera.mean_radiance", "1e-15"), check(field, "agrees = { backend = \"vulkan\", tolerance = 1e-15 }"),
          check(picture, "agrees = { backend = \"vulkan\", tolerance = 1e-15 }")}) {
        const Outcome bad = run({write("b.toml", scene + unequal).string()});
        EXPECT_EQ(bad.exit, 1) << bad.output;
        EXPECT_TRUE(has(bad.output, "1 failed")) << bad.output;
    }
}

TEST_F(Check, FindsScenariosBelowAFolderAndPassesOverOtherFiles) {
    write("a.toml", standing + holds);
    write("deep/er/b.toml", standing + holds);
    write("none.toml", standing);
    write("package.toml", "[package]\nname = \"something else\"\n");
    const Outcome outcome = run({path()});
    EXPECT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "2 checks of 2 scenarios: 2 passed")) << outcome.output;
    EXPECT_FALSE(fs::exists("out/a")) << "nothing is left where it was started";
}

TEST_F(Check, SeveralAtOnceSayTheSameAsOneByOne) {
    for (const char* name : {"a", "b", "c", "d", "e"})
        write(std::string(name) + ".toml", standing + (*name == 'c' ? fails : holds));
    const auto table = [&](const char* jobs) {
        const std::string output = run({path(), "--quiet", "--jobs", jobs}).output;
        return output.substr(0, output.find("5 checks"));
    };
    EXPECT_EQ(table("1"), table("4"));
    EXPECT_EQ(count(table("4"), "passed"), 4);
}

TEST_F(Check, TheCommandOfAFailureRepeatsIt) {
    const fs::path file = write("it's.toml", standing + holds + fails);
    const Outcome first = run({file.string(), "--set", "waves.duration_s=0.5"});
    EXPECT_EQ(first.exit, 1) << first.output;
    const std::size_t at = first.output.find("repeat: ");
    ASSERT_NE(at, std::string::npos) << first.output;
    const std::string repeat = first.output.substr(at + 8, first.output.find('\n', at) - at - 8);
    const std::string again = command(repeat);
    EXPECT_TRUE(has(again, "value 2, expected = 3 within 0.001")) << again;
}

TEST_F(Check, FilterTakesSomeAndLeavesTheRest) {
    write("a.toml", standing + fails + check("floor.cv", "below = 1.0"));
    write("b.toml", standing + check("floor.cv", "below = 1.0"));
    const Outcome both = run({path(), "--filter", "*/floor.*"}), one = run({path(), "--filter", "b/*"});
    EXPECT_EQ(both.exit, 0) << both.output;
    EXPECT_TRUE(has(both.output, "2 checks of 2 scenarios")) << both.output;
    EXPECT_TRUE(has(one.output, "1 check of 1 scenario: 1 passed")) << one.output;
    const Outcome none = run({path(), "--filter", "c/*"});
    EXPECT_EQ(none.exit, 2);
    EXPECT_TRUE(has(none.output, "--filter: found \"c/*\"; allowed: ")) << none.output;
}

TEST_F(Check, AWrongScenarioIsNamedBeforeAnythingRunsAndTheOthersStillRun) {
    write("a.toml", standing + holds);
    write("b.toml", standing + check("floor.cw", "below = 1.0"));
    write("c.toml", "[[check]]\nquantity =\n");
    const Outcome outcome = run({path(), "--junit", path("j.xml")});
    EXPECT_EQ(outcome.exit, 2) << outcome.output;
    EXPECT_LT(outcome.output.find("did you mean \"floor.cv\"?"), outcome.output.find("1 of 1 scenarios"))
        << outcome.output;
    EXPECT_TRUE(has(outcome.output, "1 check of 3 scenarios: 1 passed, 2 scenarios wrong")) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "c.toml:2:")) << outcome.output;
    EXPECT_TRUE(has(read_junit(path("j.xml")), "case b | scenario | error ")) << read_junit(path("j.xml"));
}

TEST_F(Check, APathThatLeadsNowhereIsRefused) {
    EXPECT_EQ(run({path("missing.toml")}).exit, 2);
    EXPECT_EQ(run({path()}).exit, 2) << "a folder without a scenario";
    EXPECT_EQ(run({write("plain.toml", standing).string()}).exit, 2) << "a scenario without a check";
}

TEST_F(Check, ARunThatFailsLeavesItsChecksWithoutAValue) {
    const fs::path file = write("a.toml", standing + holds);
    const Outcome outcome = run({file.string()}, "ulimit -f 4; ");  // 2 kB: less than it writes
    EXPECT_EQ(outcome.exit, 3) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "ERROR " + file.string())) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "1 check of 1 scenario: 0 passed, 1 without a value")) << outcome.output;
}

/// One that is done at once and, after it in the order of names, one that takes minutes.
class CheckOfALongRun : public Check {
  protected:
    CheckOfALongRun() {
        write("a.toml", standing + holds);
        write("b.toml", "[check_run]\nset = [\"waves.duration_s=1e4\"]\n" + standing + holds + fails);
    }
    bool has_begun(const std::string& out) const {
        return wait_until([&] { return !read_file(path(out + "/b/run/.waterlight.lock")).empty(); });
    }
};

class StoppedCheck : public CheckOfALongRun, public ::testing::WithParamInterface<int> {};

TEST_P(StoppedCheck, EndsItsRunsAndSaysWhatIsDone) {
    ChildLimits limits;
    limits.environment = {"TMPDIR=" + path("tmp")};
    fs::create_directories(path("tmp"));
    Child child({"check", path("a.toml"), path("b.toml"), "--jobs", "1", "--junit", path("j.xml")}, path("log"),
                limits);
    const std::string own = "tmp/waterlight-check-" + std::to_string(child.process());
    ASSERT_TRUE(has_begun(own)) << child.output();
    child.kill(GetParam());
    EXPECT_EQ(child.wait(), 128 + GetParam()) << child.output();
    const std::string output = child.output(), name = GetParam() == SIGINT ? "SIGINT" : "SIGTERM";
    EXPECT_TRUE(fs::is_empty(path("tmp"))) << output;
    EXPECT_TRUE(has(output, "stopped b/waves.volume: stopped by " + name)) << output;
    EXPECT_TRUE(has(output, "3 checks of 2 scenarios: 1 passed, 2 stopped")) << output;
    EXPECT_TRUE(has(output, "waterlight: stopped by " + name + ": 2 of 3 checks were not judged")) << output;
    const std::string junit = read_junit(path("j.xml"));
    EXPECT_TRUE(has(junit, "case b | waves.volume = 2 | skipped stopped by " + name)) << junit;
}

INSTANTIATE_TEST_SUITE_P(By, StoppedCheck, ::testing::Values(SIGINT, SIGTERM),
                         [](const auto& by) { return by.param == SIGINT ? "SIGINT" : "SIGTERM"; });

TEST_F(CheckOfALongRun, IsStoppedAfterItsTimeout) {
    const Outcome outcome = run({path("b.toml"), "--timeout", "1.5", "--junit", path("j.xml")});
    EXPECT_EQ(outcome.exit, 3) << outcome.output;
    const std::string says = "waves.volume: stopped: the scenario takes longer than --timeout 1.5";
    EXPECT_EQ(count(outcome.output, says), 2) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "2 checks of 1 scenario: 0 passed, 2 without a value")) << outcome.output;
    EXPECT_TRUE(has(read_junit(path("j.xml")), "case b | waves.volume = 2 | error " + says))
        << read_junit(path("j.xml"));
    EXPECT_EQ(run({path("a.toml"), "--timeout", "0"}).exit, 2);
}

/// Stopped in the midst of everything, by a signal it does not heed.
TEST_F(CheckOfALongRun, IsKilledAfterItsTimeoutWhereItHangs) {
    Child child({"check", path("b.toml"), "--timeout", "2", "--out", path("out")}, path("log"));
    ASSERT_TRUE(has_begun("out")) << child.output();
    const int run = std::stoi(read_file(path("out/b/run/.waterlight.lock")));
    ::kill(run, SIGSTOP);
    EXPECT_EQ(child.wait(), 3) << child.output();
    EXPECT_TRUE(has(child.output(), "the scenario takes longer than --timeout 2")) << child.output();
    EXPECT_EQ(::kill(run, 0), -1) << "it is gone";
}

TEST_F(Check, AFolderThatCannotBeMadeIsAFailureOfTheWorld) {
    const fs::path file = write("a.toml", standing + holds);
    write("taken", "a file where a folder must be");
    EXPECT_EQ(run({file.string(), "--out", path("taken")}).exit, 3);
}

TEST_F(Check, JunitIsReadByOthersWhateverTheNamesContain) {
    write("a<b>&\"c'.toml", standing + holds + fails);
    write("d.toml", standing + check("floor.cv", "above = 0.0"));
    const Outcome outcome = run({path(), "--junit", path("out/j.xml")});
    EXPECT_EQ(outcome.exit, 1) << outcome.output;
    const std::string seen = read_junit(path("out/j.xml"));
    EXPECT_TRUE(has(seen, "suite a<b>&\"c' ")) << seen;
    EXPECT_TRUE(has(seen, "case a<b>&\"c' | waves.volume = 2 | passed")) << seen;
    EXPECT_TRUE(
        has(seen, "case a<b>&\"c' | waves.volume = 3 | failure waves.volume: value 2, expected = 3 within 0.001"))
        << seen;
    EXPECT_TRUE(has(seen, "case d | floor.cv > 0 | passed")) << seen;
}

TEST_F(Check, UpdateWritesWhatFailedAndNothingElse) {
    const std::string text =
        standing + holds + "[[check]]\nequals   =  3.0 # as measured\nquantity = \"waves.volume\"\ntolerance = 1e-3\n" +
        check("floor.cv", "below = 0.0");
    const fs::path file = write("a.toml", text);
    EXPECT_EQ(run({file.string()}).exit, 1);
    EXPECT_EQ(read_file(file), text) << "without --update a scenario is not touched";
    const Outcome outcome = run({file.string(), "--update"});
    EXPECT_EQ(outcome.exit, 1) << "a bound is not updated: " << outcome.output;
    EXPECT_TRUE(has(outcome.output, "-equals   =  3.0 # as measured\n+equals   =  2.0 # as measured\n"))
        << outcome.output;
    EXPECT_TRUE(has(outcome.output, "updated a/waves.volume: 3.0 -> 2.0")) << outcome.output;
    std::string expected = text;
    expected.replace(expected.find("3.0 # as"), 3, "2.0");
    EXPECT_EQ(read_file(file), expected);
    EXPECT_EQ(run({file.string(), "--filter", "a/waves.volume"}).exit, 0);
}

TEST_F(Check, UpdateKeepsDigitsEnoughToPass) {
    const fs::path file = write("a.toml", standing + check("probe.g.elevation", "equals = 1.0\ntolerance = 1e-9"));
    EXPECT_EQ(run({file.string(), "--update"}).exit, 0);
    EXPECT_EQ(run({file.string()}).exit, 0) << read_file(file);
}

TEST_F(Check, MeasuredDataThatIsAbsentSkipsAndAWrongPathDoesNot) {
    const std::string shallow =
        "[domain]\nsize_m = [1.0, 1.0]\ncells = [8, 8]\ndepth_m = 1.0\nbathymetry = \"FILE\"\n[waves]\nmodel = "
        "\"shallow-water\"\n" +
        check("waves.min_depth", "above = 0.0");
    const auto with = [&](const std::string& data) {
        return std::string(shallow).replace(shallow.find("FILE"), 4, data);
    };
    const fs::path absent = write("absent.toml", with("survey/bed.asc")), wrong = write("wrong.toml", with("bed.asc"));
    const Outcome skipped = run({absent.string(), "--junit", path("j.xml")}, "env -u WATERLIGHT_DATA");
    EXPECT_EQ(skipped.exit, 0) << skipped.output;
    EXPECT_TRUE(has(skipped.output, "skipped absent: ") && has(skipped.output, "survey/bed.asc")) << skipped.output;
    EXPECT_TRUE(has(skipped.output, "1 scenario skipped")) << skipped.output;
    EXPECT_TRUE(has(read_junit(path("j.xml")), "case absent | scenario | skipped ")) << read_junit(path("j.xml"));
    EXPECT_EQ(run({wrong.string()}, "env -u WATERLIGHT_DATA").exit, 2);
    fs::create_directories(folder_ / "data/survey");
    EXPECT_EQ(run({absent.string()}, "WATERLIGHT_DATA=" + quoted(path("data"))).exit, 2) << "the folder is there";
}

TEST_F(Check, WithoutAVulkanDeviceAgreementIsSkippedAndCounted) {
    const fs::path file =
        write("a.toml", standing + holds + check("floor.cv", "agrees = { backend = \"vulkan\", tolerance = 1e-5 }"));
    const Outcome outcome = run({file.string()}, "VK_DRIVER_FILES=/nowhere VK_ICD_FILENAMES=/nowhere");
    EXPECT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "skipped a/floor.cv: no Vulkan device")) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "2 checks of 1 scenario: 1 passed, 1 skipped")) << outcome.output;
}

TEST_F(Check, OwnSettingsHoldUnderCheckAloneAndYieldToTheCommandLine) {
    const fs::path file = write("a.toml", "[check_run]\nset = [\"waves.duration_s=0.25\"]\n" + standing +
                                              check("simulated_s", "equals = 0.25\ntolerance = 1e-9"));
    EXPECT_EQ(run({file.string()}).exit, 0);
    EXPECT_EQ(run({file.string(), "--set", "waves.duration_s=0.5"}).exit, 1);
    EXPECT_EQ(run_program({"run", file.string(), "--out", path("out"), "--quiet"}).exit, 1);
}

TEST_F(Check, RunLeavesToCheckWhatTakesOtherRuns) {
    const fs::path file = write(
        "a.toml",
        standing + check("simulated_s", "order = { key = \"waves.duration_s\", values = [0.5, 1.0], at_least = 5.0 }"));
    const Outcome outcome = run_program({"run", file.string(), "--out", path("out")});
    EXPECT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "left to `waterlight check`")) << outcome.output;
    EXPECT_TRUE(has(read_file(path("out/report.json")), "\"pass\": null"));
}

/// What a run wrote is a reference for another.
TEST_F(Check, AFileIsComparedWithAtItsTimeAndCellByCell) {
    const fs::path truth = write("truth.toml", standing);
    ASSERT_EQ(run_program({"run", truth.string(), "--out", path("truth"), "--quiet"}).exit, 0);
    ASSERT_EQ(
        run_program({"run", truth.string(), "--out", path("fine"), "--quiet", "--set", "domain.cells=[64,32]"}).exit,
        0);
    const auto against = [&](const std::string& file, const std::string& more) {
        return run({write("a.toml", standing + check("surface.elevation.linf", "reference = \"" + file + "\"\n" + more))
                        .string()});
    };
    EXPECT_EQ(against("truth/surface.pvd", "below = 1e-12\nat_s = 0.5").exit, 0);
    EXPECT_EQ(against("truth/surface/surface_000010.vti", "below = 1e-12\nat_s = 0.5").exit, 0);
    EXPECT_EQ(against("truth/surface/surface_000011.vti", "below = 1e-4\nat_s = 0.5").exit, 1) << "another time";
    EXPECT_EQ(against("fine/surface.pvd", "between = [1e-6, 1e-4]").exit, 0) << "finer cells are averaged";
    EXPECT_EQ(against("nothing.vti", "below = 1.0").exit, 2);
    for (const char* wrong : {"--set=domain.cells=[24,16]", "--set=check[0].at_s=0.512"}) {
        const fs::path file = write(
            "b.toml", standing + check("surface.elevation.linf", "reference = \"truth/surface.pvd\"\nbelow = 1.0"));
        const Outcome refused = run_program({"run", file.string(), "--out", path("never"), wrong});
        EXPECT_EQ(refused.exit, 2) << refused.output;
        EXPECT_TRUE(has(refused.output, "check[0].reference: ")) << refused.output;
        EXPECT_FALSE(fs::exists(path("never"))) << "refused before anything is written";
    }
}

}  // namespace
}  // namespace waterlight::test
