#include "app/view/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/readings.hpp"
#include "app/view/copies.hpp"
#include "app/view/rain_by_hand.hpp"
#include "app/view/stopwatch.hpp"
#include "scenarios/choose.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

constexpr std::array<std::string_view, 3> part_names{"floor", "beams", "walls"};

void require(bool holds, const char* what) {
    if (!holds) throw InputError(what);
}

bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// A spot as wide as the domain is wider than any hand needs, and would cost.
void require_radius(const char* who, double radius_m, const Scenario& scenario) {
    const double most = std::max(scenario.domain.size_m.x, scenario.domain.size_m.y);
    if (radius_m > 0 && radius_m <= most) return;
    throw InputError(fmt::format("{}: found a radius of {} m; allowed: above 0, at most {} m", who, radius_m, most));
}

void require_valid(const BeamView& view) {
    const Camera& c = view.camera;
    constexpr int most = 1 << 14;
    const auto is_count = [](int n) { return n >= 1 && n <= most; };
    require(is_finite(c.position_m) && is_finite(c.target_m) && c.position_m != c.target_m,
            "camera: position_m and target_m must be two different places");
    require(c.fov_deg > 0 && c.fov_deg < 180, "camera: fov_deg must be in (0, 180)");
    require(is_count(c.size.x) && is_count(c.size.y), "camera: its pixels must be 1 to 16384 each way");
    require(is_count(view.samples) && is_count(view.reduction), "camera: samples and reduction must be 1 to 16384");
}

std::optional<BeamView> view_of(const Scenario& scenario) {
    if (!scenario.camera) return std::nullopt;
    return BeamView{scenario.camera->camera, scenario.camera->samples, scenario.camera->reduction};
}

bool has_section(const Scenario& s, LightPart part) {
    return part == LightPart::floor   ? s.floor.has_value()
           : part == LightPart::beams ? s.beams.has_value()
                                      : s.walls.has_value();
}

/// Whether the key is of the water's motion.
bool is_of_waves(const std::string& key) {
    const auto within = [&](std::string_view section) {
        return key.starts_with(section) &&
               (key.size() == section.size() || key[section.size()] == '.' || key[section.size()] == '[');
    };
    return key == "water" || within("domain") || within("waves") || within("water.gravity_m_s2") ||
           within("water.density_kg_m3") || within("water.surface_tension_n_m");
}

/// Whether a model with another value of that key can go on from the state of one with this.
bool goes_on(const std::string& key) {
    return key.starts_with("waves.source") || key == "waves.duration_s" || key == "waves.manning";
}

bool is_of_same_kind(const Scenario& a, const Scenario& b) {
    return resolve_model(a).model == resolve_model(b).model && grid_of(a) == grid_of(b) &&
           resolve_boundary(a) == resolve_boundary(b);
}

}  // namespace

Simulation::Simulation(const Scenario& scenario, const DeviceWish& device) : device_(device), edits_(scenario) {
    view_ = view_of(scenario);
    replace(build(scenario, choose_backend(device_, scenario), Keep::nothing), Keep::nothing);
}

void Simulation::disturb(std::span<const Disturbance> disturbances) {
    run_.water->disturb(disturbances);
    is_trial_shown_ = false;
}

void Simulation::drop(glm::dvec2 at_m, double radius_m, double height_m) {
    require_radius("drop", radius_m, *run_.scenario);
    const Drop drop{at_m, radius_m, height_m, run_.water->model().surface().time_s};
    const Disturbance disturbance = drop;
    disturb({&disturbance, 1});
    edits_.add(drop);
}

void Simulation::hold_sphere(const HeldSphere& sphere) {
    require_radius("sphere", sphere.radius_m, *run_.scenario);
    require(is_finite(sphere.centre_m), "sphere: its centre must be three numbers");
    require(!run_.water->built().prescribed, "a prescribed surface cannot be disturbed");
    sphere_ = sphere;
    is_trial_shown_ = false;
}

