// The numbers of a run by name, and the judgement of checks about them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/report.hpp"

namespace waterlight {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

CheckResult bound(const Check& check, double value, const char* sign, double limit, bool pass) {
    return {check.quantity, value, fmt::format("{} {}", sign, limit), limit, 0, pass};
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
}

void add_beams(const BeamRecord& beams, std::map<std::string, double>& q) {
    q["beams.ledger_closure"] = beams.closure;
    q["beams.discarded_fraction"] = beams.discarded_fraction;
    q["volume.flux_error"] = beams.flux_error;
    q["volume.brightest_depth"] = beams.brightest_depth_m;
    add_slices(beams.slices, q);
    q["camera.mean_radiance"] = beams.mean_radiance;
    q["camera.max_radiance"] = beams.max_radiance;
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
    if (r.sea) {
        const double carried = r.sea->significant_height_m();
        q["sea.significant_height"] = carried;
        q["sea.longer_fraction"] = r.sea->coverage.longer_fraction;
        q["sea.shorter_fraction"] = r.sea->coverage.shorter_fraction;
        q["sea.height_error"] = carried > 0 ? std::abs(4 * std::sqrt(r.waves.first.variance_m2) / carried - 1) : none;
    }
    if (r.shallow) {
        const ShallowRecord& s = *r.shallow;
        q["waves.volume_drift"] = s.volume_drift;
        q["waves.momentum_x"] = s.last.momentum_x_kg_m_s;
        q["waves.momentum_y"] = s.last.momentum_y_kg_m_s;
        q["waves.energy"] = s.last.potential_j + s.last.kinetic_j;
        q["waves.inundated_area"] = s.inundated_m2;
        q["waves.max_runup"] = s.highest ? s.highest->ground_m : none;
        q["waves.min_depth"] = s.min_depth_m;
        q["waves.exact_l1"] = s.exact_l1;
    }
    if (r.floor) {
        q["floor.mean_irradiance"] = r.floor->last.mean;
        q["floor.min_irradiance"] = r.floor->last.min;
        q["floor.max_irradiance"] = r.floor->last.max;
        q["floor.cv"] = r.floor->last.cv;
        q["floor.lost_fraction"] = r.floor->lost_fraction;
        q["floor.ledger_closure"] = r.floor->closure;
        q["floor.truth_error"] = r.floor->truth_error;
    }
    if (r.accuracy) {
        q["accuracy.floor.estimated_rmse"] = r.accuracy->floor_rmse;
        q["accuracy.waves.estimated_rmse"] = r.accuracy->waves_rmse;
    }
    if (r.beams) add_beams(*r.beams, q);
    for (const auto& [name, probe] : r.probes) {
        const std::string prefix = fmt::format("probe.{}.", name);
        q[prefix + "elevation"] = probe.elevation;
        q[prefix + "min_elevation"] = probe.min_elevation;
        q[prefix + "max_elevation"] = probe.max_elevation;
        q[prefix + "rms_elevation"] = probe.late_frames > 0 ? std::sqrt(probe.late_squares / probe.late_frames) : none;
        if (r.shallow) q[prefix + "arrival_time"] = probe.arrival_s;
        q[prefix + "irradiance"] = probe.irradiance;
        q[prefix + "max_irradiance"] = probe.max_irradiance;
    }
    return q;
}

std::vector<CheckResult> judge(const std::vector<Check>& checks, const std::map<std::string, double>& quantities) {
    std::vector<CheckResult> results;
    for (const Check& check : checks) {
        const auto found = quantities.find(check.quantity);
        const double value = found == quantities.end() ? none : found->second;
        if (check.equals) {
            const double tolerance = std::max(check.tolerance, check.relative_tolerance * std::abs(*check.equals));
            results.push_back({check.quantity, value, fmt::format("= {}", *check.equals), *check.equals, tolerance,
                               std::abs(value - *check.equals) <= tolerance});
        }
        if (check.below) results.push_back(bound(check, value, "<", *check.below, value < *check.below));
        if (check.above) results.push_back(bound(check, value, ">", *check.above, value > *check.above));
    }
    return results;
}

}  // namespace waterlight
