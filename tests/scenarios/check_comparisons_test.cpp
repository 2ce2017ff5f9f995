// Every kind of expectation that a check may state.
#include <gtest/gtest.h>

#include "gpu/device.hpp"
#include "tests/scenarios/program.hpp"
#include "tests/support/check_texts.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

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

}  // namespace
}  // namespace waterlight::test
