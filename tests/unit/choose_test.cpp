// What is chosen where a scenario leaves it open, and what is said about it.
#include "scenarios/choose.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "caustics/demand.hpp"
#include "scenarios/build.hpp"
#include "scenarios/number.hpp"
#include "scenarios/resolve.hpp"
#include "sim/spectrum.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

const std::string open_pool = "[domain]\nsize_m = [8.0, 6.0]\ndepth_m = 2.0\n";

Decision chosen(const std::string& text) { return choose(parse_scenario(text, "pool.toml")); }

/// A wave of k h on 1 m of water, that runs n of its periods.
std::string sine(double kh, double amplitude, double n, const std::string& more = "") {
    const double length = 6.283185307179586 / kh;
    const double period = 6.283185307179586 / std::sqrt(9.81 * kh * std::tanh(kh));
    return "[domain]\nsize_m = [" + std::to_string(4 * length) + ", " + std::to_string(2 * length) +
           "]\ndepth_m = 1.0\n[water]\nsurface_tension_n_m = 0.0\n[output]\nevery_s = " + std::to_string(n * period) +
           "\n" + more +
           "[waves]\nboundary = { x = \"periodic\", y = \"periodic\" }\nduration_s = " + std::to_string(n * period) +
           "\n[[waves.sine]]\namplitude_m = " + std::to_string(amplitude) +
           "\nwavelength_m = " + std::to_string(length) + "\n";
}

TEST(Choose, EachRungHasItsScenes) {
    EXPECT_EQ(chosen(sine(20, 1e-3, 5)).choice().model, ModelChoice::airy);
    EXPECT_EQ(chosen(sine(0.05, 0.1, 0.6)).choice().model, ModelChoice::shallow_water);
    EXPECT_TRUE(chosen(sine(20, 1e-3, 5)).meets);
    EXPECT_TRUE(chosen(sine(0.05, 0.1, 0.6)).meets);
}

TEST(Choose, SaysWhereNoRungHolds) {
    const Decision between = chosen(sine(0.5, 0.1, 3));
    EXPECT_EQ(between.beyond, Beyond::dispersive_and_nonlinear);
    EXPECT_NE(between.warning().find("no model meets the tolerance"), std::string::npos) << between.warning();
    EXPECT_NE(between.warning().find("least wrong"), std::string::npos) << between.warning();
    EXPECT_EQ(chosen(sine(20, 0.03, 1)).beyond, Beyond::breaking);
    EXPECT_TRUE(chosen(sine(20, 1e-3, 5)).warning().empty());
}

TEST(Choose, ASmallerToleranceTakesMoreCells) {
    int before = 0;
    for (const double tolerance : {0.1, 0.02, 0.005}) {
        const Decision d = chosen(sine(0.05, 1e-4, 1, "[accuracy]\ntolerance = " + std::to_string(tolerance) + "\n"));
        EXPECT_TRUE(d.meets) << tolerance;
        EXPECT_LE(d.choice().error(), tolerance);
        EXPECT_GT(d.choice().cells.x, before) << tolerance;
        before = d.choice().cells.x;
    }
}

TEST(Choose, WhatAKeyForbidsIsNotTaken) {
    const Decision sea = chosen(open_pool + "[waves.spectrum]\n");
    EXPECT_EQ(sea.choice().model, ModelChoice::airy);
    EXPECT_EQ(sea.rungs.front().refusal, "waves.spectrum");
    const Decision dam = chosen(open_pool +
                                "[waves]\nduration_s = 1\n[[waves.initial]]\ntype = \"circular-dam\"\n"
                                "centre_m = [4, 3]\nradius_m = 2\ninside_level_m = 0.5\n");
    EXPECT_EQ(dam.choice().model, ModelChoice::shallow_water);
    EXPECT_EQ(chosen(open_pool + "[waves.gerstner]\n").choice().model, ModelChoice::prescribed);
}

