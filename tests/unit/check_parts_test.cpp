// The pieces of `check`, each against what it must give.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "app/judge.hpp"
#include "app/junit.hpp"
#include "app/probe_spectrum.hpp"
#include "app/process.hpp"
#include "scenarios/exact.hpp"
#include "sim/field_norms.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

using std::numbers::pi;

std::vector<double> sine(double amplitude, double period_s, double every_s, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(0.3 + amplitude * std::cos(2 * pi * i * every_s / period_s + 1));
    return values;
}

TEST(ProbeSpectrum, ASineHasItsHeightAndItsPeriodWhereverItFallsBetweenBins) {
    for (const double period : {1.0, 1.0371, 2.618, 4.9}) {
        const std::vector<double> series = sine(0.2, period, 0.1, 1000);
        EXPECT_NEAR(significant_height(series), 4 * 0.2 / std::sqrt(2.0), 0.01 * 0.2);
        EXPECT_LT(std::abs(1 / peak_period(series, 0.1) - 1 / period) * 100, 0.2)
            << period << " s, in bins of 1/(100 s)";
    }
}

TEST(ProbeSpectrum, TheStrongerOfTwoWavesHasThePeak) {
    std::vector<double> series = sine(0.2, 3, 0.1, 2000), ripple = sine(0.08, 0.7, 0.1, 2000);
    for (std::size_t i = 0; i < series.size(); ++i) series[i] += ripple[i];
    EXPECT_NEAR(peak_period(series, 0.1), 3, 0.02);
}

TEST(ProbeSpectrum, StillWaterHasNoPeriod) {
    EXPECT_EQ(significant_height(std::vector<double>(64, 0.5)), 0);
    EXPECT_TRUE(std::isnan(peak_period(std::vector<double>(64, 0.5), 0.1)));
    EXPECT_TRUE(std::isnan(peak_period(std::vector<double>(3, 0.5), 0.1)));
    EXPECT_TRUE(std::isnan(significant_height({})));
}

TEST(FieldNorms, AreThoseOfTheirDefinitions) {
    const std::vector<float> values{1, -3, 2, 0};
    const FieldNorms n = norms_of(std::span<const float>(values));
    EXPECT_DOUBLE_EQ(n.min, -3);
    EXPECT_DOUBLE_EQ(n.max, 2);
    EXPECT_DOUBLE_EQ(n.mean, 0);
    EXPECT_DOUBLE_EQ(n.l1, 1.5);
    EXPECT_DOUBLE_EQ(n.l2, std::sqrt(14.0 / 4));
    EXPECT_DOUBLE_EQ(n.linf, 3);
}

TEST(FieldNorms, OfOneThatIsNotANumberAreNone) {
    for (const std::vector<double>& values :
         {std::vector<double>{}, std::vector<double>{1, std::nan(""), 2}, std::vector<double>{std::nan(""), 1}}) {
        const FieldNorms n = norms_of(std::span<const double>(values));
        for (const double x : {n.min, n.max, n.mean, n.l1, n.l2, n.linf}) EXPECT_TRUE(std::isnan(x));
    }
}

/// Any norm of a sum is at most the sum of the norms, and all of them scale.
TEST(FieldNorms, AreNorms) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<double> a(257), b(257), sum(257), twice(257);
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = normal(random);
        b[i] = normal(random);
        sum[i] = a[i] + b[i];
        twice[i] = -2 * a[i];
    }
    const auto of = [](const std::vector<double>& v) { return norms_of(std::span<const double>(v)); };
    for (double FieldNorms::*norm : {&FieldNorms::l1, &FieldNorms::l2, &FieldNorms::linf}) {
        EXPECT_LE(of(sum).*norm, of(a).*norm + of(b).*norm);
        EXPECT_NEAR(of(twice).*norm, 2 * of(a).*norm, 1e-12);
    }
    EXPECT_LE(of(a).l1, of(a).l2);
    EXPECT_LE(of(a).l2, of(a).linf);
}

const std::string standing =
    least + "[waves]\nmodel = \"airy\"\n[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 2\nhalf_waves_y = 3\n";

