// --set key=value
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

const std::string two_drops = least +
                              "[[waves.source]]\ntype = \"drop\"\nat_m = [1, 1]\n"
                              "[[waves.source]]\ntype = \"drop\"\nat_m = [2, 2]\n";

TEST(Overrides, ReplaceValuesOfAllTypes) {
    const Scenario s = parse(two_drops, {"title=a pool", "domain.cells=[128, 96]", "domain.depth_m=3",
                                         "waves.model=linear", "water.fresnel=false", "waves.source[1].at_m=[5.5,2]"});
    EXPECT_EQ(s.title, "a pool");
    EXPECT_EQ(s.domain.cells, glm::ivec2(128, 96));
    EXPECT_EQ(s.water.depth_m, 3);
    EXPECT_EQ(s.waves.model, ModelChoice::linear);
    EXPECT_FALSE(s.optics.fresnel);
    EXPECT_EQ(std::get<Drop>(s.waves.sources[0]).at_m, glm::dvec2(1, 1));
    EXPECT_EQ(std::get<Drop>(s.waves.sources[1]).at_m, glm::dvec2(5.5, 2));
}

TEST(Overrides, MakeSectionsAndAppendToLists) {
    const Scenario s = parse(two_drops, {"caustics.floor.pixels=[256,256]", "waves.source[2].type=rain",
                                         "waves.source[2].seed=7", "probe[0]={name=\"a\", at_m=[1, 1]}"});
    ASSERT_TRUE(s.floor.has_value());
    EXPECT_EQ(s.floor->pixels, glm::ivec2(256, 256));
    ASSERT_EQ(s.waves.sources.size(), 3U);
    EXPECT_EQ(std::get<Rain>(s.waves.sources[2]).seed, 7U);
    EXPECT_EQ(s.probes.at(0).name, "a");
}

TEST(Overrides, TheLastOneWins) { EXPECT_EQ(parse(least, {"domain.depth_m=3", "domain.depth_m=4"}).domain.depth_m, 4); }

TEST(Overrides, TextIsTakenAsTypedWhereTextIsExpected) {
    EXPECT_EQ(parse(least, {"title=2024-01-01 10:00"}).title, "2024-01-01 10:00");
    EXPECT_EQ(parse(least, {"title=\"quoted\""}).title, "quoted");
    EXPECT_EQ(parse(least, {"title=7"}).title, "7");
}

TEST(Overrides, ErrorsNameTheOverride) {
    const auto begins = [](const std::string& message, const std::string& start) {
        return message.rfind(start, 0) == 0 ? testing::AssertionSuccess() : testing::AssertionFailure() << message;
    };
    EXPECT_TRUE(begins(rejection(least, {"domain.depth_m=-1"}), "--set domain.depth_m=-1: domain.depth_m: found -1"));
    EXPECT_TRUE(
        begins(rejection(least, {"domain.depth=1"}), "--set domain.depth=1: domain.depth: found an unknown key"));
    EXPECT_TRUE(begins(rejection(least, {"domain.cells=[4"}), "--set domain.cells=[4: domain.cells: found \"[4\""));
    EXPECT_TRUE(
        begins(rejection(least, {"domain.depth_m=deep"}), "--set domain.depth_m=deep: domain.depth_m: found \"deep\""));
    EXPECT_TRUE(begins(rejection(least, {"nonsense"}), "--set nonsense: --set: found \"nonsense\""));
    EXPECT_TRUE(begins(rejection(least, {"domain.depth_m.x=1"}), "--set domain.depth_m.x=1: domain.depth_m.x: found"));
    EXPECT_TRUE(begins(rejection(two_drops, {"waves.source[5].at_m=[1,1]"}),
                       "--set waves.source[5].at_m=[1,1]: waves.source[5].at_m: found index 5; allowed: 0 to 2"));
    EXPECT_TRUE(
        begins(rejection(two_drops, {"waves.source[1].at_m=[1,7]"}), "--set waves.source[1].at_m=[1,7]: waves.sou"));
    EXPECT_TRUE(begins(rejection(least, {"caustics.floor.window={samples=4}", "caustics.floor.pixels=[4,4]"}),
                       "--set caustics.floor.window={samples=4}: caustics.floor.window.samples: found 4"));
    EXPECT_TRUE(begins(rejection(least, {"waves.model=linear", "waves.spectrum.seed=1"}),
                       "--set waves.spectrum.seed=1: waves.spectrum: found it beside"));
}

}  // namespace
}  // namespace waterlight::test