TEST(Choose, SettlingFillsWhatIsOpenAndKeepsWhatIsStated) {
    Scenario s = parse_scenario(
        open_pool +
            "cells = \"auto\"\n[waves]\nduration_s = 2\n[[waves.source]]\ntype = \"drop\"\nat_m = [4, 3]\n"
            "[caustics.floor]\npixels = [100, 80]\n[caustics.beams]\ngrid = \"auto\"\n",
        "pool.toml");
    ASSERT_TRUE(is_open(s));
    settle(s, choose(s));
    EXPECT_FALSE(is_open(s));
    EXPECT_GT(s.domain.cells.x, s.domain.cells.y);
    EXPECT_EQ(s.floor->pixels, glm::ivec2(100, 80));
    EXPECT_GT(s.beams->grid.x, 16);
    EXPECT_FALSE(s.decided->reasons.empty());
    check_combinations(s);
}

/// What the choice of cells does not look at is not resampled on them.
TEST(Choose, CellsAreStatedWhereMoreThanWavesHangsOnThem) {
    const auto expect = [](const std::string& text, const std::string& reason) {
        const std::string message = rejection(open_pool + text);
        EXPECT_NE(message.find("domain.cells: found none; allowed: cells stated"), std::string::npos) << message;
        EXPECT_NE(message.find(reason), std::string::npos) << message;
        EXPECT_EQ(rejection(open_pool + "cells = [64, 48]\n" + text), "accepted");
    };
    const std::string shape = "[[domain.ground]]\ntype = \"plane\"\nlevel_m = -1.0\nslope = ";
    expect("[waves]\nfile = \"surface.vti\"\n", "waves.file");
    expect("bathymetry = \"bed.vti\"\n", "the ground");
    expect(shape + "[0.1, 0.0]\n", "the ground");
    expect("[caustics.walls]\n", "[caustics.walls]");
    EXPECT_EQ(rejection(open_pool + shape + "[0.0, 0.0]\n"), "accepted");
}

TEST(Choose, StrictRefusesWhatNoModelMeets) {
    Scenario s = parse_scenario(sine(0.5, 0.1, 3, "[accuracy]\nstrict = true\n"), "pool.toml");
    EXPECT_THROW(settle(s, choose(s)), InputError);
    s.accuracy.strict = false;
    settle(s, choose(s));
    EXPECT_FALSE(s.decided->warning.empty());
}

/// The variance of a scene is that of its waves: a sine's a^2/2, the m0 of a sea.
TEST(SceneSpectrum, HasTheVarianceOfItsSources) {
    EXPECT_DOUBLE_EQ(scene_spectrum(parse_scenario(sine(1, 0.02, 1), "pool.toml")).variance_m2(), 0.0002);
    const Scenario sea = parse_scenario(
        open_pool + "[waves]\nduration_s = 1\n[waves.spectrum]\nsignificant_height_m = 0.2\npeak_period_s = 1\n",
        "pool.toml");
    EXPECT_NEAR(scene_spectrum(sea).variance_m2() / std::pow(0.2 / 4, 2), 1, 0.02);
}

/// A drop's transform, summed over its bins, is the mean square of its profile: the integral of h^2 (1 - q)^2 exp(-2q)
/// over the plane is pi R^2 h^2 / 4.
TEST(SceneSpectrum, BinsOfADropAddUpToItsMeanSquare) {
    const Scenario s = parse_scenario(open_pool +
                                          "[waves]\nduration_s = 1\n[[waves.source]]\ntype = \"drop\"\nat_m = [4, 3]\n"
                                          "radius_m = 0.2\nheight_m = 0.01\n",
                                      "pool.toml");
    const double expected = 3.14159265358979 * 0.04 * 1e-4 / 4 / 48;
    EXPECT_NEAR(scene_spectrum(s).variance_m2() / expected, 1, 0.02);
}

TEST(CausticDemand, IsThatOfTheDesign) {
    const double overhead = focusing({}, 4.0 / 3);
    EXPECT_NEAR(overhead, 0.25, 1e-9);
    EXPECT_DOUBLE_EQ(caustic_contrast(12, 0.01, 2, 0.25), 0.25 * 2 * 0.01 * 144);
    EXPECT_NEAR(focus_depth(4 * 3.14159265358979, 0.01, overhead), 2.533, 1e-3);
    EXPECT_NEAR(landing_reach(0.01, 3, 0, {}, 4.0 / 3).x, 3 * 0.01 / 4, 1e-5);
}

