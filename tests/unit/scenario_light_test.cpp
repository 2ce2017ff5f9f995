// What a scenario says about the light it asks for.
#include "scenarios/resolve_light.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

TEST(ScenarioLight, IsOfOneColourAndParallelUnlessAsked) {
    const Scenario s = parse(least + floor_map);
    EXPECT_TRUE(bands_of(s).empty());
    EXPECT_FALSE(s.sun.disc_deg);
}

TEST(ScenarioLight, ColoursHaveTheirWater) {
    const Scenario s = parse(least + floor_map +
                             "[light]\ncolour = \"rgb\"\ndisc_deg = 0.2665\n[water]\nsalinity_permille = 35.0\n"
                             "temperature_c = 10\nabsorption_per_m = 0.1\n");
    const std::vector<Band> bands = bands_of(s);
    ASSERT_EQ(bands.size(), 3U);
    EXPECT_EQ(bands[2].wavelength_nm, 450);
    EXPECT_EQ(bands[0].optics.absorption_per_m, 0.1 + pure_water_absorption(650));
    EXPECT_EQ(bands[1].optics.refractive_index, optics_at(550, {10, 35}, {}).refractive_index);
    EXPECT_EQ(*s.sun.disc_deg, 0.2665);
}

TEST(ScenarioLight, ListsHoldInPlaceOfPureWaterAndOfTheBlackBody) {
    const Scenario s = parse(least + floor_map +
                             "[light]\nwavelengths_nm = [600, 480.5]\nshares = [0.25, 0.5]\n[water]\n"
                             "absorption_by_band_per_m = [0.3, 0.02]\nscattering_by_band_per_m = [0, 0.1]\n");
    const std::vector<Band> bands = bands_of(s);
    ASSERT_EQ(bands.size(), 2U);
    EXPECT_EQ(bands[1].wavelength_nm, 480.5);
    EXPECT_EQ(bands[0].share, 0.25);
    EXPECT_EQ(bands[0].optics.absorption_per_m, 0.3);
    EXPECT_EQ(bands[0].optics.scattering_per_m, 0);
    EXPECT_EQ(bands[1].optics.scattering_per_m, 0.1);
}

TEST(ScenarioLight, WhatDoesNotGoTogetherIsRejected) {
    const auto expect = [](const std::string& text, const std::string& key, const std::string& found) {
        const std::string message = rejection(least + text);
        EXPECT_NE(message.find(key), std::string::npos) << message;
        EXPECT_NE(message.find(found), std::string::npos) << message;
    };
    const std::string rgb = "[light]\ncolour = \"rgb\"\n";
    expect(floor_map + "[light]\nwavelengths_nm = [300]\n", "light.wavelengths_nm",
           "list of numbers, each in [380, 700]");
    expect(floor_map + "[light]\nwavelengths_nm = []\n", "light.wavelengths_nm", "found []");
    expect(floor_map + "[light]\nwavelengths_nm = [500, 500]\n", "light.wavelengths_nm", "each once");
    expect(floor_map + rgb + "wavelengths_nm = [500]\n", "light.wavelengths_nm", "colour = \"rgb\"");
    expect(floor_map + rgb + "shares = [0.5, 0.5]\n", "light.shares", "a list of 2");
    expect(floor_map + rgb + "shares = [0.5, 0.5, 0.5]\n", "light.shares", "1.5 together");
    expect(floor_map + "[light]\nshares = [0.5]\n", "light.shares", "light of one colour");
    expect(floor_map + "[light]\ndisc_deg = 0\n", "light.disc_deg", "in (0, 10]");
    expect(floor_map + "[water]\nsalinity_permille = 35\n", "water.salinity_permille", "light of one colour");
    expect(floor_map + "[water]\nabsorption_by_band_per_m = [1.0]\n", "water.absorption_by_band_per_m",
           "light of one colour");
    expect(floor_map + rgb + "[water]\nrefractive_index = 1.33\n", "water.refractive_index", "beside light.colour");
    expect(floor_map + rgb + "[water]\ntype = \"harbour\"\n", "water.type", "beside light.colour");
    expect(rgb, "light.colour", "without [caustics.floor]");
    expect("[light]\ndisc_deg = 0.3\n", "light.disc_deg", "without [caustics.floor]");
    expect(floor_map + "[light]\nelevation_deg = 2.0\ndisc_deg = 2.5\n", "light.disc_deg",
           "at most light.elevation_deg = 2");
    EXPECT_EQ(rejection(least + floor_map + "[light]\nelevation_deg = 2.5\ndisc_deg = 2.5\n"), "accepted");
    expect(floor_map + "method = \"truth\"\nfootprint = \"pixel\"\n", "caustics.floor.footprint", "truth");
    expect(floor_map + "method = \"truth\"\n[light]\ndisc_deg = 0.3\n", "light.disc_deg", "truth");
    expect("[waves]\nboundary = { x = \"periodic\", y = \"absorbing\" }\n[caustics.walls]\n", "caustics.walls",
           "without a side that is a wall");
    expect("[caustics.walls]\npixel_m = 1e-5\n", "caustics.walls.pixel_m", "at most 1e8 pixels");
    expect("bathymetry = \"bed.vti\"\n[caustics.walls]\n", "caustics.walls", "beside domain.bathymetry");
    expect("[[domain.ground]]\ntype = \"beach\"\nat_m = [1, 1]\nslope = 0.1\n[caustics.walls]\n", "caustics.walls",
           "beside domain.ground");
    expect(floor_map + "receiver = \"ground\"\n", "caustics.floor.receiver", "model shallow-water");
    expect(floor_map + "per_area = \"horizontal\"\n", "caustics.floor.per_area", "receiver ground");
    expect(shallow_water + floor_map + "receiver = \"ground\"\nangle_deg = 5\n", "caustics.floor.angle_deg",
           "receiver flat");
    expect(floor_map + rgb + "[caustics.beams]\n", "light.colour", "beside [caustics.beams]");
}

}  // namespace
}  // namespace waterlight::test
