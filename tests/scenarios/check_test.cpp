// The command `check`: what it runs, what it says, what it exits with.
#include <gtest/gtest.h>

#include <algorithm>

#include "gpu/device.hpp"
#include "tests/scenarios/program.hpp"
#include "tests/support/check_texts.hpp"
#include "tests/support/child.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

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

TEST_F(Check, APathThatLeadsNowhereOrToNoCheckIsRefused) {
    EXPECT_EQ(run({path("missing.toml")}).exit, 2);
    EXPECT_EQ(run({path()}).exit, 2) << "a folder without a scenario";
    EXPECT_EQ(run({write("plain.toml", standing).string()}).exit, 2) << "a scenario without a check";
    const Outcome malformed = run({write("malformed.toml", "waves = ").string()});
    EXPECT_EQ(malformed.exit, 2);
    EXPECT_TRUE(has(malformed.output, "malformed.toml:1:")) << malformed.output;
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