/// Snell, differentiated by hand: a slope turns the normal, and the light in the water by 1 - cos i / (n cos t) of
/// that; its tangent changes by 1 / cos^2 t as much.
TEST(CausticDemand, FollowsTheSlantedSun) {
    constexpr double n = 4.0 / 3;
    for (const double elevation : {80.0, 45.0, 10.0, 2.0}) {
        const double cos_i = std::sin(elevation * 3.14159265358979 / 180);
        const double cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (n * n));
        for (const double azimuth : {0.0, 77.0})
            EXPECT_NEAR(focusing({elevation, azimuth, 1000}, n), (1 - cos_i / (n * cos_t)) / (cos_t * cos_t), 1e-6);
    }
    const glm::dvec2 reach = landing_reach(0.01, 3, 0, {30, 0, 1000}, n);
    EXPECT_GT(reach.x, 1.5 * reach.y);
    EXPECT_EQ(landing_reach(0.01, 3, 0, {-1, 0, 1000}, n), glm::dvec2(0, 0));
}

/// A wave that fits the domain.
const std::string lit_sine =
    "[domain]\nsize_m = [4.0, 2.0]\ncells = [512, 256]\ndepth_m = 1.5\n[waves]\nmodel = \"prescribed\"\n"
    "[[waves.sine]]\namplitude_m = 0.004\nwavelength_m = 0.4472135955\ndirection_deg = 26.565051177\nfrozen = true\n"
    "[caustics.floor]\npixels = [512, 256]\n";

/// The window that is forecast holds that which the map then takes, and is not much wider.
TEST(LightDemand, ForecastsTheWindowOfTheMap) {
    for (const double elevation : {90.0, 40.0, 15.0})
        for (const char* more : {"", "samples_per_pixel = 3\n", "angle_deg = 30\n"}) {
            const Scenario s = parse_scenario(
                lit_sine + more + "[light]\nazimuth_deg = 20\nelevation_deg = " + std::to_string(elevation) + "\n",
                "pool.toml");
            FloorMap map;
            make_floor_cpu(floor_settings(s))->compute(build_model(s).model->surface(), map);
            const glm::ivec2 forecast = choose(s).light.window, used{map.window.samples, map.window.channels};
            EXPECT_GE(forecast.x, used.x) << elevation << more;
            EXPECT_GE(forecast.y, used.y) << elevation << more;
            EXPECT_LE(forecast.x, 1.8 * used.x + 4) << elevation << more;
        }
}

TEST(LightDemand, NoFootprintIsWorseThanNoContrast) {
    const LightDemand coarse = chosen(open_pool +
                                      "cells = [64, 48]\n[waves]\nmodel = \"prescribed\"\n[[waves.sine]]\n"
                                      "amplitude_m = 0.0001\nwavelength_m = 0.05\n"
                                      "[caustics.floor]\npixels = [1, 1]\n")
                                   .light;
    EXPECT_GT(coarse.contrast, 0.01);
    EXPECT_LE(coarse.footprint_error, coarse.contrast);
}

TEST(LightDemand, IsPartOfTheVerdict) {
    EXPECT_EQ(chosen(lit_sine).light_warning(), "");
    EXPECT_NE(chosen(lit_sine + "footprint = \"pixel\"\n").light_warning().find("the floor map is not resolved"),
              std::string::npos);
    Scenario open = parse_scenario(lit_sine, "pool.toml");
    for (const double depth : {1.5, 40.0}) {
        open.domain.depth_m = depth;
        open.floor->pixels = {8, 4};
        EXPECT_NE(choose(open).light_warning(), "") << depth;
        open.floor->pixels = {0, 0};
        const Decision d = choose(open);
        EXPECT_EQ(d.light_warning(), "") << depth;
        EXPECT_GT(d.light.pixels.x, 8);
    }
}

