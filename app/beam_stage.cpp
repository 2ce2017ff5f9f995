#include "app/beam_stage.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/beam_point.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

BeamStage::BeamStage(const Scenario& scenario) : scenario_(scenario) {
    if (scenario.beams->volume_cells) moments_.resize(static_cast<std::size_t>(scenario.beams->volume_cells->z));
}

void BeamStage::compute(const Surface& surface) {
    make_beams(beam_settings(scenario_), surface, beams_);
    if (scenario_.beams->volume_cells) fill_volume(beams_, *scenario_.beams->volume_cells, volume_);
    if (scenario_.camera) draw(surface);
}

void BeamStage::draw(const Surface& surface) {
    const BeamImageSettings settings = beam_image_settings(scenario_);
    if (!scenario_.beams->refine_below) return draw_beams(settings, beams_, image_);
    make_refined_beams(beam_settings(scenario_), *scenario_.beams->refine_below, surface, refined_);
    draw_beams(settings, refined_, image_);
}

void BeamStage::add_frame() {
    const BeamLedger& ledger = beams_.ledger;
    record_.last_ledger = ledger;
    record_.sum = record_.sum + ledger;
    record_.closure = std::max(record_.closure, ledger.closure());
    if (ledger.incident_w > 0)
        record_.discarded_fraction = std::max(record_.discarded_fraction, ledger.discarded_w / ledger.incident_w);
    if (volume()) add_volume();
    if (!image()) return;
    double sum = 0, most = 0;
    for (const float radiance : image_.radiance.values()) {
        sum += radiance;
        most = std::max(most, static_cast<double>(radiance));
    }
    record_.mean_radiance = sum / static_cast<double>(image_.radiance.size());
    record_.max_radiance = most;
    record_.counts = image_.counts;
}

void BeamStage::add_volume() {
    float brightest = -1;
    for (int k = 0; k < volume_.cells.z; ++k) {
        add_slice(k);
        const SliceLedger& l = volume_.ledger[static_cast<std::size_t>(k)];
        if (l.flux_w > 0)
            record_.flux_error = std::max(record_.flux_error, std::abs(l.inside_w + l.outside_w - l.flux_w) / l.flux_w);
        for (const float e : volume_.plane(k)) {
            if (e <= brightest) continue;
            brightest = e;
            record_.brightest_depth_m = -volume_.z_m(k, beams_.depth_m);
        }
    }
}

void BeamStage::add_slice(int k) {
    Moments& m = moments_[static_cast<std::size_t>(k)];
    double sum = 0;
    for (const float e : volume_.plane(k)) sum += e;
    const double mean = sum / static_cast<double>(volume_.plane(k).size()), flash = 1.5 * mean;
    for (const float value : volume_.plane(k)) {
        const double e = value;
        m.squares += e * e;
        m.cubes += e * e * e;
        m.flashes += e > flash ? 1 : 0;
    }
    m.sum += sum;
    m.count += static_cast<double>(volume_.plane(k).size());
}

BeamRecord BeamStage::record() const {
    BeamRecord record = record_;
    for (int k = static_cast<int>(moments_.size()) - 1; k >= 0; --k) {
        const Moments& m = moments_[static_cast<std::size_t>(k)];
        const double mean = m.sum / m.count, variance = std::max(0.0, m.squares / m.count - mean * mean);
        const double third = m.cubes / m.count - 3 * mean * variance - mean * mean * mean;
        SliceStatistics s{-volume_.z_m(k, beams_.depth_m), mean, 0, 0, m.flashes / m.count};
        if (mean > 0) s.cv = std::sqrt(variance) / mean;
        constexpr double even = 1e-5;  // below which the skewness would be that of rounding
        if (s.cv > even) s.skewness = third / std::pow(variance, 1.5);
        record.slices.push_back(s);
    }
    return record;
}

void BeamStage::exchange_state(StateArchive& state) {
    // All of them by name, so that one that is added cannot be forgotten here. The slices are those of the moments.
    auto& [last, sum, closure, discarded, slices, flux_error, brightest, mean, most, counts] = record_;
    state.value(last);
    state.value(sum);
    for (double* value : {&closure, &discarded, &flux_error, &brightest, &mean, &most}) state.value(*value);
    state.value(counts);
    state.list(moments_);
    slices.clear();
}

double BeamStage::irradiance_at(glm::dvec2 at_m, double depth_m) const {
    return waterlight::irradiance_at(beams_, {at_m, -depth_m}).plane_w_m2;
}

}  // namespace waterlight
