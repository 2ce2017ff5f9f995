// A scenario's floor map by each method: one light, one ledger, and what each says of itself.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/explain.hpp"
#include "app/floor_stage.hpp"
#include "app/report.hpp"
#include "caustics/truth.hpp"
#include "scenarios/choose.hpp"
#include "scenarios/resolve.hpp"
#include "sim/error.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

/// A frozen sine under a slanting sun, before its focus.
const std::string pool =
    "[domain]\nsize_m = [0.5, 0.5]\ncells = [64, 64]\ndepth_m = 0.8\n[waves]\nmodel = \"prescribed\"\n"
    "[[waves.sine]]\namplitude_m = 0.004\nwavelength_m = 0.25\nfrozen = true\n[light]\nelevation_deg = 60.0\n";
const std::string still_air =
    "[domain]\nsize_m = [1.0, 1.0]\ncells = [8, 8]\ndepth_m = 1.0\n[water]\nrefractive_index = 1.0\n[waves]\nmodel = "
    "\"prescribed\"\nboundary = { x = \"absorbing\", y = \"absorbing\" }\n";
const std::string spot =
    "[light]\ntype = \"spot\"\nat_m = [0.5, 0.5, 1.0]\ntowards_m = [0.5, 0.5, 0]\nhalf_angle_deg = 10.0\n"
    "intensity_w_sr = 100.0\n";

std::string floor_by(const std::string& method, const std::string& more = "") {
    return "[caustics.floor]\npixels = [64, 64]\nmethod = \"" + method + "\"\n" + more;
}

/// The map of a scenario at its start, on the CPU.
struct Lit {
    explicit Lit(const std::string& text) : scenario(parse(text)) {
        read_data(scenario);
        model = build_model(scenario);
        stage = make_floor_stage(scenario, model, choose_backend(DeviceWish{Backend::cpu, "", false}, scenario));
        stage->compute(model.model->surface(), map);
        ledger = stage->ledger(map);
        record = stage->record(map);
    }

    Scenario scenario;
    BuiltModel model;
    std::unique_ptr<FloorStage> stage;
    FloorMap map;
    LightLedger ledger;
    MethodRecord record;
};

Field<double> in_double(const Field<float>& map) {
    Field<double> values(map.nx(), map.ny());
    std::copy_n(map.data(), map.size(), values.data());
    return values;
}

const char* many_photons = "photons = { map = 512, passes = 8 }\n";

TEST(FloorMethods, AllShowTheTruthOfWavesWithinTheirErrors) {
    const Lit truth(pool + floor_by("truth", "tolerance = 1e-3\n"));
    const Field<double> reference = in_double(truth.map.irradiance);
    const auto expect = [&](const std::string& floor, double most_rmse, double most_energy) {
        SCOPED_TRACE(floor);
        const Lit lit(pool + floor);
        EXPECT_LT(relative_rmse(lit.map.irradiance, reference), most_rmse);
        EXPECT_NEAR(lit.ledger.floor_w / truth.ledger.floor_w, 1, most_energy);
        EXPECT_LT(lit.ledger.closure(), 1e-4);
        EXPECT_EQ(lit.record.method, lit.scenario.floor->method);
    };
    expect(floor_by("two-pass"), 0.01, 1e-3);
    expect(floor_by("quads"), 0.01, 1e-3);
    expect(floor_by("splat", "splat = { grid = 256 }\n"), 0.03, 1e-3);
    expect(floor_by("photons", many_photons), 0.04, 1e-2);
}

TEST(FloorMethods, PhotonsSayHowWrongTheyAre) {
    const Lit truth(pool + floor_by("truth", "tolerance = 1e-3\n"));
    const Lit lit(pool + floor_by("photons", many_photons));
    EXPECT_EQ(lit.record.passes, 8);
    EXPECT_EQ(lit.record.photons, 8 * 512 * 512);
    const double rmse = relative_rmse(lit.map.irradiance, in_double(truth.map.irradiance));
    EXPECT_NEAR(lit.record.error_estimate / rmse, 1, 0.25);
    const Lit stopped(pool + floor_by("photons", "photons = { map = 512, passes = 64, tolerance = 0.05 }\n"));
    EXPECT_LT(stopped.record.passes, 64);
    EXPECT_LE(stopped.record.error_estimate, 0.05);
}

TEST(FloorMethods, SplatsSayWhatBecameOfTheirVertices) {
    const Lit lit(pool + floor_by("splat", "splat = { grid = 128 }\n"));
    EXPECT_GE(lit.record.splat.vertices, 128 * 128);
    EXPECT_EQ(lit.record.missed_fraction(), 0);
    EXPECT_EQ(lit.record.not_converged_fraction(), 0);
    EXPECT_TRUE(std::isnan(lit.record.error_estimate));
    const Lit one_step(pool +
                       "[caustics.floor]\npixels = [512, 512]\nmethod = \"splat\"\nsplat = { grid = 128, "
                       "iterations = 1, landing = \"distance\" }\n");
    EXPECT_GT(one_step.record.splat.not_converged, 0);
}

