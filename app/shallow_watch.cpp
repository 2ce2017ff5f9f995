#include "app/shallow_watch.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scenarios/build_shallow.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

/// Of the depth: sum of absolute differences over the sum of the exact.
double relative_l1(const Field<float>& depth, const Field<double>& exact) {
    double difference = 0, sum = 0;
    for (std::size_t n = 0; n < exact.size(); ++n) {
        difference += std::abs(depth.data()[n] - exact.data()[n]);
        sum += exact.data()[n];
    }
    return difference / sum;
}

}  // namespace

Field<float> bed_of(const ShallowWaterModel& model, const Grid& grid) {
    Field<float> bed(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) bed(i, j) = static_cast<float>(model.bed_m(i, j));
    return bed;
}

ShallowWatch::ShallowWatch(const Scenario& scenario, const ShallowWaterModel& model, const Surface& surface)
    : scenario_(scenario),
      model_(model),
      grid_(surface.grid),
      bed_m_(bed_of(model, surface.grid)),
      depth_at_start_m_(surface.depth->clone()) {
    assert(model.records() && surface.depth);
}

void ShallowWatch::add_frame(const Surface& surface) {
    const auto depths = surface.depth->values();
    record_.min_depth_m = std::min<double>(record_.min_depth_m, *std::min_element(depths.begin(), depths.end()));
}

void ShallowWatch::add_totals() {
    const ShallowTotals now = model_.totals();
    if (!watched_) record_.first = now;
    watched_ = true;
    record_.last = now;
    const double drift = std::abs(now.volume_m3 / record_.first.volume_m3 - 1);
    record_.volume_drift =
        is_closed(scenario_) ? std::max(record_.volume_drift, drift) : std::numeric_limits<double>::quiet_NaN();
}

void ShallowWatch::finish(const Surface& surface, RunRecord& run) {
    record_.inundated_m2 = inundated_m2();
    record_.highest = highest_runup(grid_, bed_m_, records().max_elevation_m);
    if (const auto exact = exact_depth(scenario_, surface.time_s))
        record_.exact_l1 = relative_l1(*surface.depth, *exact);
    for (const Probe& probe : scenario_.probes) {
        const int i = std::min(static_cast<int>((probe.at_m.x - grid_.x0_m) / grid_.dx_m), grid_.nx - 1);
        const int j = std::min(static_cast<int>((probe.at_m.y - grid_.y0_m) / grid_.dy_m), grid_.ny - 1);
        run.probes[probe.name].arrival_s = records().arrival_s(i, j);
    }
    run.shallow = record_;
}

void ShallowWatch::exchange_state(StateArchive& state) {
    state.value(record_);
    state.value(watched_);
}

std::vector<RunupLine> ShallowWatch::lines() const { return runup_lines(grid_, bed_m_, records().max_elevation_m); }

double ShallowWatch::inundated_m2() const {
    const double wet_m = scenario_.waves.wet_m.value_or(ShallowWaterSettings{}.wet_m);
    std::size_t cells = 0;
    for (std::size_t n = 0; n < bed_m_.size(); ++n)
        if (depth_at_start_m_.data()[n] <= wet_m && !std::isnan(records().max_elevation_m.data()[n])) ++cells;
    return static_cast<double>(cells) * grid_.cell_area_m2();
}

}  // namespace waterlight
