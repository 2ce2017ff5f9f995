// The numbers of a run by name.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/readings.hpp"
#include "app/report.hpp"

namespace waterlight {

namespace {

void add_ledger(std::string_view of, const LightLedger& l, std::map<std::string, double>& q) {
    const auto add = [&](std::string_view row, double watts) { q[fmt::format("{}.ledger.{}", of, row)] = watts; };
    add("incident", l.incident_w);
    add("entered", l.entered_w);
    add("reflected", l.reflected_w);
    add("absorbed", l.absorbed_w);
    add("scattered", l.scattered_w);
    add("floor", l.floor_w);
    add("walls", l.walls_w);
    add("outside", l.outside_w);
    add("objects", l.objects_w);
    add("lost", l.lost_w);
}

void add_slices(const std::vector<SliceStatistics>& slices, std::map<std::string, double>& q) {
    if (slices.empty()) return;
    const auto most = [&](auto what) {
        return *std::max_element(slices.begin(), slices.end(),
                                 [what](const auto& a, const auto& b) { return a.*what < b.*what; });
    };
    q["volume.mean_irradiance"] = slices.back().mean;
    q["volume.max_cv"] = most(&SliceStatistics::cv).cv;
    q["volume.max_cv_depth"] = most(&SliceStatistics::cv).depth_m;
    q["volume.max_skewness"] = most(&SliceStatistics::skewness).skewness;
    q["volume.max_flash_fraction"] = most(&SliceStatistics::flash_fraction).flash_fraction;
    q["volume.max_flash_rate"] = most(&SliceStatistics::flash_rate_hz).flash_rate_hz;
}

void add_beams(const BeamRecord& beams, std::map<std::string, double>& q) {
    add_ledger("beams", beams.last_ledger, q);
    q["beams.ledger_closure"] = beams.closure;
    q["beams.discarded_fraction"] = beams.discarded_fraction;
    q["beams.reflected_fraction"] = beams.sum.incident_w > 0 ? beams.sum.reflected_w / beams.sum.incident_w : no_value;
    q["volume.flux_error"] = beams.flux_error;
    q["volume.brightest_depth"] = beams.brightest_depth_m;
    add_slices(beams.slices, q);
    q["camera.mean_radiance"] = beams.mean_radiance;
    q["camera.max_radiance"] = beams.max_radiance;
}

void add_method(const MethodRecord& method, std::map<std::string, double>& q) {
    const auto by = [&](FloorMethod wanted, double value) { return method.method == wanted ? value : no_value; };
    q["floor.truth_error"] = by(FloorMethod::truth, method.error_estimate);
    q["floor.photon_error"] = by(FloorMethod::photons, method.error_estimate);
    q["floor.splat_missed"] = by(FloorMethod::splat, method.missed_fraction());
    q["floor.splat_not_converged"] = by(FloorMethod::splat, method.not_converged_fraction());
}

void add_flicker(const std::string& prefix, const ProbeRecord& probe, std::map<std::string, double>& q) {
    const Flicker flicker = flicker_of(probe.series);
    q[prefix + "scalar_irradiance"] = probe.scalar_irradiance;
    q[prefix + "mean_irradiance"] = flicker.mean;
    q[prefix + "irradiance_cv"] = flicker.cv;
    q[prefix + "irradiance_skewness"] = flicker.skewness;
    q[prefix + "flash_rate"] = flicker.flash_rate_hz;
    q[prefix + "longest_flash"] = flicker.longest_flash_s;
}

void add_walls(const WallRecord& walls, std::map<std::string, double>& q) {
    add_ledger("walls", walls.last_ledger, q);
    q["walls.ledger_closure"] = walls.closure;
    for (std::size_t w = 0; w < wall_names.size(); ++w)
        q[fmt::format("walls.{}", wall_names[w])] = walls.last_power_w[w];
}

}  // namespace

double SeaRecord::significant_height_m() const {
    const double carried = 1 - coverage.longer_fraction - coverage.shorter_fraction;
    return 4 * std::sqrt(std::max(0.0, coverage.variance_m2 * carried));
}

std::map<std::string, double> quantities_of(const RunRecord& r) {
    std::map<std::string, double> q;
    q["simulated_s"] = r.simulated_s;
    q["waves.steps"] = static_cast<double>(r.waves.steps);
    q["waves.significant_height"] = 4 * std::sqrt(r.waves.last.variance_m2);
    q["waves.max_elevation"] = r.waves.last.max_abs_elevation_m;
    q["waves.slope_variance"] = r.waves.last.slope_variance;
    q["waves.mass_drift"] = r.waves.mass_drift_m;
    q["waves.energy_drift"] = r.waves.energy_drift;
    q["waves.volume"] = r.waves.still_m3 + r.waves.last.volume_m3;
    q["waves.energy"] = r.waves.last.energy_j;
    if (r.sea) {
        const double carried = r.sea->significant_height_m();
        q["sea.significant_height"] = carried;
        q["sea.longer_fraction"] = r.sea->coverage.longer_fraction;
        q["sea.shorter_fraction"] = r.sea->coverage.shorter_fraction;
        q["sea.height_error"] =
            carried > 0 ? std::abs(4 * std::sqrt(r.waves.first.variance_m2) / carried - 1) : no_value;
    }
    if (r.shallow) {
        const ShallowRecord& s = *r.shallow;
        q["waves.volume_drift"] = s.volume_drift;
        q["waves.momentum_x"] = s.last.momentum_x_kg_m_s;
        q["waves.momentum_y"] = s.last.momentum_y_kg_m_s;
        q["waves.inundated_area"] = s.inundated_m2;
        q["waves.max_runup"] = s.highest ? s.highest->ground_m : no_value;
        q["waves.min_depth"] = s.min_depth_m;
        q["waves.exact_l1"] = s.exact_l1;
    }
    if (r.floor) {
        q["floor.mean_irradiance"] = r.floor->last.mean;
        q["floor.min_irradiance"] = r.floor->last.min;
        q["floor.max_irradiance"] = r.floor->last.max;
        q["floor.cv"] = r.floor->last.cv;
        add_ledger("floor", r.floor->last_ledger, q);
        q["floor.lost_fraction"] = r.floor->lost_fraction;
        q["floor.ledger_closure"] = r.floor->closure;
        add_method(r.floor->method, q);
    }
    if (r.accuracy) {
        q["accuracy.floor.estimated_rmse"] = r.accuracy->floor_rmse;
        q["accuracy.waves.estimated_rmse"] = r.accuracy->waves_rmse;
    }
    if (r.beams) add_beams(*r.beams, q);
    if (r.walls) add_walls(*r.walls, q);
    for (const auto& [name, probe] : r.probes) {
        const std::string prefix = fmt::format("probe.{}.", name);
        q[prefix + "elevation"] = probe.elevation;
        q[prefix + "min_elevation"] = probe.min_elevation;
        q[prefix + "max_elevation"] = probe.max_elevation;
        q[prefix + "rms_elevation"] =
            probe.late_frames > 0 ? std::sqrt(probe.late_squares / probe.late_frames) : no_value;
        if (r.shallow) q[prefix + "arrival_time"] = probe.arrival_s;
        q[prefix + "irradiance"] = probe.irradiance;
        q[prefix + "max_irradiance"] = probe.max_irradiance;
        if (!probe.series.time_s.empty()) add_flicker(prefix, probe, q);
    }
    return q;
}

}  // namespace waterlight