void Simulation::move_sphere(glm::dvec3 centre_m) {
    require(sphere_.has_value(), "sphere: none is held");
    require(is_finite(centre_m), "sphere: its centre must be three numbers");
    const std::array<Push, 2> pushes = sphere_pushes(sphere_->centre_m, centre_m, sphere_->radius_m);
    disturb(std::array<Disturbance, 2>{pushes[0], pushes[1]});
    sphere_->centre_m = centre_m;
}

void Simulation::rain(std::optional<double> drops_per_m2_s) {
    require(!drops_per_m2_s || !run_.water->built().prescribed, "a prescribed surface cannot be disturbed");
    const std::vector<std::string> changed = rain_overrides(*run_.scenario, drops_per_m2_s);
    std::vector<std::string> overrides = edits_.with(changed);
    auto next = std::make_shared<Scenario>(*run_.scenario);
    next->waves.sources = parse_scenario(edits_.origin().text, edits_.origin().file, overrides).waves.sources;
    run_.water->set_rain(rain_of(*next));
    run_.scenario = std::move(next);
    edits_.set(std::move(overrides));
    is_trial_shown_ = false;
}

void Simulation::sun(double elevation_deg, double azimuth_deg) {
    const std::vector<std::string> changed{fmt::format("light.elevation_deg={:.17g}", elevation_deg),
                                           fmt::format("light.azimuth_deg={:.17g}", azimuth_deg)};
    std::vector<std::string> overrides = edits_.with(changed);
    Scenario next = *run_.scenario;
    next.light = parse_scenario(edits_.origin().text, edits_.origin().file, overrides).light;
    check_combinations(next);
    Built built{std::make_shared<const Scenario>(std::move(next)), run_.backend, run_.water, nullptr};
    build_light(built);
    std::swap(run_, built);
    edits_.set(std::move(overrides));
    is_trial_shown_ = false;
}

void Simulation::look(const std::optional<BeamView>& view) {
    if (view) require_valid(*view);
    view_ = view;
    run_.light->look(view_);
    is_trial_shown_ = false;
}

void Simulation::compute(LightPart part, bool on) {
    const auto n = static_cast<std::size_t>(part);
    const bool before = is_on_[n];
    is_on_[n] = on;
    run_.light->compute(part, on);
    is_trial_shown_ = false;
    if (!on || has_section(*run_.scenario, part)) return;
    try {
        set({fmt::format("caustics.{}={{}}", part_names[n])});
    } catch (...) {
        is_on_[n] = before;
        run_.light->compute(part, before);
        throw;
    }
}

void Simulation::reset() {
    BackendDecision backend = failed_ ? choose_backend(device_, *run_.scenario) : run_.backend;
    replace(build(*run_.scenario, std::move(backend), Keep::nothing), Keep::nothing);
    note_.clear();
}

void Simulation::set(const std::vector<std::string>& changed) {
    std::vector<std::string> overrides = edits_.with(changed);
    Scenario next = read_again(edits_.origin(), overrides);
    const std::optional<BeamView> view = view_of(next);
    const bool aims = std::ranges::any_of(changed, [](const auto& o) { return o.starts_with("camera"); });
    if (aims && view) require_valid(*view);
    rebuild(std::move(next), std::move(overrides), changed);
    if (aims) look(view);
}

void Simulation::set_device(const DeviceWish& device) {
    const DeviceWish before = device_;
    device_ = device;
    try {
        rebuild(*run_.scenario, edits_.overrides(), {});
    } catch (...) {
        device_ = before;
        throw;
    }
}

Simulation::Keep Simulation::what_to_keep(const std::vector<std::string>& changed, const Scenario& next,
                                          const BackendDecision& backend) const {
    const Scenario& now = *run_.scenario;
    const bool moves_device =
        has_vulkan_model(now) && (backend.backend != run_.backend.backend || backend.device != run_.backend.device);
    // An error is estimated from the start on, by models that have gone the same way.
    const bool begins_estimate = next.accuracy.estimate && !now.accuracy.estimate && !run_.water->built().prescribed;
    if (failed_ || moves_device || begins_estimate || !is_of_same_kind(now, next)) return Keep::nothing;
    bool is_same = next.accuracy.estimate == now.accuracy.estimate;
    for (const std::string& override : changed) {
        const std::string key = key_of(override);
        if (!is_of_waves(key)) continue;
        if (!goes_on(key)) return Keep::nothing;
        is_same = false;
    }
    return is_same ? Keep::water : Keep::state;
}

