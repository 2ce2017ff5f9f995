#include "app/beam_stage.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/flashes.hpp"
#include "app/ground_heights.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

std::shared_ptr<const BeamGround> ground_for(const Scenario& scenario, const BuiltModel& model) {
    Field<float> heights = ground_heights(scenario, model);
    if (heights.empty()) return nullptr;
    return std::make_shared<BeamGround>(grid_of(scenario), resolve_boundary(scenario), std::move(heights));
}

void require_above(const BeamGround& ground, glm::dvec3 camera) {
    const double height = ground.height_m(glm::dvec2(camera));
    if (camera.z > height) return;
    throw InputError(fmt::format("camera.position_m: found a height of {} m; allowed: above the ground there, at {} m",
                                 camera.z, height));
}

}  // namespace

BeamStage::BeamStage(const Scenario& scenario, const BuiltModel& model, std::unique_ptr<BeamRenderer> renderer)
    : scenario_(scenario), ground_(ground_for(scenario, model)), renderer_(std::move(renderer)) {
    record_.backend = renderer_->backend();
    if (scenario.camera && !looks_from_air(scenario) && ground_)
        require_above(*ground_, scenario.camera->camera.position_m);
    if (scenario.beams->volume_cells) moments_.resize(static_cast<std::size_t>(scenario.beams->volume_cells->z));
}

BeamSettings BeamStage::settings() const {
    BeamSettings settings = beam_settings(scenario_);
    settings.ground = ground_;
    return settings;
}

PictureGround BeamStage::picture_ground() const {
    return {[ground = ground_](glm::dvec2 at) { return ground->height_m(at); }, ground_->step_m(),
            ground_->highest_m()};
}

void BeamStage::compute_beams(const Surface& surface) { make_beams(settings(), surface, beams_); }

void BeamStage::compute(const Surface& surface) {
    compute_beams(surface);
    if (scenario_.beams->reflected) make_reflected_beams(reflected_settings(scenario_), surface, reflected_);
    if (scenario_.beams->volume_cells) renderer_->fill(beams_, *scenario_.beams->volume_cells, volume_);
    if (sees_scattered_light(scenario_)) draw(surface);
}

void BeamStage::draw(const Surface& surface) {
    BeamImageSettings picture = beam_image_settings(scenario_);
    if (looks_from_air(scenario_)) return renderer_->draw(picture, reflected_, image_);
    if (ground_) picture.ground = picture_ground();
    if (!scenario_.beams->refine_below) return renderer_->draw(picture, beams_, image_);
    make_refined_beams(settings(), *scenario_.beams->refine_below, surface, refined_);
    draw_beams(*renderer_, picture, refined_, image_);
}

void BeamStage::add_frame(double time_s) {
    const LightLedger ledger = light_ledger(beams_.ledger, scenario_.optics);
    record_.last_ledger = ledger;
    record_.sum += ledger;
    record_.closure = std::max(record_.closure, ledger.closure());
    if (ledger.incident_w > 0)
        record_.discarded_fraction = std::max(record_.discarded_fraction, ledger.lost_w / ledger.incident_w);
    if (scenario_.beams->reflected) {
        record_.last_reflected = reflected_.ledger;
        record_.sum_reflected = record_.sum_reflected + reflected_.ledger;
        record_.closure = std::max(record_.closure, reflected_.ledger.closure());
    }
    if (volume()) add_volume(time_s);
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

void BeamStage::add_volume(double time_s) {
    const bool is_first = flashing_.empty();
    const double since_s = is_first ? 0 : time_s - last_frame_s_;
    last_frame_s_ = time_s;
    record_.sampled_every_s = std::max(record_.sampled_every_s, since_s);
    if (is_first) flashing_.assign(volume_.plane_irradiance.size(), 1);
    float brightest = -1;
    for (int k = 0; k < volume_.cells.z; ++k) {
        add_slice(k, since_s);
        const SliceLedger& l = volume_.ledger[static_cast<std::size_t>(k)];
        if (l.flux_w > 0)
            record_.flux_error = std::max(record_.flux_error, std::abs(l.inside_w + l.outside_w - l.flux_w) / l.flux_w);
        for (const float e : volume_.plane(k)) {
            if (e <= brightest) continue;
            brightest = e;
            record_.brightest_depth_m = -volume_.z_m(k);
        }
    }
}

void BeamStage::add_slice(int k, double since_s) {
    const std::span<const float> cells = volume_.plane(k);
    const auto for_each = [&](auto&& take) {
        for (std::size_t n = 0; n < cells.size(); ++n)
            if (volume_.above_ground(n, k)) take(static_cast<double>(cells[n]));
    };
    double sum = 0, count = 0;
    for_each([&](double e) {
        sum += e;
        count += 1;
    });
    Moments& m = moments_[static_cast<std::size_t>(k)];
    const double flash = flash_level * sum / std::max(count, 1.0);
    for_each([&](double e) {
        m.squares += e * e;
        m.cubes += e * e * e;
        m.flashes += e > flash ? 1 : 0;
    });
    m.sum += sum;
    m.count += count;
    m.cells += static_cast<double>(cells.size());
    m.watched_s += since_s * count;
    watch_flashes(k, flash);
}

void BeamStage::watch_flashes(int k, double level) {
    const std::span<const float> cells = volume_.plane(k);
    char* before = flashing_.data() + static_cast<std::size_t>(k) * cells.size();
    for (std::size_t n = 0; n < cells.size(); ++n) {
        const char now = cells[n] > level ? 1 : 0;
        if (now > before[n] && volume_.above_ground(n, k)) moments_[static_cast<std::size_t>(k)].rises += 1;
        before[n] = now;
    }
}

BeamRecord BeamStage::record() const {
    BeamRecord record = record_;
    for (int k = static_cast<int>(moments_.size()) - 1; k >= 0; --k) {
        const Moments& m = moments_[static_cast<std::size_t>(k)];
        const double count = std::max(m.count, 1.0), mean = m.sum / count;
        const double variance = std::max(0.0, m.squares / count - mean * mean);
        const double third = m.cubes / count - 3 * mean * variance - mean * mean * mean;
        SliceStatistics s{-volume_.z_m(k), mean, 0, 0, m.flashes / count, 0, m.count / m.cells};
        if (m.watched_s > 0) s.flash_rate_hz = m.rises / m.watched_s;
        if (mean > 0) s.cv = std::sqrt(variance) / mean;
        constexpr double even = 1e-5;  // below which the skewness would be that of rounding
        if (s.cv > even) s.skewness = third / std::pow(variance, 1.5);
        record.slices.push_back(s);
    }
    return record;
}

void BeamStage::exchange_state(StateArchive& state) {
    // All of them by name, so that one that is added cannot be forgotten here. The slices are those of the moments.
    auto& [backend, last, sum, closure, discarded, last_reflected, sum_reflected, slices, flux_error, brightest,
           sampled, mean, most, counts] = record_;
    for (LightLedger* ledger : {&last, &sum}) state.value(*ledger);
    for (BeamLedger* ledger : {&last_reflected, &sum_reflected}) state.value(*ledger);
    for (double* value : {&closure, &discarded, &flux_error, &brightest, &sampled, &mean, &most}) state.value(*value);
    state.value(counts);
    state.list(moments_);
    state.list(flashing_);
    state.value(last_frame_s_);
    slices.clear();
}

PointIrradiance BeamStage::irradiance_at(glm::dvec2 at_m, double depth_m) const {
    return waterlight::irradiance_at(beams_, {at_m, -depth_m});
}

}  // namespace waterlight
