// What a session saves: every shipped scenario, edited, reads back as it was saved.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/view/edits.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

class Shipped : public ::testing::TestWithParam<fs::path> {};

TEST_P(Shipped, IsReadBackAsItWasSaved) {
    Scenario original;
    try {
        original = read_open_scenario(GetParam());
    } catch (const MissingData& missing) {
        GTEST_SKIP() << missing.what();
    }
    Edits edits(original);
    edits.set(edits.with({"light.elevation_deg=47.25", "light.azimuth_deg=-12.5"}));
    edits.add({{0.1, 0.2}, 0.3, 0.04, 0.5});
    const fs::path file = fs::temp_directory_path() / ("waterlight-saved-" + GetParam().filename().string());
    edits.save(original, file);
    const Scenario saved = parse_scenario(
        [&] {
            std::ifstream stream(file);
            return std::string(std::istreambuf_iterator<char>(stream), {});
        }(),
        file);
    EXPECT_EQ(saved.light.elevation_deg, 47.25);
    EXPECT_EQ(saved.light.azimuth_deg, -12.5);
    ASSERT_EQ(saved.waves.sources.size(), original.waves.sources.size() + 1);
    const Drop drop = std::get<Drop>(saved.waves.sources.back());
    EXPECT_EQ(drop.at_m, glm::dvec2(0.1, 0.2));
    EXPECT_EQ(drop.time_s, 0.5);
    // All else is as it was: without what was set it is the same text.
    EXPECT_EQ(saved.title, original.title);
    EXPECT_EQ(saved.domain.cells, original.domain.cells);
    EXPECT_EQ(saved.checks.size(), original.checks.size());
    EXPECT_EQ(Edits(original).text(original), original.origin.text);
    if (original.waves.buoy || original.waves.file || original.domain.bathymetry) {
        Scenario found = saved;
        EXPECT_NO_THROW(find_data(found));
        EXPECT_EQ(data_files(found), data_files(original));
    }
    fs::remove(file);
}

std::vector<fs::path> shipped() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(WATERLIGHT_SOURCE "/scenarios"))
        if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() != "refused")
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Shipped, ::testing::ValuesIn(shipped()), [](const auto& test) {
    std::string name = test.param.parent_path().filename().string() + "_" + test.param.stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
});

}  // namespace
}  // namespace waterlight::test
