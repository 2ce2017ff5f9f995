// Every shipped scenario runs and meets its own checks on both back-ends, Vulkan with its validation layer on. The
// water moves for as long as the scenario says, unless Vulkan is played by a CPU and would take too long; frames are
// fewer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "caustics/floor_vulkan.hpp"
#include "caustics/truth.hpp"
#include "scenarios/build.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"
#include "tests/scenarios/program.hpp"

#ifdef __SANITIZE_ADDRESS__
// Devices open and close in this process; of the driver's libraries, gone by the end, the leak checker knows no names
// to pass over. The program itself is checked where it runs.
extern "C" [[gnu::used]] int __lsan_is_turned_off() { return 1; }
#endif

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

/// How much of a scenario runs on a Vulkan device that is a CPU, at some 3 million cells a second. `opening`: the first
/// second, judged by what holds at all times.
enum class OnSoftware { whole, opening, none };

struct Shipped {
    const char* name;
    const char* every_s;  ///< frames that its checks allow
    OnSoftware on_software = OnSoftware::whole;
};

void PrintTo(const Shipped& shipped, std::ostream* out) { *out << shipped.name; }

const fs::path folder = fs::path(WATERLIGHT_SOURCE) / "scenarios";

fs::path path_of(const Shipped& shipped) { return folder / (std::string(shipped.name) + ".toml"); }

/// Whether the measured data is there that the scenario needs.
bool has_data(const Shipped& shipped) {
    const std::map<std::string, const char*> needed{{"buoy_41010", "ndbc/41010.data_spec"},
                                                    {"open_sea_below", "ndbc/41010.data_spec"},
                                                    {"monai_valley", "nthmp/monai_bathymetry.txt"}};
    const auto file = needed.find(shipped.name);
    if (file == needed.end()) return true;
    const char* data = std::getenv("WATERLIGHT_DATA");
    return data && fs::exists(fs::path(data) / file->second);
}

/// Whether it draws the light.
bool has_floor(const Shipped& shipped) { return read_scenario(path_of(shipped)).floor.has_value(); }

bool has_volume(const Shipped& shipped) {
    const Scenario scenario = read_scenario(path_of(shipped));
    return scenario.beams && scenario.beams->volume_cells;
}

bool sees_light(const Shipped& shipped) { return sees_scattered_light(read_scenario(path_of(shipped))); }
bool draws_scene(const Shipped& shipped) { return read_scenario(path_of(shipped)).output.image; }

/// Whether its floor map is by a method of the CPU alone, but for the truth, in whose place this test takes another.
bool is_of_the_cpu(const Shipped& shipped) {
    const Scenario scenario = read_scenario(path_of(shipped));
    return scenario.floor && scenario.floor->method != FloorMethod::truth && !has_vulkan_method(scenario.floor->method);
}

/// Whether there is something that Vulkan computes.
bool has_vulkan_part(const Shipped& shipped) {
    const Scenario scenario = read_scenario(path_of(shipped));
    return scenario.floor || scenario.beams || has_vulkan_model(scenario);
}

bool has_vulkan() { return gpu::survey().chosen.has_value(); }

const std::vector<Shipped> all{{"pool", "2.0"},
                               {"rain", "2.0"},
                               {"standing_wave", "1.0"},
                               {"wave_basin", "0.875"},
                               {"gerstner_sea", "1.5"},
                               {"jonswap_sea", "1.5"},
                               {"buoy_41010", "2.0"},
                               {"frozen_sine", "1.0"},
                               {"dam_break", "3.0"},
                               {"dam_break_dry", "2.5"},
                               {"circular_dam_break", "0.7"},
                               {"bowl", "5.0"},
                               {"conical_island_a", "6.0", OnSoftware::none},
                               {"conical_island_c", "4.0", OnSoftware::none},
                               {"monai_valley", "7.5", OnSoftware::none},
                               {"beach_runup", "13.0", OnSoftware::none},
                               {"tidal_pool", "2.0", OnSoftware::opening},
                               {"surf_zone", "4.0", OnSoftware::opening},
                               {"shafts", "1.0"},
                               {"pool_side", "2.0", OnSoftware::none},
                               {"open_sea_below", "2.0", OnSoftware::none},
                               {"harbour", "1.0"},
                               {"reef", "1.0", OnSoftware::none},
                               {"flashes", "2.0"},
                               {"mirror", "1.0", OnSoftware::none},
                               {"colours", "0.5"},
                               {"pool_walls", "1.0"},
                               {"glass_sphere", "1.0"},
                               {"mirror_ring", "1.0"},
                               {"five_cups", "1.0"},
                               {"five_cups_sun", "1.0"},
                               {"glass_ball_in_pool", "1.0"}};

