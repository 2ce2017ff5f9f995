// The error that a wave model's surface is estimated to have is the error that it has, within a factor 1.5.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/readings.hpp"
#include "app/wave_estimate.hpp"
#include "scenarios/reader.hpp"

namespace waterlight::test {
namespace {

using Exact = std::function<double(glm::dvec2)>;

struct Errors {
    double estimated, real;
};

/// Of a scenario at time_s, at the centres of its cells.
Errors errors_of(const std::string& text, double time_s, const Exact& exact) {
    const Scenario scenario = parse_scenario(text, "test.toml");
    const BackendDecision cpu;
    const BuiltModel built = build_model(scenario);
    WaveEstimate estimate(scenario, cpu);
    built.model->advance(time_s);
    estimate.advance(time_s);
    const Surface& surface = built.model->surface();
    estimate.compute(surface);
    const Grid& g = surface.grid;
    double error = 0, square = 0;
    for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i) {
            const double e = exact({g.x_m(i), g.y_m(j)}), d = surface.elevation(i, j) - e;
            error += d * d;
            square += e * e;
        }
    return {estimate.rmse(), std::sqrt(error / square)};
}

void expect_close(const Errors& e) {
    ::testing::Test::RecordProperty("estimated", std::to_string(e.estimated));
    ::testing::Test::RecordProperty("true", std::to_string(e.real));
    EXPECT_LT(e.estimated, 1.5 * e.real);
    EXPECT_GT(e.estimated, e.real / 1.5);
}

std::string domain(int nx, int ny, const std::string& model) {
    return "[domain]\nsize_m = [2.0, 1.0]\ncells = [" + std::to_string(nx) + ", " + std::to_string(ny) +
           "]\ndepth_m = 0.5\n[waves]\nmodel = \"" + model + "\"\n";
}

TEST(WaveErrorEstimate, OfALinearStandingWaveAgainstItsFormula) {
    const std::string text =
        domain(48, 24, "linear") + "[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 4\nhalf_waves_y = 2\n";
    const double kx = 2 * std::numbers::pi, ky = 2 * std::numbers::pi, w = std::sqrt(9.81 * 0.5) * std::hypot(kx, ky);
    for (const double time_s : {0.5, 1.3, 2.0})
        expect_close(errors_of(text, time_s, [&](glm::dvec2 at) {
            return 0.01 * std::cos(kx * at.x) * std::cos(ky * at.y) * std::cos(w * time_s);
        }));
}

/// The same model with five times the cells along each side, which have among them the places of its own.
Errors against_finer(const std::string& model, int rows, const std::string& waves, double time_s) {
    const Scenario finer = parse_scenario(domain(10 * rows, 5 * rows, model) + waves, "test.toml");
    const BuiltModel built = build_model(finer);
    built.model->advance(time_s);
    const Surface& surface = built.model->surface();
    return errors_of(domain(2 * rows, rows, model) + waves, time_s,
                     [&](glm::dvec2 at) { return elevation_at(surface, at); });
}

TEST(WaveErrorEstimate, OfADropInAiryWaves) {
    for (const char* radius : {"0.03", "0.04", "0.05"})
        expect_close(against_finer("airy", 32,
                                   std::string("[[waves.source]]\ntype = \"drop\"\nat_m = [0.9, 0.45]\nheight_m = "
                                               "0.02\nradius_m = ") +
                                       radius + "\n",
                                   0.6));
}

TEST(WaveErrorEstimate, OfADropInShallowWater) {
    expect_close(against_finer("shallow-water", 64,
                               "[[waves.source]]\ntype = \"drop\"\nat_m = [0.9, 0.45]\nheight_m = 0.02\nradius_m = "
                               "0.35\n",
                               0.3));
}

TEST(WaveErrorEstimate, OfADamThatBreaks) {
    expect_close(against_finer("shallow-water", 64,
                               "[[waves.initial]]\ntype = \"dam\"\nat_m = [1.0, 0.5]\nbehind_level_m = "
                               "0.1\nahead_level_m = -0.1\n",
                               0.2));
}

}  // namespace
}  // namespace waterlight::test
