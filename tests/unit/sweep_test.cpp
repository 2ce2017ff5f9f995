// Settings from the command line, the front among them, and what a table says.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/sweep/plot.hpp"
#include "app/sweep/raster.hpp"
#include "app/sweep/table.hpp"
#include "sim/error.hpp"

namespace waterlight::test {
namespace {

std::string refusal(const std::function<void()>& work) {
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Variation, EndsAtCommasOutsideOfBracketsAndQuotes) {
    const Variation v = parse_variation("domain.cells = [256, 192], [512,384]");
    EXPECT_EQ(v.key, "domain.cells");
    EXPECT_EQ(v.values, (std::vector<std::string>{"[256, 192]", "[512,384]"}));
    EXPECT_EQ(parse_variation("a={x=1,y=[2,3]},auto").values, (std::vector<std::string>{"{x=1,y=[2,3]}", "auto"}));
    EXPECT_EQ(parse_variation("a=\"x,y\",'z,['").values, (std::vector<std::string>{"\"x,y\"", "'z,['"}));
    EXPECT_EQ(parse_variation("a=1").values.size(), 1U);
}

TEST(Variation, RefusesWhatIsNoListOfDifferentValues) {
    for (const char* text : {"a", "=1", "a=", "a=1,,2", "a=1,2,1"})
        EXPECT_EQ(refusal([&] { parse_variation(text); }).rfind(std::string("--vary ") + text, 0), 0U) << text;
}

class Settings : public ::testing::Test {
  protected:
    Settings() {
        std::ofstream(file_) << "[domain]\nsize_m = [1.0, 1.0]\ncells = [16, 16]\ndepth_m = 1.0\n"
                                "[caustics.floor]\npixels = [16, 16]\n";
        options_.scenario = file_;
    }
    ~Settings() override { std::filesystem::remove(file_); }

    std::vector<Setting> settings() {
        variations_.clear();
        for (const std::string& text : options_.variations) variations_.push_back(parse_variation(text));
        return settings_of(options_, variations_);
    }