TEST(FloorMethods, ColoursOfALampShareItsPower) {
    const double power = 100 * 2 * std::numbers::pi * (1 - std::cos(10 * std::numbers::pi / 180));
    for (const std::string method : {"splat", "photons"}) {
        SCOPED_TRACE(method);
        const Lit one(still_air + spot + floor_by(method));
        EXPECT_NEAR(one.ledger.incident_w / power, 1, 0.01);
        EXPECT_NEAR(one.ledger.floor_w / power, 1, 0.01);
        std::string coloured =
            still_air + spot + "wavelengths_nm = [600, 500]\nshares = [0.25, 0.5]\n" + floor_by(method);
        coloured.replace(coloured.find("[water]\nrefractive_index = 1.0\n"), 31, "[water]\nfresnel = false\n");
        const Lit two(coloured);
        EXPECT_NEAR(two.ledger.incident_w / power, 0.75, 0.01);
        ASSERT_EQ(two.stage->bands().size(), 2U);
    }
}

TEST(FloorMethods, ObjectsCastTheirShadowInAllThatKnowThem) {
    const std::string ball =
        "[[object]]\ntype = \"sphere\"\nname = \"ball\"\nradius_m = 0.2\ncentre_m = [0.5, 0.5, -0.4]\n";
    const std::string sun = "[light]\nelevation_deg = 90.0\n";
    for (const std::string method : {"two-pass", "quads", "splat", "photons"}) {
        SCOPED_TRACE(method);
        const Lit lit(still_air + sun + ball + floor_by(method));
        EXPECT_NEAR(lit.ledger.objects_w / (1000 * std::numbers::pi * 0.04), 1, 0.01);
        EXPECT_LT(lit.map.irradiance(32, 32), 1e-3);
        EXPECT_LT(lit.ledger.closure(), 1e-4);
    }
}

TEST(FloorMethods, OnlyTwoPassAndSplatGoToADevice) {
    const auto reason = [](const std::string& method) {
        const Scenario s = parse(pool + floor_by(method));
        return choose_backend(DeviceWish{Backend::automatic, "", false}, s).reason;
    };
    EXPECT_EQ(reason("truth"), "the truth is computed in double precision on the CPU");
    EXPECT_EQ(reason("quads"), "method quads is computed on the CPU");
    EXPECT_EQ(reason("photons"), "method photons is computed on the CPU");
    const Scenario quads = parse(pool + floor_by("quads"));
    EXPECT_THROW(choose_backend(DeviceWish{Backend::vulkan, "", false}, quads), InputError);
}

TEST(FloorMethods, TheReportHasMethodAndObjects) {
    const Lit lit(still_air + floor_by("photons", "photons = { map = 64, passes = 2, bounces = 5 }\n") +
                  "[[object]]\ntype = \"ring\"\nname = \"ring\"\ncentre_m = [0.5, 0.5, -0.5]\nmaterial = { type = "
                  "\"mirror\" }\n");
    RunRecord run;
    run.frames = 1;
    run.floor.emplace();
    run.floor->method = lit.record;
    const auto json = report_json(lit.scenario, choose_backend({}, lit.scenario), run, {});
    EXPECT_EQ(json["floor"]["method"], "photons");
    EXPECT_EQ(json["floor"]["passes"], 2);
    EXPECT_EQ(json["floor"]["photons"], 2 * 64 * 64);
    EXPECT_EQ(json["floor"]["bounces"], 5);
    EXPECT_GT(json["floor"]["error_estimate"].get<double>(), 0);
    EXPECT_EQ(json["objects"][0]["name"], "ring");
    EXPECT_EQ(json["objects"][0]["material"], "mirror");
    EXPECT_EQ(json["quantities"]["floor.photon_error"], json["floor"]["error_estimate"]);
    EXPECT_TRUE(std::isnan(json["quantities"]["floor.splat_missed"].get<double>()));
}

TEST(FloorMethods, ExplainSaysWhatEachFollows) {
    const auto explained = [](const std::string& text) {
        const Scenario s = parse(text);
        return explanation(s, choose(s));
    };
    EXPECT_EQ(explained(pool + floor_by("two-pass")).find("follows"), std::string::npos);
    const std::string photons = explained(pool + floor_by("photons", "photons = { map = 100, passes = 3 }\n"));
    EXPECT_NE(photons.find("30000 photons in 3 passes at most"), std::string::npos) << photons;
    EXPECT_NE(photons.find("WARNING    the floor map is noisy"), std::string::npos) << photons;
    const std::string splat = explained(
        pool + floor_by("splat") +
        "[[object]]\ntype = \"cup\"\nname = \"mug\"\ncentre_m = [0, 0, 0]\nmaterial = { type = \"glass\" }\n");
    EXPECT_NE(splat.find("objects    mug (glass cup)"), std::string::npos) << splat;
    EXPECT_NE(splat.find("up to 8 interfaces"), std::string::npos) << splat;
}

}  // namespace
}  // namespace waterlight::test
