// Rates and lengths of flashes in series whose crossings are known, and in the light under travelling waves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/beam_stage.hpp"
#include "app/flashes.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

using std::numbers::pi;

TEST(Flashes, OfASawtoothAreKnown) {
    // From 0 to 2 and back in 2 s, five times: mean 1, above 1.5 for half a second in each.
    LightSeries saw;
    for (int i = 0; i <= 10; ++i) {
        saw.time_s.push_back(i);
        saw.irradiance_w_m2.push_back(i % 2 == 0 ? 0 : 2);
    }
    const Flicker flicker = flicker_of(saw);
    EXPECT_NEAR(flicker.mean, 1, 1e-12);
    EXPECT_NEAR(flicker.cv, 1 / std::sqrt(3.0), 1e-12) << "of values spread evenly over [0, 2]";
    EXPECT_NEAR(flicker.skewness, 0, 1e-12);
    EXPECT_NEAR(flicker.flash_rate_hz, .5, 1e-12);
    EXPECT_NEAR(flicker.longest_flash_s, .5, 1e-12);
    EXPECT_EQ(flicker.sampled_every_s, 1);
}

TEST(Flashes, OfUnevenStepsCountByTimeAndNotByRow) {
    LightSeries wave;
    for (double t = 0; t < 8; t += t < 4 ? .001 : .01) {
        wave.time_s.push_back(t);
        wave.irradiance_w_m2.push_back(std::exp(std::cos(2 * pi * t)));
    }
    wave.time_s.push_back(8);
    wave.irradiance_w_m2.push_back(std::exp(1));
    const Flicker flicker = flicker_of(wave);
    // The moments of exp(cos) are the modified Bessel functions I0(1), I0(2).
    EXPECT_NEAR(flicker.mean, std::cyl_bessel_i(0, 1), 1e-3);
    EXPECT_NEAR(flicker.cv, std::sqrt(std::cyl_bessel_i(0, 2) / std::pow(std::cyl_bessel_i(0, 1), 2) - 1), 1e-3);
    const double half = std::acos(std::log(1.5 * flicker.mean)) / (2 * pi);
    EXPECT_NEAR(flicker.longest_flash_s, 2 * half, 1e-4);
    EXPECT_NEAR(flicker.flash_rate_hz, 1, 1e-12) << "the first was there already, the last just began";
}

TEST(Flashes, OfSteadyLightThereAreNone) {
    const Flicker flicker = flicker_of({{0, 1, 2}, {5, 5, 5}});
    EXPECT_EQ(flicker.mean, 5);
    EXPECT_EQ(flicker.cv, 0);
    EXPECT_EQ(flicker.flash_rate_hz, 0);
    EXPECT_EQ(flicker.longest_flash_s, 0);
    EXPECT_EQ(flicker_of({{0}, {7}}).mean, 7);
}

TEST(Flashes, UnderATravellingSineThereIsOneAPeriod) {
    // Half way to the focus, in the fields and at a place; 16 frames a period of the waves.
    const Scenario scenario = parse(
        "[domain]\nsize_m = [0.5, 0.5]\ncells = [128, 4]\ndepth_m = 2.0\n[waves]\nmodel = \"prescribed\"\n"
        "[[waves.sine]]\namplitude_m = 0.01\nwavelength_m = 0.5\n[light]\nelevation_deg = 90.0\n"
        "irradiance_w_m2 = 1.0\n[caustics.beams]\ngrid = [256, 4]\nvolume_cells = [128, 1, 4]\n");
    const BuiltModel waves = build_model(scenario);
    const double k = 4 * pi, g = scenario.water.gravity_m_s2;
    const double capillary = scenario.water.surface_tension_n_m / scenario.water.density_kg_m3;
    const double period = 2 * pi / std::sqrt((g * k + capillary * k * k * k) * std::tanh(2 * k));
    BeamStage stage(scenario, waves, make_beam_renderer_cpu());
    LightSeries series;
    constexpr int frames = 16, periods = 5;
    for (int i = 0; i <= periods * frames; ++i) {
        if (i > 0) waves.model->advance(period / frames);
        stage.compute(waves.model->surface());
        stage.add_frame(i * period / frames);
        series.time_s.push_back(i * period / frames);
        // The trough comes first.
        series.irradiance_w_m2.push_back(stage.irradiance_at({.25, .25}, 1.25).plane_w_m2);
    }
    const Flicker flicker = flicker_of(series);
    EXPECT_NEAR(flicker.flash_rate_hz * period, 1, 1e-9);
    EXPECT_NEAR(flicker.mean, .98, .02);
    const BeamRecord record = stage.record();
    EXPECT_NEAR(record.sampled_every_s, period / frames, 1e-12);
    // Slices at 0.25, 0.75, 1.25 and 1.75 m: E / mean = 1 / (1 - 0.395 (D + a)) reaches 1.5 from 0.83 m on.
    EXPECT_EQ(record.slices[0].flash_rate_hz, 0);
    EXPECT_EQ(record.slices[1].flash_rate_hz, 0);
    EXPECT_NEAR(record.slices[2].flash_rate_hz * period, 1, .02) << "but for those that began before the first frame";
    EXPECT_NEAR(record.slices[3].flash_rate_hz * period, 1, .02);
}

}  // namespace
}  // namespace waterlight::test
