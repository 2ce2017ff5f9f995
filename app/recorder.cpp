#include "app/recorder.hpp"

#include <algorithm>
#include <cmath>

#include "app/readings.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

/// All of them by name, so that one that is added cannot be forgotten here.
void exchange(StateArchive& state, ProbeRecord& probe) {
    auto& [elevation, least, most, squares, frames, irradiance, most_irradiance, scalar, series, arrival] = probe;
    for (double* value : {&elevation, &least, &most, &squares, &irradiance, &most_irradiance, &scalar, &arrival})
        state.value(*value);
    state.value(frames);
    state.list(series.time_s);
    state.list(series.irradiance_w_m2);
}

}  // namespace

Recorder::Recorder(const Scenario& scenario)
    : scenario_(scenario), conserved_from_s_(conserves_energy_from_s(scenario)), conserved_j_(no_value) {
    record_.waves.energy_drift = no_value;
    record_.waves.still_m3 = still_volume_m3(scenario);
}

void Recorder::add_frame(double time_s) {
    ++record_.frames;
    record_.simulated_s = time_s;
}

void Recorder::add_waves(double time_s, const WaveDiagnostics& now) {
    WaveRecord& waves = record_.waves;
    if (!watched_) waves.first = now;
    watched_ = true;
    waves.last = now;
    const glm::dvec2 size = scenario_.domain.size_m;
    const double level_m = (now.volume_m3 - waves.first.volume_m3) / (size.x * size.y);
    waves.mass_drift_m = std::max(waves.mass_drift_m, std::abs(level_m));
    if (time_s <= conserved_from_s_) return;
    if (std::isnan(conserved_j_)) {
        conserved_j_ = now.energy_j;
    } else if (conserved_j_ > 0) {
        const double drift = std::abs(now.energy_j / conserved_j_ - 1);
        waves.energy_drift = std::isnan(waves.energy_drift) ? drift : std::max(waves.energy_drift, drift);
    }
}

void Recorder::add_floor(const FloorMap& map, const LightLedger& ledger, const MethodRecord& method) {
    if (!record_.floor) record_.floor.emplace();
    FloorRecord& floor = *record_.floor;
    floor.window = map.window;
    floor.last_ledger = ledger;
    floor.sum += ledger;
    const double light = ledger.incident_w + ledger.entered_w;
    floor.lost_fraction = std::max(floor.lost_fraction, light > 0 ? ledger.lost_w / light : 0);
    floor.closure = std::max(floor.closure, ledger.closure());
    floor.method = method;
}

void Recorder::add_statistics(const FloorMap& map) { record_.floor->last = statistics_of(map.irradiance); }

std::vector<double> Recorder::add_probes(const Surface& surface, const std::function<ProbeLight(const Probe&)>& light) {
    std::vector<double> columns;
    for (const Probe& probe : scenario_.probes) {
        const auto [entry, is_first] = record_.probes.try_emplace(probe.name);
        ProbeRecord& p = entry->second;
        p.elevation = elevation_at(surface, probe.at_m);
        p.min_elevation = is_first ? p.elevation : std::min(p.min_elevation, p.elevation);
        p.max_elevation = is_first ? p.elevation : std::max(p.max_elevation, p.elevation);
        if (surface.time_s > 0.5 * scenario_.waves.duration_s) {
            p.late_squares += p.elevation * p.elevation;
            ++p.late_frames;
        }
        columns.push_back(p.elevation);
        const ProbeLight now = light(probe);
        p.irradiance = now.plane_w_m2;
        p.max_irradiance = is_first ? now.plane_w_m2 : std::max(p.max_irradiance, now.plane_w_m2);
        p.scalar_irradiance = now.scalar_w_m2;
        if (!scenario_.floor && !probe.depth_m) continue;
        columns.push_back(now.plane_w_m2);
        p.series.time_s.push_back(surface.time_s);
        p.series.irradiance_w_m2.push_back(now.plane_w_m2);
        if (probe.depth_m) columns.push_back(now.scalar_w_m2);
    }
    return columns;
}

void Recorder::exchange_state(StateArchive& state) {
    state.value(conserved_j_);
    state.value(watched_);
    state.value(record_.frames);
    state.value(record_.simulated_s);
    state.value(record_.wall);
    WaveRecord& waves = record_.waves;
    state.value(waves.first);
    state.value(waves.last);
    state.value(waves.mass_drift_m);
    state.value(waves.energy_drift);
    if (scenario_.floor) {
        if (!record_.floor) record_.floor.emplace();
        state.value(*record_.floor);
    }
    for (const Probe& probe : scenario_.probes) exchange(state, record_.probes[probe.name]);
}

}  // namespace waterlight
