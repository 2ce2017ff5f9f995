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

Json ledger_json(const LightLedger& l) {
    return {{"incident_w", l.incident_w}, {"entered_w", l.entered_w},     {"reflected_w", l.reflected_w},
            {"absorbed_w", l.absorbed_w}, {"scattered_w", l.scattered_w}, {"floor_w", l.floor_w},
            {"walls_w", l.walls_w},       {"outside_w", l.outside_w},     {"objects_w", l.objects_w},
            {"lost_w", l.lost_w},         {"closure", l.closure()}};
}

/// Of all frames together, the last, and the largest part that a frame leaves unaccounted for; each frame's is a row of
/// ledger.csv.
Json ledgers_json(const LightLedger& sum, const LightLedger& last, double worst_closure, int frames) {
    return {{"mean_over_frames", ledger_json(sum.scaled(1.0 / frames))},
            {"last_frame", ledger_json(last)},
            {"worst_closure", worst_closure}};
}

/// What the method has to say of its last map.
Json method_json(const FloorRecord& floor, const PhotonOptions& options) {
    const MethodRecord& m = floor.method;
    switch (m.method) {
        case FloorMethod::two_pass:
            return {{"window", {{"samples", floor.window.samples}, {"channels", floor.window.channels}}}};
        case FloorMethod::truth:
            return {{"error_estimate", m.error_estimate}};
        case FloorMethod::photons:
            return {{"photons", m.photons},
                    {"passes", m.passes},
                    {"passes_at_most", options.passes},
                    {"bounces", options.bounces},
                    {"error_estimate", m.error_estimate}};
        case FloorMethod::splat:
            return {{"vertices", m.splat.vertices},
                    {"not_converged", m.splat.not_converged},
                    {"missed", m.splat.missed},
                    {"last_step_m", m.splat.last_step_m}};
        case FloorMethod::quads:
            break;
    }
    return Json::object();
}

Json floor_json(const FloorRecord& floor, const FloorSection& section) {
    Json json{{"method", name_of(section.method)},
              {"mean_irradiance_w_m2", floor.last.mean},
              {"min_irradiance_w_m2", floor.last.min},
              {"max_irradiance_w_m2", floor.last.max},
              {"cv", floor.last.cv}};
    json["receiver"] = section.on.receiver == Receiver::ground ? "ground" : "flat";
    json.update(method_json(floor, section.photons));
    return json;
}

Json lamp_json(const Lamp& lamp) {
    return {{"type", lamp.type == Lamp::Type::spot ? "spot" : "point"}, {"power_w", lamp.power_w()}};
}

Json objects_json(const std::vector<Object>& objects) {
    Json json = Json::array();
    for (const Object& o : objects) {
        json.push_back({{"name", o.name},
                        {"type", shape_names[o.shape.index()]},
                        {"material", material_names[static_cast<std::size_t>(o.material.type)]}});
        if (const auto* mesh = std::get_if<Mesh>(&o.shape)) json.back()["triangles"] = mesh->triangles.size();
    }
    return json;
}

/// Of the light above the water: the same words, with the surface and the height where it ends for the floor.
Json reflected_json(const BeamLedger& l, double per) {
    return {{"incident_w", l.incident_w * per},
            {"transmitted_w", l.reflected_w * per},
            {"extinguished_w", l.extinguished_w * per},
            {"through_height_w", l.floor_w * per},
            {"outside_w", l.outside_w * per},
            {"discarded_w", l.discarded_w * per},
            {"dry_w", l.dry_w * per},
            {"objects_w", l.objects_w * per},
            {"closure", l.closure()}};
}

Json slices_json(const std::vector<SliceStatistics>& slices) {
    Json json = Json::array();
    for (const SliceStatistics& s : slices)
        json.push_back({{"depth_m", s.depth_m},
                        {"mean_irradiance_w_m2", s.mean},
                        {"cv", s.cv},
                        {"skewness", s.skewness},
                        {"flash_fraction", s.flash_fraction},
                        {"flash_rate_hz", s.flash_rate_hz},
                        {"water_fraction", s.water_fraction}});
    return json;
}

