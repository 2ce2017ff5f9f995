// The same scenario on the same back-end and machine gives the same bytes whatever the number of threads.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/child.hpp"
#include "tests/support/run_files.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

/// A shipped scenario, made small and short: what depends on threads does so at any size.
struct Shortened {
    std::string name;
    std::string duration_s;
    std::vector<std::string> more = {};
    std::string backend = "cpu";
};

void PrintTo(const Shortened& shortened, std::ostream* stream) { *stream << shortened.name; }

const std::vector<Shortened> runs{
    {"pool", "1", {"camera.pixels=[96,54]"}},
    {"rain", "1"},
    {"standing_wave", "1"},
    {"wave_basin", "1"},
    {"gerstner_sea", "1"},
    {"jonswap_sea", "1"},
    {"frozen_sine", "0"},
    {"shafts", "0"},
    {"dam_break", "1"},
    {"circular_dam_break", "0.2"},
    {"bowl", "0.5"},
    {"beach_runup", "2"},
    {"conical_island_a", "2"},
    {"tidal_pool", "1"},
    {"surf_zone", "2"},
    {"pool_side", "0.2", {"camera.pixels=[48,32]", "caustics.beams.grid=[64,48]"}},
    {"open_sea_below", "0.1", {"camera.pixels=[48,32]", "caustics.beams.grid=[64,64]"}},
    {"harbour", "0.1"},
    {"pool_vulkan", "0.5", {}, "vulkan"},
    {"tidal_pool_vulkan", "0.5", {}, "vulkan"},
};

class Determinism : public ::testing::TestWithParam<Shortened> {};

TEST_P(Determinism, OneThreadAndTwoGiveTheSameBytes) {
    const Shortened& shortened = GetParam();
    const Scratch folder("determinism", quick_place());
    const std::string file = shortened.name.substr(0, shortened.name.find("_vulkan"));
    const fs::path scenario = fs::path(WATERLIGHT_SOURCE) / "scenarios" / (file + ".toml");
    const auto run = [&](const std::string& threads) {
        std::vector<std::string> arguments{"run", scenario.string(), "--quiet", "--threads", threads};
        for (const std::string& more :
             {std::string("--out"), (folder / threads).string(), std::string("--backend"), shortened.backend,
              std::string("--set"), "waves.duration_s=" + shortened.duration_s, std::string("--set"),
              std::string("domain.cells=[97,64]"), std::string("--set"), std::string("check=[]"), std::string("--set"),
              std::string("output.formats=[\"vti\",\"exr\"]")})
            arguments.push_back(more);
        if (read_file(scenario).find("[caustics.floor]") != std::string::npos)
            arguments.insert(arguments.end(), {"--set", "caustics.floor.pixels=[90,70]"});
        for (const std::string& more : shortened.more) arguments.insert(arguments.end(), {"--set", more});
        return run_program(arguments);
    };
    for (const std::string threads : {"1", "2"}) {
        const Outcome outcome = run(threads);
        if (outcome.output.find("below $WATERLIGHT_DATA, which is not set") != std::string::npos)
            GTEST_SKIP() << "needs measured data below $WATERLIGHT_DATA";
        ASSERT_EQ(outcome.exit, 0) << outcome.output;
    }
    EXPECT_EQ(differences(files_of(folder / "1"), files_of(folder / "2")), "");
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Determinism, ::testing::ValuesIn(runs),
                         [](const auto& run) { return run.param.name; });

}  // namespace
}  // namespace waterlight::test