    std::filesystem::path file_ =
        std::filesystem::temp_directory_path() / ("sweep settings " + std::to_string(::getpid()) + ".toml");
    SweepOptions options_;
    std::vector<Variation> variations_;
};

TEST_F(Settings, AreTheProductTheLastFastest) {
    options_.overrides = {"waves.duration_s=0.5"};
    options_.variations = {"domain.cells=[16,16],[32,32]", "caustics.floor.pixels=[16,16],[24,24],[32,32]"};
    const std::vector<Setting> all = settings();
    ASSERT_EQ(all.size(), 6U);
    EXPECT_EQ(all[4].values, (std::vector<std::string>{"[32,32]", "[24,24]"}));
    EXPECT_EQ(all[4].scenario.domain.cells.x, 32);
    EXPECT_EQ(all[4].scenario.floor->pixels.x, 24);
    EXPECT_EQ(all[4].scenario.waves.duration_s, 0.5);
    EXPECT_EQ(all[4].overrides.size(), 3U);
    EXPECT_EQ(all[4].waves, (std::vector<std::string>{"waves.duration_s=0.5", "domain.cells=[32,32]"}));
    EXPECT_EQ(all[4].scene, all[0].scene) << "cells and pixels are methods: one question";
    EXPECT_EQ(common_raster(all), glm::ivec2(8, 8));
    EXPECT_EQ(common_points(all), glm::ivec2(32, 32));
    options_.variations = {"light.elevation_deg=30,60"};
    const std::vector<Setting> suns = settings();
    EXPECT_NE(suns[0].scene, suns[1].scene) << "another sun is another question";
}

TEST_F(Settings, AreRefusedAtOnceByNameOfTheirVary) {
    options_.variations = {"domain.cells=[16,16],[0,16]"};
    EXPECT_EQ(refusal([&] { settings(); }).rfind("--vary domain.cells=[0,16]: domain.cells: found ", 0), 0U);
    options_.variations = {"domain.cels=[16,16]"};
    EXPECT_NE(refusal([&] { settings(); }).find("did you mean \"cells\""), std::string::npos);
    options_.variations = {"domain.cells=[16,16]", "domain.cells=[32,32]"};
    EXPECT_NE(refusal([&] { settings(); }).find("twice"), std::string::npos);
    options_.variations = {"caustics.floor.pixels=[16,16],[17,17]"};
    EXPECT_NE(refusal([&] { common_raster(settings()); }).find("common divisor"), std::string::npos);
}

TEST(Raster, AveragesKeepTheMean) {
    Field<float> map(4, 2);
    for (std::size_t n = 0; n < map.size(); ++n) map.data()[n] = static_cast<float>(n);
    const Field<float> means = averaged(map, {2, 1});
    EXPECT_EQ(means(0, 0), 2.5F);
    EXPECT_EQ(means(1, 0), 4.5F);
}

TEST(Front, HoldsWhatNothingBeats) {
    const std::vector<CostAndError> all{{3, 0.01}, {1, 0.1}, {2, 0.2}, {2, 0.05}, {4, 0.01}, {NAN, NAN}, {5, 0.001}};
    EXPECT_EQ(pareto_front(all), (std::vector<std::size_t>{1, 3, 0, 6}));
    EXPECT_EQ(cheapest_within(all, 0.05), 3U);
    EXPECT_EQ(cheapest_within(all, 0.0001), std::nullopt);
    EXPECT_EQ(least_wrong(all), 6U);
    EXPECT_EQ(least_wrong({{NAN, NAN}}), std::nullopt);
}

TEST(SweepTable, NamesTheCheapestOrTheClosest) {
    const Setting quick{{"[1,1]"}, {"domain.cells=[1,1]"}, {}, {}, {}},
        good{{"[2,2]"}, {"domain.cells=[2,2]"}, {}, {}, {}};
    Table table;
    table.variations = {{"domain.cells", {"[1,1]", "[2,2]"}}};
    table.settings = 2;
    table.raster = {8, 8};
    table.times_s = {1};
    SettingResult a, b;
    a.wall_s = {2, 3};
    a.errors = {0.1, 0.2, 0.011};
    b.wall_s = {0.5, 0.25};
    b.errors = {0.1, 0.2, 0.3};
    table.rows = {{2, &good, a}, {1, &quick, b}};
    table.tolerance = 0.02;
    finish(table);
    EXPECT_EQ(table.front, (std::vector<std::size_t>{0, 1}));
    EXPECT_TRUE(meets_tolerance(table));
    EXPECT_NE(recommendation(table).find("The cheapest setting within 2 % is #2: domain.cells=[2,2] (1.1 % in 5 s)"),
              std::string::npos)
        << recommendation(table);
    EXPECT_NE(csv_of(table).find("\n2,\"[2,2]\",2,3,5,0.1,0.2,0.011,1,\n"), std::string::npos) << csv_of(table);
    table.tolerance = 0.01;
    EXPECT_FALSE(meets_tolerance(table));
    EXPECT_NE(recommendation(table).find("No setting is within 1 %; the closest is #2"), std::string::npos);
    const std::string svg = svg_of(plot_of(table));
    EXPECT_NE(svg.find(">#2</text>"), std::string::npos);
    EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos);
}

TEST(SweepTable, APlotOfNothingOrOfOnePointIsStillAPlot) {
    Table table;
    EXPECT_EQ(image_of(plot_of(table)).width, 960);
    const Setting one{{}, {}, {}, {}, {}};
    SettingResult r;
    r.wall_s = {1, 1};
    r.errors.waves = 0.1;
    table.rows = {{1, &one, r}};
    finish(table);
    EXPECT_NE(svg_of(plot_of(table)).find("<circle"), std::string::npos);
}

}  // namespace
}  // namespace waterlight::test