/// The wave equation holds for the exact field, with the model's own frequency: eta_tt = -w2 eta.
TEST(ExactFields, FreeWavesOscillateWithTheFrequencyOfTheirModel) {
    for (const bool airy : {true, false}) {
        const Scenario s = parse(standing, {airy ? "waves.model=airy" : "waves.model=linear"});
        const double k = pi * std::hypot(2 / 8.0, 3 / 6.0), g = s.water.gravity_m_s2;
        const double tension = s.water.surface_tension_n_m / s.water.density_kg_m3;
        const double w2 = airy ? (g * k + tension * k * k * k) * std::tanh(k * 2.0) : g * 2.0 * k * k;
        const double dt = 1e-3, t = 0.4;
        const auto at = [&](double time_s) { return exact_field(s, "surface.elevation", time_s)(5, 7); };
        EXPECT_NEAR((at(t - dt) - 2 * at(t) + at(t + dt)) / (dt * dt), -w2 * at(t), 1e-5 * w2 * 0.01);
    }
}

TEST(ExactFields, SlopesAreThoseOfTheElevation) {
    const Scenario s = parse(standing);
    const Field<double> e = exact_field(s, "surface.elevation", 0.2);
    const Field<double> x = exact_field(s, "surface.slope_x", 0.2), y = exact_field(s, "surface.slope_y", 0.2);
    // A central difference is off by a k3 d2 / 6 at most.
    const auto room = [](double k) { return 0.01 * k * k * k * 0.125 * 0.125 / 6; };
    EXPECT_NEAR(x(10, 9), (e(11, 9) - e(9, 9)) / 0.25, room(pi * 2 / 8));
    EXPECT_NEAR(y(10, 9), (e(10, 10) - e(10, 8)) / 0.25, room(pi * 3 / 6));
}

TEST(ExactFields, AreKnownOnlyWhereNothingElseMovesTheWater) {
    const char* drop = "waves.source=[{type=\"drop\", at_m=[1.0, 1.0]}]";
    EXPECT_TRUE(has_exact(parse(standing), "surface.elevation"));
    EXPECT_FALSE(has_exact(parse(standing, {drop}), "surface.elevation"));
    EXPECT_FALSE(has_exact(parse(standing), "surface.depth"));
    EXPECT_FALSE(has_exact(parse(least), "surface.elevation"));
}

Check one(const std::string& text) {
    return parse(least + "[waves]\nduration_s = 4.0\n[[check]]\nquantity = \"waves.max_elevation\"\n" + text)
        .checks.front();
}

std::vector<bool> judged(const std::string& text, double value) {
    std::vector<bool> passes;
    for (const CheckResult& result : judge({one(text)}, std::vector<double>{value})) passes.push_back(result.pass);
    return passes;
}

TEST(Judge, BetweenIncludesItsEnds) {
    for (const double inside : {1.0, 1.5, 2.0}) EXPECT_EQ(judged("between = [1.0, 2.0]\n", inside), std::vector{true});
    for (const double outside : {0.999, 2.001, std::nan("")})
        EXPECT_EQ(judged("between = [1.0, 2.0]\n", outside), std::vector{false});
}

TEST(Judge, EachBoundOfACheckIsJudgedByItself) {
    EXPECT_EQ(judged("below = 2.0\nabove = 1.0\nequals = 1.5\ntolerance = 0.1\n", 1.7),
              (std::vector{false, true, true}));
}

TEST(Judge, TheNameTellsWhenAndAgainstWhat) {
    EXPECT_EQ(name_of(one("below = 2.0\n")), "waves.max_elevation");
    EXPECT_EQ(name_of(one("below = 2.0\nat_s = 1.5\n")), "waves.max_elevation at 1.5 s");
    EXPECT_EQ(name_of(one("below = 2.0\nwindow_s = [1.0, 2.0]\nover = \"rms\"\n")),
              "waves.max_elevation over 1 to 2 s, rms");
}

TEST(ShellText, QuotesWhatAShellWouldRead) {
    EXPECT_EQ(shell_text({"waterlight", "check", "a/b.toml"}), "waterlight check a/b.toml");
    EXPECT_EQ(shell_text({"it's", "a b", "x*", ""}), "'it'\\''s' 'a b' 'x*' ''");
}

}  // namespace
}  // namespace waterlight::test
