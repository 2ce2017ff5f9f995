#include "app/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/readings.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Time after which a source adds no energy.
struct Silence {
    double operator()(const Drop& drop) const { return drop.time_s; }
    double operator()(const Rain& rain) const { return rain.end_s; }
    double operator()(const Wavemaker&) const { return infinity; }
};

double silent_from(const Scenario& scenario) {
    if (!is_closed(scenario) || scenario.waves.manning.value_or(0) > 0) return infinity;
    double from = -infinity;
    for (const Source& source : scenario.waves.sources) from = std::max(from, std::visit(Silence{}, source));
    return from;
}

void add(FloorLedger& sum, const FloorLedger& l) {
    sum.incident_w += l.incident_w;
    sum.reflected_w += l.reflected_w;
    sum.extinguished_w += l.extinguished_w;
    sum.floor_w += l.floor_w;
    sum.outside_w += l.outside_w;
    sum.lost_w += l.lost_w;
    sum.entered_w += l.entered_w;
}

}  // namespace

Recorder::Recorder(const Scenario& scenario)
    : scenario_(scenario), conserved_from_s_(silent_from(scenario)), conserved_j_(none) {
    record_.waves.energy_drift = none;
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

void Recorder::add_floor(const FloorMap& map, double error_estimate) {
    if (!record_.floor) record_.floor.emplace();
    FloorRecord& floor = *record_.floor;
    floor.window = map.window;
    floor.last_ledger = map.ledger;
    add(floor.sum, map.ledger);
    const double light = map.ledger.incident_w + map.ledger.entered_w;
    floor.lost_fraction = std::max(floor.lost_fraction, light > 0 ? map.ledger.lost_w / light : 0);
    floor.closure = std::max(floor.closure, map.ledger.closure());
    floor.truth_error = error_estimate;
}

void Recorder::add_statistics(const FloorMap& map) { record_.floor->last = statistics_of(map.irradiance); }

std::vector<double> Recorder::add_probes(const Surface& surface,
                                         const std::function<double(const Probe&)>& irradiance) {
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
        const double light = irradiance ? irradiance(probe) : none;
        if (scenario_.floor || probe.depth_m) columns.push_back(light);
        if (!irradiance && !is_first) continue;
        p.irradiance = light;
        p.max_irradiance = is_first ? light : std::max(p.max_irradiance, light);
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
    for (const Probe& probe : scenario_.probes) state.value(record_.probes[probe.name]);
}

}  // namespace waterlight