double light_seconds_of(const std::string& text) { return chosen(lit_sine + text).light.seconds; }

/// The multiples of the plain map that docs/light.md measured.
TEST(LightCost, IsThatOfEachPart) {
    const double plain = light_seconds_of("");
    EXPECT_NEAR(light_seconds_of("samples_per_pixel = 3\n") / plain, 9, 1e-9);
    EXPECT_NEAR(light_seconds_of("[light]\ncolour = \"rgb\"\n") / plain, 2.8, 0.3);
    const Scenario s = parse_scenario(lit_sine, "pool.toml");
    const double pixel = 4.0 / 512;
    // Overhead the disc's radius on the floor is D r / n.
    for (const auto& [pixels, factor] : {std::pair{0.9, 1.4}, {4.5, 1.9}, {16.0, 3.8}}) {
        const double half_angle = pixels * pixel / (1.5 / s.optics.refractive_index) * 180 / 3.14159265358979;
        EXPECT_NEAR(light_seconds_of("[light]\ndisc_deg = " + std::to_string(half_angle) + "\n") / plain, factor, 0.1)
            << pixels;
    }
    const auto pool = [](const char* more) {
        return chosen(open_pool + "cells = [512, 384]\n[caustics.floor]\npixels = [1024, 768]\n" + more).light.seconds;
    };
    EXPECT_NEAR(pool("[caustics.walls]\n") / pool(""), 1 + 4.5, 0.5);
    const char* on_ground = "receiver = \"ground\"\n[waves]\nmodel = \"shallow-water\"\n";
    EXPECT_NEAR(pool(on_ground) / pool(""), 150, 1);
}

/// The times that docs/performance.md measured of a picture whose pixels 42 % see beams, and of fields.
TEST(LightCost, OfPicturesAndFieldsIsThatMeasured) {
    const std::string pool = "[domain]\nsize_m = [3.0, 3.0]\ncells = [256, 256]\ndepth_m = 2.0\n";
    const auto seconds = [&](int n, const std::string& more) {
        const std::string grid = "[" + std::to_string(n) + ", " + std::to_string(n) + "]\n";
        return chosen(pool + "[caustics.beams]\ngrid = " + grid + more).light.seconds;
    };
    const std::string camera = "[camera]\nposition_m = [1.5, -3.2, -0.8]\ntarget_m = [1.5, 1.5, -1]\npixels = ";
    const auto picture = [&](int n, const char* pixels) { return seconds(n, camera + pixels) - seconds(n, ""); };
    EXPECT_NEAR(0.42 * picture(32, "[900, 600]\n"), 0.0235, 0.006);
    EXPECT_NEAR(0.42 * picture(128, "[900, 600]\n"), 0.123, 0.03);
    EXPECT_NEAR(picture(64, "[1800, 600]\n") / picture(64, "[900, 600]\n"), 2, 1e-6);
    EXPECT_NEAR(seconds(128, "volume_cells = [128, 128, 128]\n"), 0.315, 0.03);
    EXPECT_NEAR(seconds(128, "[caustics.beams.reflected]\nheight_m = 1.0\n") / seconds(128, ""), 2, 1e-6);
}

TEST(Numbers, HaveNoExponentsBelowTenThousand) {
    EXPECT_EQ(rounded(100, 2), "100");
    EXPECT_EQ(rounded(1174, 2), "1200");
    EXPECT_EQ(rounded(9996, 2), "10000");
    EXPECT_EQ(rounded(0.0214, 2), "0.021");
    EXPECT_EQ(rounded(0.00055, 1), "0.0006");
    EXPECT_EQ(rounded(0.000055, 2), "0.000055");
    EXPECT_EQ(rounded(0.0999, 2), "0.1");
    EXPECT_EQ(rounded(-99.6, 2), "-100");
    EXPECT_EQ(rounded(99.6, 3), "99.6");
    EXPECT_EQ(rounded(0, 2), "0");
    EXPECT_EQ(rounded(12345, 2), "1.2e+04");
    EXPECT_EQ(percent(2.1), "210 %");
}

}  // namespace
}  // namespace waterlight::test
