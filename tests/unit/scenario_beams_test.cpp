// What a scenario says about light in the water.
#include "caustics/water_types.hpp"
#include "scenarios/memory.hpp"
#include "scenarios/resolve.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

const std::string beams = "[caustics.beams]\n";
const std::string camera = "[camera]\nposition_m = [1.0, 2.0, -1.0]\ntarget_m = [4.0, 3.0, -0.5]\n";

TEST(ScenarioBeams, AreReadWithTheirCamera) {
    const Scenario s = parse(least + "[caustics.beams]\ngrid = [64, 32]\nvolume_cells = [8, 9, 10]\n" + camera +
                             "fov_deg = 70\npixels = [90, 60]\nsamples = 2\nrange_m = 12\n");
    EXPECT_EQ(s.beams->grid, glm::ivec2(64, 32));
    EXPECT_EQ(*s.beams->volume_cells, glm::ivec3(8, 9, 10));
    const BeamImageSettings image = beam_image_settings(s);
    EXPECT_EQ(image.camera.position_m, glm::dvec3(1, 2, -1));
    EXPECT_EQ(image.camera.size, glm::ivec2(90, 60));
    EXPECT_EQ(image.samples, 2);
    EXPECT_EQ(image.range_m, 12);
    EXPECT_FALSE(beam_settings(s).window) << "all that lights the domain";
}

TEST(ScenarioBeams, AWindowLiesAboutItsCentre) {
    const Scenario s = parse(least + "[caustics.beams]\nsize_m = [2.0, 1.0]\ncentre_m = [3.0, 4.0]\n");
    const BeamSettings settings = beam_settings(s);
    EXPECT_EQ(settings.window->origin_m, glm::dvec2(2, 3.5));
    EXPECT_EQ(settings.window->size_m, glm::dvec2(2, 1));
}

TEST(ScenarioBeams, AKindOfWaterHoldsWhereKeysDoNotSayOtherwise) {
    for (const WaterType& type : water_types) {
        const std::string water = "[water]\nscattering_per_m = 7.0\ntype = \"" + std::string(type.name) + "\"\n";
        const WaterOptics optics = parse(least + water).optics;
        EXPECT_EQ(optics.absorption_per_m, type.absorption_per_m);
        EXPECT_EQ(optics.scattering_per_m, 7) << "stated before the type or after it";
        EXPECT_EQ(optics.phase.type, type.phase.type);
    }
    const WaterOptics own =
        parse(least + "[water]\ntype = \"coastal\"\nphase = { g = 0.5, type = \"henyey-greenstein\" }\n").optics;
    EXPECT_EQ(own.phase.type, Phase::Type::henyey_greenstein);
    EXPECT_EQ(own.phase.g, 0.5);
}

TEST(ScenarioBeams, TheCameraSeesAsFarAsThereIsLight) {
    const std::string murky = "[water]\nabsorption_per_m = 1.0\nscattering_per_m = 1.0\n";
    EXPECT_NEAR(beam_image_settings(parse(least + beams + camera + murky)).range_m, 3.45, 1e-9);
    EXPECT_EQ(beam_image_settings(parse(least + beams + camera)).range_m, 16) << "clear water: twice the domain";
}

TEST(ScenarioBeams, WhatDoesNotGoTogetherIsRejected) {
    const auto expect = [](const std::string& text, const std::string& key, const std::string& found) {
        const std::string message = rejection(least + text);
        EXPECT_NE(message.find(key), std::string::npos) << message;
        EXPECT_NE(message.find(found), std::string::npos) << message;
    };
    expect(camera, "camera", "it without [caustics.beams]");
    expect(beams + "[camera]\nposition_m = [1, 2, 0.5]\ntarget_m = [4, 3, 0]\n", "camera.position_m",
           "a height of 0.5 m");
    expect(beams + "[camera]\nposition_m = [1, 2, -1]\ntarget_m = [1, 2, -1]\n", "camera.target_m",
           "the place of position_m");
    expect(beams + "[camera]\nposition_m = [1, 2]\ntarget_m = [4, 3, 0]\n", "camera.position_m",
           "allowed: three numbers");
    expect("[caustics.beams]\nvolume_cells = [4, 4, 0]\n", "volume_cells", "three integers, each in [1, 16384]");
    expect("[caustics.beams]\ncentre_m = [4, 4]\n", "caustics.beams.centre_m", "it without size_m");
    expect("[[probe]]\nname = \"a\"\nat_m = [1, 1]\ndepth_m = 1\n", "probe[0].depth_m", "it without [caustics.beams]");
    expect(beams + "[[probe]]\nname = \"a\"\nat_m = [1, 1]\ndepth_m = 3\n", "probe[0].depth_m",
           "at most domain.depth_m = 2");
    expect(beams + "[[check]]\nquantity = \"volume.max_cv\"\nbelow = 1\n", "check[0].quantity",
           "without caustics.beams.volume_cells");
    expect("[[check]]\nquantity = \"beams.ledger_closure\"\nbelow = 1\n", "check[0].quantity",
           "without [caustics.beams]");
    expect(beams +
               "[[probe]]\nname = \"a\"\nat_m = [1, 1]\n[[check]]\nquantity = \"probe.a.scalar_irradiance\"\n"
               "below = 1\n",
           "check[0].quantity", "without depth_m of that probe");
    expect(beams + "[[probe]]\nname = \"a\"\nat_m = [1, 1]\n[[check]]\nquantity = \"probe.a.flash_rate\"\nbelow = 1\n",
           "check[0].quantity", "without [caustics.floor]");
    expect("[water]\ntype = \"milk\"\n", "water.type", "one of none, pure, clear-ocean, coastal, harbour");
}