void Simulation::rebuild(Scenario next, std::vector<std::string> overrides, const std::vector<std::string>& changed) {
    BackendDecision backend = choose_backend(device_, next);
    const bool is_same_device = backend.backend == run_.backend.backend && backend.device == run_.backend.device;
    if (is_same_device && !failed_) backend = run_.backend;
    const Keep keep = what_to_keep(changed, next, backend);
    const double time_s = run_.water->model().surface().time_s;
    replace(build(std::move(next), std::move(backend), keep), keep);
    edits_.set(std::move(overrides));
    note_.clear();
    if (keep == Keep::nothing && time_s > 0)
        note_ = fmt::format("the water started again: no other goes on as {} on {} x {} cells",
                            run_.water->model().name(), run_.scenario->domain.cells.x, run_.scenario->domain.cells.y);
}

Simulation::Built Simulation::build(Scenario next, BackendDecision backend, Keep keep) const {
    Built built{std::make_shared<const Scenario>(std::move(next)), std::move(backend), run_.water, nullptr};
    if (keep != Keep::water) built.water = std::make_shared<MovingWater>(*built.scenario, built.backend);
    if (keep == Keep::state) built.water->take_state(*run_.water);
    build_light(built);
    return built;
}

void Simulation::build_light(Built& built) const {
    built.light = std::make_unique<WaterLight>(built.scenario, built.water->built(), built.backend);
    built.light->look(view_);
    for (std::size_t n = 0; n < is_on_.size(); ++n) built.light->compute(static_cast<LightPart>(n), is_on_[n]);
}

/// Only what has shown its first frame takes the place of what runs.
void Simulation::replace(Built next, Keep kept) {
    const ErrorEstimates before = estimates_;
    const double waves_ms = waves_ms_;
    is_trial_shown_ = false;
    try {
        estimates_ = {};
        waves_ms_ = 0;
        show_run(next, trial_, true);
    } catch (...) {
        estimates_ = before;
        waves_ms_ = waves_ms;
        throw;
    }
    if (kept == Keep::nothing) edits_.forget_drops();
    std::swap(run_, next);
    failed_ = false;
    is_trial_shown_ = true;
}

void Simulation::advance(double seconds) {
    waves_ms_ = 0;
    is_trial_shown_ = false;
    const Stopwatch watch(waves_ms_);
    run_.water->advance(seconds);
}

void Simulation::show(Snapshot& to, bool estimates) {
    if (is_trial_shown_)
        std::swap(to, trial_);
    else
        show_run(run_, to, estimates);
    is_trial_shown_ = false;
    to.sphere = sphere_;
}

void Simulation::show_run(Built& run, Snapshot& to, bool estimates) {
    WaveModel& model = run.water->model();
    to.costs = {};
    to.costs.waves_ms = waves_ms_;
    const Surface* surface = nullptr;
    {
        const Stopwatch watch(to.costs.waves_ms);
        surface = &model.surface();
        require_finite(*surface, model.steps());
        copy(*surface, to.surface);
    }
    to.time_s = surface->time_s;
    to.steps = model.steps();
    to.scenario = run.scenario;
    to.backend = run.backend;
    to.backend.context = nullptr;
    run.light->show(*surface, model.steps(), to);
    WaveEstimate* waves = run.water->estimate();
    if (run.scenario->accuracy.estimate && estimates) {
        const Stopwatch watch(to.costs.estimate_ms);
        if (waves) waves->compute(*surface);
        if (to.has.floor) run.light->estimate(*surface, to.floor);
        estimates_.time_s = to.time_s;
    }
    to.estimates = estimates_;
    run.light->show_estimate(to);
    if (!waves || std::isnan(estimates_.time_s)) return;
    to.estimates.waves_rmse = waves->rmse();
    copy(waves->error(), to.waves_error);
    to.has.waves_error = true;
}

}  // namespace waterlight
