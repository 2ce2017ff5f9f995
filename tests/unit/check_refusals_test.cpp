// A check that cannot be judged is refused before anything is run, with what would be allowed.
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

const std::string run =
    least +
    "[waves]\nduration_s = 4.0\n[caustics.floor]\npixels = [8, 8]\n[[probe]]\nname = \"g\"\nat_m = [1.0, 1.0]\n";

struct Refused {
    const char* name;
    const char* check;  ///< after [[check]]
    const char* says;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.name; }

class RefusedCheck : public ::testing::TestWithParam<Refused> {};

TEST_P(RefusedCheck, SaysWhatIsAllowed) {
    const std::string message = rejection(run + "[[check]]\n" + GetParam().check);
    EXPECT_NE(message.find("check[0]"), std::string::npos) << message;
    EXPECT_NE(message.find(GetParam().says), std::string::npos) << message;
    EXPECT_NE(message.find("; allowed: "), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedCheck,
    ::testing::Values(
        Refused{"Misspelt", "quantity = \"floor.cw\"\nbelow = 1.0\n", "did you mean \"floor.cv\"?"},
        Refused{"MisspeltStatistic", "quantity = \"surface.elevation.linv\"\nbelow = 1.0\n",
                "did you mean \"surface.elevation.linf\"?"},
        Refused{"MisspeltProbe", "quantity = \"probe.g.elevatoin\"\nbelow = 1.0\n",
                "did you mean \"probe.g.elevation\"?"},
        Refused{"SeaWithoutASea", "quantity = \"sea.height_error\"\nbelow = 1.0\n",
                "without waves.spectrum or waves.buoy"},
        Refused{"BeamsWithoutBeams", "quantity = \"beams.ledger.floor\"\nbelow = 1.0\n", "without [caustics.beams]"},
        Refused{"VelocityOfAiry", "quantity = \"surface.velocity_x.max\"\nbelow = 1.0\n", "model shallow-water"},
        Refused{"TruthErrorOfTwoPass", "quantity = \"floor.truth_error\"\nbelow = 1.0\n", "method truth"},
        Refused{"NoExpectation", "quantity = \"floor.cv\"\n", "found no expectation"},
        Refused{"EqualsWithoutTolerance", "quantity = \"floor.cv\"\nequals = 1.0\n", "without a tolerance"},
        Refused{"BetweenTheWrongWayRound", "quantity = \"floor.cv\"\nbetween = [2.0, 1.0]\n", "[least, greatest]"},
        Refused{"AfterTheEnd", "quantity = \"floor.cv\"\nbelow = 1.0\nat_s = 5.0\n", "at most waves.duration_s = 4"},
        Refused{"WindowAfterTheEnd", "quantity = \"floor.cv\"\nbelow = 1.0\nwindow_s = [3.0, 5.0]\n",
                "within [0, waves.duration_s = 4]"},
        Refused{"WindowTooShort", "quantity = \"floor.cv\"\nbelow = 1.0\nwindow_s = [3.0, 3.01]\n", "at least 0.1 s"},
        Refused{"TimeAndWindow", "quantity = \"floor.cv\"\nbelow = 1.0\nat_s = 1.0\nwindow_s = [1.0, 2.0]\n",
                "one of both"},
        Refused{"WindowOfTheRunSoFar", "quantity = \"waves.mass_drift\"\nbelow = 1.0\nwindow_s = [1.0, 2.0]\n",
                "tells of the run so far"},
        Refused{"OverWithoutWindow", "quantity = \"floor.cv\"\nbelow = 1.0\nover = \"max\"\n", "window_s beside it"},
        Refused{"SpectrumOfAFewRows", "quantity = \"probe.g.peak_period\"\nbelow = 1.0\nat_s = 1.0\n", "too few rows"},
        Refused{"ReferenceOfANumber", "quantity = \"floor.cv\"\nbelow = 1.0\nreference = \"exact\"\n",
                "a statistic of a field"},
        Refused{"NoExactState", "quantity = \"surface.elevation.l2\"\nbelow = 1.0\nreference = \"exact\"\n",
                "standing waves and sines alone"},
        Refused{"ReferenceOfAnotherKind", "quantity = \"surface.elevation.l2\"\nbelow = 1.0\nreference = \"a.png\"\n",
                "a .vti, a .pvd or a .toml"},
        Refused{"ReferenceThatNoFileHas", "quantity = \"surface.slope_x.l2\"\nbelow = 1.0\nreference = \"a.vti\"\n",
                "a file of surface.slope_x"},
        Refused{"RelativeToNothing", "quantity = \"surface.elevation.relative_l2\"\nbelow = 1.0\n",
                "without a reference"},
        Refused{"OrderOfOneValue",
                "quantity = \"floor.cv\"\norder = { key = \"domain.cells\", values = [[8, 8]], at_least = 1.0 }\n",
                "list of two values or more"},
        Refused{"OrderOfOneResolution",
                "quantity = \"floor.cv\"\norder = { key = \"domain.cells\", values = [8, 8], at_least = 1.0 }\n",
                "list of two values or more"},
        Refused{"OrderOverNoKey",
                "quantity = \"floor.cv\"\norder = { key = \"domain.sells\", values = [1, 2], at_least = 1.0 }\n",
                "did you mean \"domain.cells\"?"},
        Refused{"OrderAndABound",
                "quantity = \"floor.cv\"\nbelow = 1.0\norder = { key = \"waves.cfl\", values = [0.1, 0.2], at_least = "
                "1.0 }\n",
                "order alone"},
        Refused{"AgreementWithoutTolerance", "quantity = \"floor.cv\"\nagrees = { backend = \"vulkan\" }\n",
                "without a tolerance"},
        Refused{"AgreementOfWhatTheCpuAloneComputes",
                "quantity = \"surface.elevation.l2\"\nagrees = { tolerance = 1e-6 }\n", "the CPU alone computes"}),
    [](const auto& refused) { return refused.param.name; });

TEST(CheckAgreement, IsOfWhatBothBackendsCompute) {
    const std::string water =
        "[caustics.beams]\nvolume_cells = [8, 8, 8]\n[camera]\nposition_m = [1, 2, -1]\ntarget_m = [4, 3, -1]\n"
        "[[probe]]\nname = \"deep\"\nat_m = [2, 2]\ndepth_m = 1.0\n";
    const auto outcome = [&](const char* quantity) {
        return rejection(run + water + "[[check]]\nquantity = \"" + quantity + "\"\nagrees = { tolerance = 1e-6 }\n");
    };
    for (const char* quantity :
         {"volume.max_cv", "volume.plane_irradiance.relative_l2", "volume.plane_irradiance.max", "camera.mean_radiance",
          "camera.radiance.max", "camera.radiance.relative_l2", "probe.g.irradiance", "probe.g.irradiance_cv"})
        EXPECT_EQ(outcome(quantity), "accepted") << quantity;
    for (const char* quantity : {"probe.deep.irradiance", "probe.deep.scalar_irradiance", "beams.ledger.floor"})
        EXPECT_NE(outcome(quantity).find("which the CPU alone computes"), std::string::npos) << quantity;
}

TEST(CheckTimes, WhatIsAllowedIsAccepted) {
    for (const char* check :
         {"quantity = \"floor.cv\"\nbelow = 1.0\nat_s = 4.0\n", "quantity = \"floor.cv\"\nbelow = 1.0\nat_s = 0.0\n",
          "quantity = \"floor.cv\"\nbelow = 1.0\nwindow_s = [0.0, 4.0]\nover = \"rms\"\n",
          "quantity = \"probe.g.peak_period\"\nbelow = 1.0\nwindow_s = [1.0, 3.0]\n",
          "quantity = \"floor.cv\"\norder = { key = \"domain.cells\", values = [[8, 8], [16, 8]], at_least = 1.0 }\n",
          "quantity = \"floor.irradiance.relative_linf\"\nagrees = { tolerance = 1e-6 }\n"})
        EXPECT_EQ(rejection(run + "[[check]]\n" + check), "accepted");
}

}  // namespace
}  // namespace waterlight::test