/// DESIGN's ledger: in every frame, and of all who follow the light, it closes to 1e-4.
void expect_ledgers_close(const Shipped& shipped, const nlohmann::json& report) {
    constexpr double most = 1e-4;
    const Scenario scenario = read_scenario(path_of(shipped));
    const auto expect = [&](const nlohmann::json& ledger) { EXPECT_LE(ledger["worst_closure"].get<double>(), most); };
    if (scenario.floor) expect(report["ledger"]);
    if (scenario.beams) expect(report["beams"]["ledger"]);
    if (scenario.walls) expect(report["walls"]["ledger"]);
}

class ShippedScenario : public ::testing::TestWithParam<Shipped> {
  protected:
    void SetUp() override {
        if (!has_data(GetParam())) GTEST_SKIP() << "needs measured data below $WATERLIGHT_DATA";
    }
    static Outcome run(const Scratch& out, std::vector<std::string> more) {
        std::vector<std::string> arguments{"run",   path_of(GetParam()).string(),
                                           "--out", (out / "out").string(),
                                           "--set", std::string("output.every_s=") + GetParam().every_s};
        if (draws_scene(GetParam()) && !has_vulkan())
            arguments.insert(arguments.end(), {"--set", "output.image=false"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    }
};

TEST_P(ShippedScenario, MeetsItsChecksOnTheCpu) {
    const Scratch out(std::string(GetParam().name) + " cpu");
    const Outcome outcome = run(out, {"--backend", "cpu"});
    EXPECT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("check passed"), std::string::npos) << outcome.output;
    EXPECT_TRUE(fs::exists(out / "out/surface.pvd"));
    EXPECT_TRUE(fs::exists(out / "out/images/elevation_000000.png"));
    EXPECT_EQ(fs::exists(out / "out/floor.pvd"), has_floor(GetParam()));
    EXPECT_EQ(fs::exists(out / "out/images/irradiance_000000.png"), has_floor(GetParam()));
    EXPECT_EQ(fs::exists(out / "out/volume.pvd"), has_volume(GetParam()));
    EXPECT_EQ(fs::exists(out / "out/images/radiance_000000.png"), sees_light(GetParam()));
    EXPECT_EQ(fs::exists(out / "out/images/scene_000000.png"), draws_scene(GetParam()) && has_vulkan());
    expect_ledgers_close(GetParam(), nlohmann::json::parse(read_file(out / "out/report.json")));
}

TEST_P(ShippedScenario, MeetsItsChecksOnVulkanWithValidationSilent) {
    if (!has_vulkan()) GTEST_SKIP() << "needs a Vulkan device";
    if (is_of_the_cpu(GetParam())) GTEST_SKIP() << "has a floor map of the CPU alone";
    if (!has_vulkan_part(GetParam())) GTEST_SKIP() << "has no part that Vulkan computes";
    const OnSoftware part = gpu::has_real_gpu(gpu::survey()) ? OnSoftware::whole : GetParam().on_software;
    if (part == OnSoftware::none) GTEST_SKIP() << "takes more than half a minute where Vulkan is played by a CPU";
    const Scratch out(std::string(GetParam().name) + " vulkan");
    std::vector<std::string> arguments{"--backend", "vulkan", "--validate", "--set", "output.formats=[]"};
    // Its checks judge the truth, which is computed on the CPU only.
    const bool is_truth = std::string(GetParam().name) == "frozen_sine";
    if (is_truth)
        for (const char* set : {"caustics.floor={method=\"two-pass\", pixels=[512,128]}", "check=[]"})
            arguments.insert(arguments.end(), {"--set", set});
    if (part == OnSoftware::opening)
        for (const char* set : {"waves.duration_s=1", "output.every_s=0.5",
                                "check=[{quantity=\"waves.min_depth\", equals=0.0, tolerance=1e-12}, "
                                "{quantity=\"floor.ledger_closure\", below=1e-4}]"})
            arguments.insert(arguments.end(), {"--set", set});
    const Outcome outcome = run(out, arguments);
    EXPECT_EQ(outcome.exit, 0) << outcome.output;
    const auto report = nlohmann::json::parse(read_file(out / "out/report.json"));
    EXPECT_EQ(report["backend"]["name"], "vulkan");
    expect_ledgers_close(GetParam(), report);
}

TEST_P(ShippedScenario, MapsOfBothBackEndsAgree) {
    if (!has_vulkan()) GTEST_SKIP() << "needs a Vulkan device";
    if (!has_floor(GetParam())) GTEST_SKIP() << "draws no light";
    Scenario scenario = read_scenario(path_of(GetParam()));
    scenario.floor->pixels = glm::min(scenario.floor->pixels, glm::ivec2(512));
    const BuiltModel waves = build_model(scenario);
    waves.model->advance(0.5 * scenario.waves.duration_s);
    const FloorSettings settings = floor_settings(scenario);
    const auto context = std::make_shared<gpu::Context>(gpu::ContextSettings{.device = "", .validation = true});
    FloorMap cpu, vulkan;
    make_floor_cpu(settings)->compute(waves.model->surface(), cpu);
    make_floor_vulkan(settings, context)->compute(waves.model->surface(), vulkan);
    Field<double> reference(cpu.irradiance.nx(), cpu.irradiance.ny());
    std::copy_n(cpu.irradiance.data(), cpu.irradiance.size(), reference.data());
    EXPECT_LT(relative_rmse(vulkan.irradiance, reference), 1e-4);
    EXPECT_TRUE(context->validation_messages().empty());
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScenario, ::testing::ValuesIn(all),
                         [](const auto& shipped) { return shipped.param.name; });

// To rounding, and no further, the device comes to what the CPU does.
TEST(ShippedScenarios, ShallowWaterRunsOnTheDeviceThatIsGiven) {
    if (!has_vulkan()) GTEST_SKIP() << "needs a Vulkan device";
    const Scenario scenario = read_scenario(folder / "circular_dam_break.toml", {"domain.cells=[80,80]"});
    const auto context = std::make_shared<gpu::Context>(gpu::ContextSettings{.device = "", .validation = true});
    const BuiltModel cpu = build_model(scenario), vulkan = build_model(scenario, context);
    for (const BuiltModel* waves : {&cpu, &vulkan}) waves->model->advance(1);
    const Field<float>&here = cpu.model->surface().elevation, &there = vulkan.model->surface().elevation;
    double farthest = 0;
    for (std::size_t k = 0; k < here.size(); ++k)
        farthest = std::max(farthest, std::abs(static_cast<double>(here.data()[k]) - there.data()[k]));
    EXPECT_GT(farthest, 0) << "the CPU computed both";
    EXPECT_LT(farthest, 2e-4) << "1e-4 of the height of the dam";
    EXPECT_TRUE(context->validation_messages().empty());
}

TEST(ShippedScenarios, AreAllTestedHere) {
    std::set<std::string> here, there;
    for (const Shipped& shipped : all) here.insert(shipped.name);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".toml") there.insert(entry.path().stem().string());
    EXPECT_EQ(here, there);
}

}  // namespace
}  // namespace waterlight::test