TEST(ScenarioBeams, GroundIsForThemWherePrescribedWavesDoNotFeelIt) {
    const std::string rock = "[[domain.ground]]\ntype = \"cone\"\nat_m = [1, 1]\ntoe_radius_m = 1.0\nheight_m = 1.0\n";
    const std::string tilted = "[waves]\nmodel = \"prescribed\"\nduration_s = 1.0\n";
    EXPECT_EQ(parse(least + rock + tilted + beams).domain.ground.size(), 1U);
    const std::string gauge = "[[probe]]\nname = \"a\"\nat_m = [3, 3]\n";
    EXPECT_NE(rejection(least + rock + tilted + beams + "[caustics.floor]\n").find("caustics.floor: found it beside"),
              std::string::npos);
    EXPECT_NE(rejection(least + rock + tilted + beams + gauge).find("probe[0]: found it beside domain.ground"),
              std::string::npos);
    EXPECT_EQ(rejection(least + rock + tilted + beams + gauge + "depth_m = 1.0\n"), "accepted");
    const std::string message = rejection(least + rock + tilted);
    EXPECT_NE(message.find("without [caustics.beams]"), std::string::npos) << message;
    // How deep the ground is shows when its file is read.
    const std::string deep = "[camera]\nposition_m = [1, 2, -2.5]\ntarget_m = [4, 3, -1]\n";
    EXPECT_EQ(parse(least + rock + tilted + beams + deep).camera->camera.position_m.z, -2.5);
}

TEST(ScenarioBeams, ACameraInTheAirSeesReflectedLight) {
    const std::string above = "[camera]\nposition_m = [1, 2, 0.5]\ntarget_m = [4, 3, 0]\n";
    const std::string reflected = "[caustics.beams.reflected]\nheight_m = 3.0\nscattering_per_m = 0.01\n";
    const Scenario s = parse(least + reflected + above);
    const BeamImageSettings image = beam_image_settings(s);
    EXPECT_EQ(image.camera.position_m, glm::dvec3(1, 2, -.5));
    EXPECT_TRUE(image.camera.mirrored);
    EXPECT_EQ(image.optics.scattering_per_m, .01);
    EXPECT_EQ(reflected_settings(s).depth_m, 3);
    EXPECT_NE(rejection(least + beams + above).find("or caustics.beams.reflected beside it"), std::string::npos);
    const std::string high = "[camera]\nposition_m = [1, 2, 3.5]\ntarget_m = [4, 3, 0]\n";
    EXPECT_NE(rejection(least + reflected + high).find("below caustics.beams.reflected.height_m = 3"),
              std::string::npos);
    const std::string refined = "[caustics.beams]\nrefine_below = 0.5\n" + reflected + above;
    EXPECT_NE(rejection(least + refined).find("caustics.beams.refine_below"), std::string::npos);
}

TEST(ScenarioBeams, FieldsThatDoNotFitTheMachineAreRejected) {
    const Scenario s = parse(least + "[caustics.beams]\nvolume_cells = [1024, 1024, 1024]\n");
    EXPECT_GT(estimate_memory(s).total(), 5e10);
    EXPECT_THROW(check_memory(s, 8e9), InputError);
}

/// What is allocated (caustics/beams.cpp): eight floats a corner, two a cell.
TEST(ScenarioBeams, GridsThatDoNotFitTheMachineAreRejected) {
    const Scenario s = parse(least + "[caustics.beams]\ngrid = [16384, 16384]\n");
    const double corners = 16385.0 * 16385, cells = 16384.0 * 16384;
    EXPECT_DOUBLE_EQ(estimate_memory(s).beams, 32 * corners + 8 * cells);
    try {
        check_memory(s, 8e9);
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("caustics.beams.grid: found [16384, 16384], which takes some 10 GiB"), std::string::npos)
            << message;
    }
    Scenario more = s;
    more.beams->reflected = ReflectedSection{};
    EXPECT_DOUBLE_EQ(estimate_memory(more).beams, 2 * estimate_memory(s).beams);
    more.beams->volume_cells = glm::ivec3(16, 16, 16);
    EXPECT_GT(estimate_memory(more).beams, 2 * estimate_memory(s).beams + 12 * corners);
}

TEST(ScenarioBeams, PicturesAndWallsTakeMemory) {
    const auto with_camera = [](const char* pixels) {
        return parse(least + beams + "[camera]\nposition_m = [1, 2, -1]\ntarget_m = [4, 3, -1]\npixels = " + pixels);
    };
    const double small = estimate_memory(with_camera("[100, 100]\n")).picture,
                 large = estimate_memory(with_camera("[10000, 10000]\n")).picture;
    EXPECT_GT(large - small, 8.0 * 9.9e7);
    EXPECT_THROW(check_memory(with_camera("[10000, 10000]\n"), 1e9), InputError);
    const auto with_walls = [](const char* pixel) {
        return estimate_memory(parse(least + "[caustics.walls]\npixel_m = " + pixel)).walls;
    };
    EXPECT_NEAR(with_walls("0.005\n") / with_walls("0.01\n"), 4, 0.05);
}

}  // namespace
}  // namespace waterlight::test
