// A scenario's text with other settings says what the overrides say, and keeps what it said besides.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "scenarios/overrides.hpp"
#include "scenarios/rewrite.hpp"
#include "sim/error.hpp"

namespace waterlight {
namespace {

const std::string pool =
    "# A pool. \u00e9\n"
    "title = \"P\u00f6ol\"  # its name\n"
    "\n"
    "[domain]\n"
    "size_m = [8.0, 6.0]\n"
    "depth_m = 2.0  # deep\n"
    "\n"
    "[waves]\n"
    "boundary = { x = \"wall\" }  # sides\n"
    "\n"
    "[[waves.source]]\n"
    "type = \"drop\"  # one\n"
    "at_m = [1.0, 1.0]\n"
    "\n"
    "[caustics.floor]\n"
    "pixels = [64, 48]\n";

struct Change {
    const char* name;
    const char* override;
    const char* from;  ///< in the pool's text
    const char* to;
};

class Rewritten : public ::testing::TestWithParam<Change> {};

TEST_P(Rewritten, ChangesOneLineAndNothingElse) {
    const Change& c = GetParam();
    std::string expected = pool;
    const std::size_t at = expected.find(c.from);
    ASSERT_NE(at, std::string::npos);
    expected.replace(at, std::string(c.from).size(), c.to);
    EXPECT_EQ(rewritten(pool, {c.override}), expected);
}

INSTANTIATE_TEST_SUITE_P(
    Changes, Rewritten,
    ::testing::Values(Change{"number", "domain.depth_m=0.1", "depth_m = 2.0", "depth_m = 0.1"},
                      Change{"whole_number", "domain.depth_m=3", "depth_m = 2.0", "depth_m = 3"},
                      Change{"list", "domain.size_m=[1.5, 2.0]", "[8.0, 6.0]", "[1.5, 2.0]"},
                      Change{"text_after_wide_letters", "title=\"\u00fc\"", "\"P\u00f6ol\"", "\"\u00fc\""},
                      Change{"bare_word", "title=lake", "\"P\u00f6ol\"", "\"lake\""},
                      Change{"inline_section", "waves.boundary.y=periodic", "{ x = \"wall\" }",
                             "{ x = \"wall\", y = \"periodic\" }"},
                      Change{"element", "waves.source[0].at_m=[2.0, 3.0]", "at_m = [1.0, 1.0]", "at_m = [2.0, 3.0]"},
                      Change{"new_key", "domain.cells=[32, 24]", "[domain]\n", "[domain]\ncells = [32, 24]\n"},
                      Change{"new_key_of_an_element", "waves.source[0].radius_m=0.2", "[[waves.source]]\n",
                             "[[waves.source]]\nradius_m = 0.2\n"},
                      Change{"new_section", "light.elevation_deg=30.5", "pixels = [64, 48]\n",
                             "pixels = [64, 48]\n\n[light]\nelevation_deg = 30.5\n"},
                      Change{"new_empty_section", "caustics.walls={}", "pixels = [64, 48]\n",
                             "pixels = [64, 48]\n\n[caustics.walls]\n"},
                      Change{"new_element", "waves.source[1]={type=\"drop\", at_m=[3.0, 0.1]}", "pixels = [64, 48]\n",
                             "pixels = [64, 48]\n\n[[waves.source]]\nat_m = [3.0, 0.1]\ntype = \"drop\"\n"},
                      Change{"new_list", "probe[0]={name=\"a\"}", "pixels = [64, 48]\n",
                             "pixels = [64, 48]\n\n[[probe]]\nname = \"a\"\n"}),
    [](const auto& test) { return test.param.name; });

TEST(RewrittenText, TakesSettingsOneAfterTheOther) {
    const std::string text = rewritten(
        pool, {"waves.source[1]={type=\"drop\", at_m=[1.0, 2.0]}", "waves.source[1].height_m=0.02",
               "domain.depth_m=1.0", "domain.depth_m=1.5", "caustics.beams={}", "caustics.beams.grid=[8, 8]"});
    const toml::table root = toml::parse(text);
    EXPECT_EQ(root["waves"]["source"][1]["height_m"].value<double>(), 0.02);
    EXPECT_EQ(root["domain"]["depth_m"].value<double>(), 1.5);
    EXPECT_EQ(root["caustics"]["beams"]["grid"][0].value<int>(), 8);
    EXPECT_EQ(text.substr(0, 30), pool.substr(0, 30));
    EXPECT_NE(text.find("# one"), std::string::npos);
}

TEST(RewrittenText, IsWrittenAnewWhereItsLayoutDoesNotServe) {
    // A list of sections within a line cannot be added to by a header, nor a section be put where a value is.
    for (const char* text : {"a = 1\n[b]\nlist = [{ x = 1 }]\n", "b.list = [{ x = 1 }]\na = 1"}) {
        const std::string anew = rewritten(text, {"b.list[1]={x=2}", "a={y=0.1}"});
        const toml::table root = toml::parse(anew);
        EXPECT_EQ(root["b"]["list"][0]["x"].value<int>(), 1);
        EXPECT_EQ(root["b"]["list"][1]["x"].value<int>(), 2);
        EXPECT_EQ(root["a"]["y"].value<double>(), 0.1);
    }
}

TEST(RewrittenText, KeepsEveryBitOfANumber) {
    for (const double value : {0.1, 1.0 / 3, 1e-300, 6.02214076e23, 123456789.123456789}) {
        const toml::table root = toml::parse(rewritten(pool, {fmt::format("domain.depth_m={:.17g}", value)}));
        EXPECT_EQ(root["domain"]["depth_m"].value<double>(), value);
    }
}

TEST(RewrittenText, SurvivesLineEndsOfWindowsAndNoEndAtAll) {
    std::string text = "[domain]\r\ndepth_m = 2.0 # deep\r\n[light]\r\nazimuth_deg = 1.0";
    text = rewritten(text, {"domain.depth_m=1.0", "light.elevation_deg=3.0", "title=t"});
    const toml::table root = toml::parse(text);
    EXPECT_EQ(root["domain"]["depth_m"].value<double>(), 1);
    EXPECT_EQ(root["light"]["elevation_deg"].value<double>(), 3);
    EXPECT_EQ(root["title"].value<std::string>(), "t");
    EXPECT_NE(text.find("# deep"), std::string::npos);
}

TEST(RewrittenText, RefusesWhatOverridesRefuse) {
    for (const char* wrong : {"domain", "domain.size_m[0]=1", "waves.source[7].at_m=[1, 2]", "domain.depth_m=[1"})
        EXPECT_THROW(rewritten(pool, {wrong}), InputError) << wrong;
}

TEST(RewrittenText, EveryShippedScenarioTakesChanges) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(WATERLIGHT_SOURCE "/scenarios")) {
        if (entry.path().extension() != ".toml") continue;
        std::ifstream file(entry.path());
        std::ostringstream text;
        text << file.rdbuf();
        const std::vector<std::string> changes{"light.elevation_deg=41.5", "waves.boundary.y=wall",
                                               "caustics.floor.pixels=[10, 11]", "accuracy.estimate=true", "title=new"};
        toml::table expected = toml::parse(text.str());
        for (const std::string& change : changes) apply_override(expected, parse_override(change));
        const std::string changed = rewritten(text.str(), changes);
        EXPECT_TRUE(toml::parse(changed) == expected) << entry.path();
        // All comments are still there.
        std::istringstream lines(text.str());
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with('#')) {
                EXPECT_NE(changed.find(line), std::string::npos) << entry.path();
            }
        ++count;
    }
    EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace waterlight
