// Each bad scenario gives one line that names place, key, what was found and what is allowed; the program exits 2 and
// writes nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenarios/program.hpp"

namespace waterlight::test {
namespace {

const std::string good =
    "[domain]\nsize_m = [1.0, 1.0]\ncells = [16, 16]\ndepth_m = 1.0\n[caustics.floor]\npixels = [16, 16]\n";

struct Bad {
    const char* name;
    std::string text;
    std::vector<std::string> set;
    std::string says;  ///< after "waterlight: "; FILE stands for the scenario
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class BadScenario : public ::testing::TestWithParam<Bad> {};

TEST_P(BadScenario, OneLineExitTwoNothingWritten) {
    const Bad& bad = GetParam();
    const Scratch folder(bad.name);
    const auto scenario = folder.write("bad.toml", bad.text);
    std::vector<std::string> arguments{"run", scenario.string(), "--out", (folder / "out").string()};
    for (const std::string& set : bad.set) arguments.insert(arguments.end(), {"--set", set});
    const Outcome outcome = run_program(arguments, "env -u WATERLIGHT_DATA");
    EXPECT_EQ(outcome.exit, 2) << outcome.output;
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    const std::string expected = replaced(bad.says, "FILE", scenario.string());
    EXPECT_EQ(outcome.output.rfind(fmt::format("waterlight: {}", expected), 0), 0U) << outcome.output << expected;
    EXPECT_NE(outcome.output.find("; allowed: "), std::string::npos) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

INSTANTIATE_TEST_SUITE_P(
    Ten, BadScenario,
    ::testing::Values(
        Bad{"UnknownKey",
            good + "[light]\nheight = 3\n",
            {},
            "FILE:8:10: light.height: found an unknown key; allowed: "},
        Bad{"TypoOfAKey",
            replaced(good, "depth_m", "detph_m"),
            {},
            "FILE:4:11: domain.detph_m: found an unknown key; allowed: "},
        Bad{"WrongType",
            replaced(good, "depth_m = 1.0", "depth_m = \"deep\""),
            {},
            "FILE:4:11: domain.depth_m: found \"deep\"; allowed: number > 0"},
        Bad{"DropWiderThanTheDomain",
            good + "[[waves.source]]\ntype = \"drop\"\nat_m = [0.5, 0.5]\nradius_m = 1e9\n",
            {},
            "FILE:10:12: waves.source[0].radius_m: found 1000000000; allowed: at most the domain's longer side, 1 m"},
        Bad{"NegativeDepth",
            replaced(good, "depth_m = 1.0", "depth_m = -1.0"),
            {},
            "FILE:4:11: domain.depth_m: found -1; allowed: number > 0"},
        Bad{"ZeroCells",
            replaced(good, "cells = [16, 16]", "cells = [0, 16]"),
            {},
            "FILE:3:9: domain.cells: found [0, 16]; allowed: two integers, each in [1, 1048576]"},
        Bad{"MissingFile", good + "[waves]\nfile = \"sea.vti\"\n", {}, "FILE:8:8: waves.file: found no file "},
        Bad{"MalformedToml", good + "[light\n", {}, "FILE:7:"},
        Bad{"UnsupportedCombination",
            good + "[waves]\nmodel = \"linear\"\n[waves.spectrum]\n",
            {},
            "FILE:9:1: waves.spectrum: found it beside waves.model = \"linear\"; allowed: model airy"},
        Bad{"MissingMesh",
            good + "[[object]]\ntype = \"mesh\"\nname = \"m\"\nfile = \"m.ply\"\ncentre_m = [0, 0, 0]\n",
            {},
            "FILE:10:8: object[0].file: found no file "},
        Bad{"LampOfTwoPass",
            good + "[light]\ntype = \"point\"\nat_m = [0, 0, 1]\n",
            {},
            "FILE:5:1: caustics.floor.method: found \"two-pass\" beside light.type = \"point\"; allowed: splat or "
            "photons"},
        Bad{"ObjectsOfTheTruth",
            good + "method = \"truth\"\n[[object]]\ntype = \"sphere\"\nname = \"s\"\ncentre_m = [0, 0, 0]\n",
            {},
            "FILE:7:10: caustics.floor.method: found \"truth\" beside [[object]]; allowed: two-pass, quads"},
        Bad{"TwoObjectsOfOneName",
            good,
            {"object=[{type=\"sphere\", name=\"s\", centre_m=[0,0,0]}, {type=\"box\", name=\"s\", centre_m=[0,0,0]}]"},
            "--set object=[{type=\"sphere\", name=\"s\", centre_m=[0,0,0]}, {type=\"box\", name=\"s\", "
            "centre_m=[0,0,0]}]: object[1].name: found \"s\" twice; allowed: one object a name"},
        Bad{"HugeGrid",
            replaced(good, "cells = [16, 16]", "cells = [1000000, 1000000]"),
            {},
            "FILE:3:9: domain.cells: found [1000000, 1000000], which takes some "},
        Bad{"BadSet",
            good,
            {"domain.cells=[3"},
            "--set domain.cells=[3: domain.cells: found \"[3\"; allowed: one TOML value"},
        Bad{"SetWithoutValue",
            good,
            {"domain.cells"},
            "--set domain.cells: --set: found \"domain.cells\"; allowed: key=value"}),
    [](const auto& bad) { return bad.param.name; });

TEST(CommandLine, WhatIsWrongExitsTwoInOneLine) {
    const std::vector<std::vector<std::string>> wrong{{},
                                                      {"fly"},
                                                      {"run"},
                                                      {"run", "a.toml", "--backend", "gpu"},
                                                      {"run", "a.toml", "--threads", "0"},
                                                      {"run", "a.toml", "--resume"},
                                                      {"run", "/nowhere/a.toml"},
                                                      {"schema", "--json", "--markdown"}};
    for (const auto& arguments : wrong) {
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.exit, 2) << outcome.output;
        EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    }
}

}  // namespace
}  // namespace waterlight::test
