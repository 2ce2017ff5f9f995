#include "app/report.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <nlohmann/json.hpp>

#include "app/hash.hpp"
#include "app/version.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

using Json = nlohmann::ordered_json;

Json ledger_json(const FloorLedger& l, double per) {
    return {{"incident_w", l.incident_w * per},   {"entered_w", l.entered_w * per},
            {"reflected_w", l.reflected_w * per}, {"extinguished_w", l.extinguished_w * per},
            {"floor_w", l.floor_w * per},         {"outside_w", l.outside_w * per},
            {"lost_w", l.lost_w * per},           {"closure", l.closure()}};
}

Json floor_json(const FloorRecord& floor, FloorMethod method) {
    Json json{{"method", method == FloorMethod::truth ? "truth" : "two-pass"},
              {"mean_irradiance_w_m2", floor.last.mean},
              {"min_irradiance_w_m2", floor.last.min},
              {"max_irradiance_w_m2", floor.last.max},
              {"cv", floor.last.cv}};
    if (method == FloorMethod::truth)
        json["error_estimate"] = floor.truth_error;
    else
        json["window"] = {{"samples", floor.window.samples}, {"channels", floor.window.channels}};
    return json;
}

/// What is extinguished is absorbed or scattered, in the proportion of the two coefficients.
Json ledger_json(const BeamLedger& l, const WaterOptics& optics, double per) {
    const double extinction = optics.extinction_per_m();
    const double scattered = extinction > 0 ? l.extinguished_w * optics.scattering_per_m / extinction : 0;
    return {{"incident_w", l.incident_w * per},
            {"reflected_w", l.reflected_w * per},
            {"absorbed_w", (l.extinguished_w - scattered) * per},
            {"scattered_w", scattered * per},
            {"floor_w", l.floor_w * per},
            {"outside_w", l.outside_w * per},
            {"discarded_w", l.discarded_w * per},
            {"closure", l.closure()}};
}

Json slices_json(const std::vector<SliceStatistics>& slices) {
    Json json = Json::array();
    for (const SliceStatistics& s : slices)
        json.push_back({{"depth_m", s.depth_m},
                        {"mean_irradiance_w_m2", s.mean},
                        {"cv", s.cv},
                        {"skewness", s.skewness},
                        {"flash_fraction", s.flash_fraction}});
    return json;
}

Json beams_json(const BeamRecord& record, const Scenario& scenario, int frames) {
    Json json{{"backend", "cpu"},
              {"grid", {scenario.beams->grid.x, scenario.beams->grid.y}},
              {"ledger",
               {{"mean_over_frames", ledger_json(record.sum, scenario.optics, 1.0 / frames)},
                {"last_frame", ledger_json(record.last_ledger, scenario.optics, 1)}}}};
    if (scenario.beams->volume_cells)
        json["volume"] = {{"flux_error", record.flux_error},
                          {"brightest_depth_m", record.brightest_depth_m},
                          {"slices", slices_json(record.slices)}};
    if (scenario.camera)
        json["camera"] = {{"mean_radiance_w_m2_sr", record.mean_radiance},
                          {"max_radiance_w_m2_sr", record.max_radiance},
                          {"beams", record.counts.beams},
                          {"covered_pixels", record.counts.covered_pixels},
                          {"sections", record.counts.sections}};
    return json;
}

Json totals_json(const ShallowTotals& totals) {
    return {{"volume_m3", totals.volume_m3},
            {"momentum_x_kg_m_s", totals.momentum_x_kg_m_s},
            {"momentum_y_kg_m_s", totals.momentum_y_kg_m_s},
            {"potential_j", totals.potential_j},
            {"kinetic_j", totals.kinetic_j},
            {"wet_m2", totals.inundated_m2}};
}

Json shallow_json(const ShallowRecord& record) {
    Json json{{"start", totals_json(record.first)},
              {"end", totals_json(record.last)},
              {"volume_drift", record.volume_drift},
              {"min_depth_m", record.min_depth_m},
              {"inundated_m2", record.inundated_m2}};
    if (record.highest)
        json["highest_runup"] = {{"ground_m", record.highest->ground_m},
                                 {"at_m", {record.highest->at_m.x, record.highest->at_m.y}}};
    return json;
}

Json wall_json(const StageTimes& wall) {
    return {{"waves", wall.waves},
            {"caustics.floor", wall.floor},
            {"caustics.beams", wall.beams},
            {"accuracy", wall.accuracy},
            {"render", 0.0},
            {"export", wall.export_busy},
            {"export_waited", wall.export_blocked},
            {"diagnostics", wall.diagnostics},
            {"total", wall.total}};
}

Json checks_json(const std::vector<CheckResult>& checks) {
    Json json = Json::array();
    for (const CheckResult& check : checks)
        json.push_back({{"name", check.name},
                        {"value", check.value},
                        {"expected", check.expected},
                        {"tolerance", check.tolerance},
                        {"pass", check.pass}});
    return json;
}

}  // namespace

std::string hash_of(const Origin& origin) {
    Hash hash;
    hash.add(origin.text);
    for (const std::string& override : origin.overrides) {
        hash.add("\n");
        hash.add(override);
    }
    return fmt::format("fnv1a64:{:016x}", hash.value());
}

nlohmann::ordered_json report_json(const Scenario& scenario, const BackendDecision& backend, const RunRecord& record,
                                   const std::vector<CheckResult>& checks) {
    const std::vector<std::string> reasons = resolve_model(scenario).reasons;
    Json json;
    json["version"] = version;
    json["scenario"] = {{"file", scenario.origin.file.string()},
                        {"title", scenario.title},
                        {"text", scenario.origin.text},
                        {"overrides", scenario.origin.overrides},
                        {"hash", hash_of(scenario.origin)}};
    json["device"] = {{"name", backend.device}, {"threads", omp_get_max_threads()}};
    json["backend"] = {{"name", backend.backend == Backend::vulkan ? "vulkan" : "cpu"}, {"reason", backend.reason}};
    json["model"] = {{"name", record.waves.model}, {"reasons", reasons}};
    json["frames"] = record.frames;
    json["steps"] = record.waves.steps;
    json["simulated_s"] = record.simulated_s;
    json["wall_s"] = wall_json(record.wall);
    if (record.sea)
        json["sea"] = {{"source", record.sea->description},
                       {"variance_m2", record.sea->coverage.variance_m2},
                       {"longer_than_domain_fraction", record.sea->coverage.longer_fraction},
                       {"shorter_than_two_cells_fraction", record.sea->coverage.shorter_fraction},
                       {"significant_height_carried_m", record.sea->significant_height_m()}};
    if (record.floor) {
        json["ledger"] = {{"mean_over_frames", ledger_json(record.floor->sum, 1.0 / record.frames)},
                          {"last_frame", ledger_json(record.floor->last_ledger, 1)}};
        json["floor"] = floor_json(*record.floor, scenario.floor->method);
    }
    if (record.accuracy)
        json["accuracy"] = {{"floor", {{"estimated_rmse", record.accuracy->floor_rmse}}},
                            {"waves", {{"estimated_rmse", record.accuracy->waves_rmse}}}};
    if (record.beams) json["beams"] = beams_json(*record.beams, scenario, record.frames);
    if (record.shallow) json["shallow_water"] = shallow_json(*record.shallow);
    json["mass_drift_m"] = record.waves.mass_drift_m;
    json["energy_drift"] = record.waves.energy_drift;
    json["quantities"] = quantities_of(record);
    json["checks"] = checks_json(checks);
    return json;
}

}  // namespace waterlight