Json beams_json(const BeamRecord& record, const Scenario& scenario, int frames) {
    Json json{{"backend", record.backend},
              {"grid", {scenario.beams->grid.x, scenario.beams->grid.y}},
              {"ledger", ledgers_json(record.sum, record.last_ledger, record.closure, frames)}};
    if (scenario.beams->reflected)
        json["reflected"] = {{"height_m", scenario.beams->reflected->height_m},
                             {"ledger",
                              {{"mean_over_frames", reflected_json(record.sum_reflected, 1.0 / frames)},
                               {"last_frame", reflected_json(record.last_reflected, 1)}}}};
    if (scenario.beams->volume_cells)
        json["volume"] = {{"flux_error", record.flux_error},
                          {"brightest_depth_m", record.brightest_depth_m},
                          {"sampled_every_s", record.sampled_every_s},
                          {"slices", slices_json(record.slices)}};
    if (sees_scattered_light(scenario))
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

/// The light at each probe that reads any.
Json probes_json(const std::map<std::string, ProbeRecord>& probes) {
    Json json = Json::object();
    for (const auto& [name, probe] : probes) {
        if (probe.series.time_s.empty()) continue;
        const Flicker flicker = flicker_of(probe.series);
        json[name] = {{"mean_irradiance_w_m2", flicker.mean},
                      {"cv", flicker.cv},
                      {"skewness", flicker.skewness},
                      {"flash_rate_hz", flicker.flash_rate_hz},
                      {"longest_flash_s", flicker.longest_flash_s},
                      {"sampled_every_s", flicker.sampled_every_s}};
    }
    return json;
}

Json wall_json(const StageTimes& wall) {
    return {{"waves", wall.waves},
            {"caustics.floor", wall.floor},
            {"caustics.beams", wall.beams},
            {"caustics.walls", wall.walls},
            {"accuracy", wall.accuracy},
            {"render", wall.render},
            {"movie", wall.movie},
            {"export", wall.export_busy},
            {"export_waited", wall.export_blocked},
            {"diagnostics", wall.diagnostics},
            {"total", wall.total}};
}

Json checks_json(const std::vector<CheckResult>& checks) {
    Json json = Json::array();
    for (const CheckResult& check : checks)
        json.push_back({{"check", check.check},
                        {"name", check.name},
                        {"value", check.value},
                        {"expected", check.expected},
                        {"tolerance", check.tolerance},
                        {"pass", check.is_left ? Json() : Json(check.pass)}});
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
    const ModelDecision decision = resolve_model(scenario);
    Json json;
    json["version"] = version;
    json["scenario"] = {{"file", scenario.origin.file.string()},
                        {"title", scenario.title},
                        {"text", scenario.origin.text},
                        {"overrides", scenario.origin.overrides},
                        {"hash", hash_of(scenario.origin)}};
    json["device"] = {{"name", backend.device}, {"threads", omp_get_max_threads()}};
    json["backend"] = {{"name", backend.backend == Backend::vulkan ? "vulkan" : "cpu"}, {"reason", backend.reason}};
    json["model"] = {{"name", record.waves.model}, {"reasons", decision.reasons}};
    if (!decision.warning.empty()) json["model"]["warning"] = decision.warning;
    if (scenario.object_set) json["objects"] = objects_json(scenario.object_set->objects());
    if (scenario.lamp) json["lamp"] = lamp_json(*scenario.lamp);
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
        const FloorRecord& floor = *record.floor;
        json["ledger"] = ledgers_json(floor.sum, floor.last_ledger, floor.closure, record.frames);
        json["floor"] = floor_json(floor, *scenario.floor);
    }
    if (record.accuracy)
        json["accuracy"] = {{"floor", {{"estimated_rmse", record.accuracy->floor_rmse}}},
                            {"waves", {{"estimated_rmse", record.accuracy->waves_rmse}}}};
    if (record.beams) json["beams"] = beams_json(*record.beams, scenario, record.frames);
    if (record.walls) {
        const WallRecord& walls = *record.walls;
        json["walls"] = {{"backend", "cpu"},
                         {"ledger", ledgers_json(walls.sum, walls.last_ledger, walls.closure, record.frames)}};
    }
    if (!record.picture_device.empty()) json["render"] = {{"device", record.picture_device}};
    if (record.shallow) json["shallow_water"] = shallow_json(*record.shallow);
    if (const Json light = probes_json(record.probes); !light.empty()) json["light_at_probes"] = light;
    json["mass_drift_m"] = record.waves.mass_drift_m;
    json["energy_drift"] = record.waves.energy_drift;
    json["quantities"] = quantities_of(record);
    json["checks"] = checks_json(checks);
    return json;
}

}  // namespace waterlight
