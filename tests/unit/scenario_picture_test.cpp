// What a scenario says about pictures of its scene.
#include "scenarios/memory.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/resolve_picture.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

const std::string above = "[camera]\nposition_m = [1, -2, 3]\ntarget_m = [4, 3, 0]\npixels = [200, 100]\n";
const std::string image = "[output]\nimage = true\n";
const std::string map = "[caustics.floor]\npixels = [16, 12]\n";

TEST(ScenarioPicture, IsReadWithItsLook) {
    const Scenario s =
        parse(least + above + image +
              "[picture]\nfreeboard_m = 0.3\nsamples = 8\ncolour_per_m = [0.1, 0.2, 0.3]\nexposure_w_m2_sr = 90\n"
              "floor = { pattern = \"sand\", albedo = [0.5, 0.4, 0.3], tile_m = 0.1 }\n"
              "[picture.sky]\ntype = \"uniform\"\nirradiance_w_m2 = 55\n");
    EXPECT_TRUE(s.output.image);
    const Look look = look_of(s);
    EXPECT_EQ(look.freeboard_m, 0.3);
    EXPECT_EQ(look.samples, 8);
    EXPECT_EQ(look.colour_per_m, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(look.exposure_w_m2_sr, 90);
    EXPECT_EQ(look.floor.pattern, Finish::Pattern::sand);
    EXPECT_EQ(look.floor.albedo, glm::dvec3(0.5, 0.4, 0.3));
    EXPECT_EQ(look.floor.tile_m, 0.1);
    EXPECT_EQ(look.sky.type, Sky::Type::uniform);
    EXPECT_EQ(look.sky.irradiance_w_m2, 55);
}

/// The defaults are those of Look: a scenario without [picture] looks as the header says.
TEST(ScenarioPicture, LeftOutItLooksAsLookDoes) {
    const Scenario s = parse(least);
    const Look stated = look_of(s), standard;
    EXPECT_FALSE(s.output.image);
    EXPECT_EQ(stated.floor.pattern, standard.floor.pattern);
    EXPECT_EQ(stated.walls.albedo, standard.walls.albedo);
    EXPECT_EQ(stated.deck.albedo, standard.deck.albedo);
    EXPECT_EQ(stated.sky.type, standard.sky.type);
    EXPECT_EQ(stated.samples, standard.samples);
    EXPECT_EQ(stated.colour_per_m, standard.colour_per_m);
    EXPECT_FALSE(stated.exposure_w_m2_sr || stated.sky.irradiance_w_m2);
    EXPECT_EQ(stated.overlay, Overlay::none);
}

TEST(ScenarioPicture, ACameraOfTheSceneNeedsNoBeams) {
    EXPECT_FALSE(sees_scattered_light(parse(least + above + image)));
    EXPECT_FALSE(sees_scattered_light(parse(least + above + image + "[caustics.beams]\n")));
    const std::string below = "[camera]\nposition_m = [1, 2, -1]\ntarget_m = [4, 3, 0]\n";
    EXPECT_FALSE(sees_scattered_light(parse(least + below + image)));
    EXPECT_TRUE(sees_scattered_light(parse(least + below + image + "[caustics.beams]\n")));
    EXPECT_TRUE(sees_scattered_light(parse(least + above + "[caustics.beams.reflected]\nheight_m = 4.0\n")));
    EXPECT_EQ(rejection(least + above + image, {"output.image=false"}), "accepted") << "switched off for once";
}

TEST(ScenarioPicture, WhatDoesNotGoTogetherIsRejected) {
    const Bad bads[] = {
        {"no camera", "[output]\nimage = true\n", "pool.toml:6:9: output.image:", "[camera] in the scenario"},
        {"three samples", "[picture]\nsamples = 3\n", "pool.toml:6:11: picture.samples:", "1, 2, 4 or 8"},
        {"bright", "[picture.floor]\nalbedo = [0.5, 1.2, 0.5]\n",
         "pool.toml:6:10: picture.floor.albedo:", "three numbers, each in [0, 1]"},
        {"no tile", "[picture.walls]\ntile_m = 0\n", "pool.toml:6:10: picture.walls.tile_m:", "number > 0"},
        {"a finish that is none", "[picture.deck]\npattern = \"marble\"\n",
         "pool.toml:6:11: picture.deck.pattern:", "one of plain, tiles, sand"},
        {"no map", "[picture]\noverlay = \"irradiance\"\n", "pool.toml:6:11: picture.overlay:", "a floor map to show"},
        {"no estimate", "[caustics.floor]\n[picture]\noverlay = \"error\"\n",
         "pool.toml:7:11: picture.overlay:", "accuracy.estimate = true"},
        {"truth", "[caustics.floor]\nmethod = \"truth\"\n[accuracy]\nestimate = true\n[picture]\noverlay = \"error\"\n",
         "pool.toml:10:11: picture.overlay:", "another method"},
        {"upside down", "[picture]\noverlay = \"elevation\"\nrange_low = 1.0\nrange_high = 0.5\n",
         "pool.toml:8:14: picture.range_high:", "> picture.range_low = 1"},
    };
    for (const Bad& bad : bads) {
        SCOPED_TRACE(bad.name);
        expect_rejection(bad);
    }
    const std::string above_alone = rejection(least + above + "[caustics.beams]\n");
    EXPECT_NE(above_alone.find("or output.image = true"), std::string::npos) << above_alone;
    const std::string alone = rejection(least + above);
    EXPECT_NE(alone.find("[caustics.beams] or output.image = true"), std::string::npos) << alone;
    const std::string level = rejection(least + "[camera]\nposition_m = [1, 2, 0]\ntarget_m = [4, 3, 0]\n" + image);
    EXPECT_NE(level.find("camera.position_m: found a height of 0 m"), std::string::npos) << level;
}

TEST(ScenarioPicture, AnOverlayHasTheRangeOfTheFlatPictures) {
    const auto range = [](const std::string& text) { return look_of(parse(least + text)).range; };
    const std::string scale = "[output]\nelevation_max_m = 0.02\nirradiance_max_w_m2 = 1500\n[picture]\noverlay = ";
    EXPECT_EQ(range(scale + "\"elevation\"\n").low, -0.02);
    EXPECT_EQ(range(scale + "\"elevation\"\n").high, 0.02);
    EXPECT_EQ(range(map + scale + "\"irradiance\"\n").low, 0);
    EXPECT_EQ(range(map + scale + "\"irradiance\"\n").high, 1500);
    EXPECT_EQ(range(map + "[accuracy]\nestimate = true\n" + scale + "\"error\"\n").high, 150);
    EXPECT_EQ(range(map + "[accuracy]\nestimate = true\n" + scale + "\"error\"\n").low, -150) << "it has a sign";
    EXPECT_EQ(range(scale + "\"elevation\"\nrange_low = -0.1\nrange_high = 0.3\n").high, 0.3);
    EXPECT_EQ(range(scale + "\"elevation\"\nrange_high = 0.3\n").low, -0.3);
    // 1000 W/m2 from overhead, less what the surface reflects.
    EXPECT_NEAR(range(map + "[picture]\noverlay = \"irradiance\"\n").high, 3 * 979.592, 0.01);
}

TEST(ScenarioPicture, TheHeightOfWavesThatAreStatedIsKnown) {
    const std::string overlay = "[picture]\noverlay = \"elevation\"\n";
    const std::string wave = "[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 4\n";
    EXPECT_NEAR(look_of(parse(least + overlay + wave)).range.high, 0.02, 1e-12);
    try {
        look_of(parse(least + overlay));
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("output.elevation_max_m or picture.range_high"), std::string::npos)
            << error.what();
    }
}

TEST(ScenarioPicture, TakesMemoryByItsPixelsAndSamples) {
    const double plain = estimate_memory(parse(least + above + image, {"output.image=false"})).scene;
    const Scenario s = parse(least + above + image);
    EXPECT_EQ(plain, 0);
    EXPECT_GT(estimate_memory(s).scene, 200 * 100 * 4 * 20.0);
    Scenario larger = s;
    larger.camera->camera.size *= 2;
    EXPECT_GT(estimate_memory(larger).scene - estimate_memory(s).scene, 3 * 200 * 100 * 4 * 20.0);
}

}  // namespace
}  // namespace waterlight::test
