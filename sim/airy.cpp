#include "sim/airy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/airy_initial.hpp"
#include "sim/airy_margin.hpp"
#include "sim/airy_modes.hpp"
#include "sim/airy_sources.hpp"
#include "sim/error.hpp"
#include "sim/sea_state.hpp"
#include "sim/surface_sums.hpp"

namespace waterlight {

namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw InputError("airy: " + what);
}

void require_valid(const AirySettings& settings) {
    const Grid& grid = settings.grid;
    const Water& water = settings.water;
    require(grid.nx >= 1 && grid.ny >= 1,
            fmt::format("the grid has {} x {} cells; at least 1 x 1 is needed", grid.nx, grid.ny));
    require(grid.dx_m > 0 && grid.dy_m > 0 && std::isfinite(grid.dx_m) && std::isfinite(grid.dy_m),
            fmt::format("cells measure {} x {} m; both must be above 0", grid.dx_m, grid.dy_m));
    require(water.depth_m > 0, fmt::format("depth is {} m; it must be above 0", water.depth_m));
    require(water.gravity_m_s2 > 0, fmt::format("gravity is {} m/s2; it must be above 0", water.gravity_m_s2));
    require(water.density_kg_m3 > 0, fmt::format("density is {} kg/m3; it must be above 0", water.density_kg_m3));
    require(water.surface_tension_n_m >= 0,
            fmt::format("surface tension is {} N/m; it must be 0 or more", water.surface_tension_n_m));
    require(settings.margin_m >= 0, fmt::format("the margin is {} m; it must be 0 or more", settings.margin_m));
    require(!settings.sea || settings.boundary == Boundary{Side::periodic, Side::periodic},
            "a sea from a spectrum needs periodic sides along x and y; walls and absorbing sides take sines, standing "
            "waves and sources");
    for (const Source& source : settings.sources) waterlight::require_valid(source);
}

/// The modes, what disturbs them, and the surface made from them when it is asked for.
class Airy final : public AiryModel {
  public:
    explicit Airy(const AirySettings& settings);

    std::string_view name() const override { return "airy"; }
    void advance(double frame_s) override;
    void disturb(std::span<const Disturbance> disturbances) override;
    void set_rain(std::span<const Rain> rain) override { replace_rain(settings_.sources, rain); }
    const Surface& surface() override;
    WaveDiagnostics diagnostics() override;
    std::int64_t steps() const override { return steps_; }
    SeaCoverage sea_coverage() const override { return coverage_; }
    void exchange_state(StateArchive& state) override;

  private:
    void add_sources(double from_s, double to_s);
    void damp(double step_s);
    double potential_energy_j(const WaveDiagnostics& sums) const;

    AirySettings settings_;
    AbsorbingMargin margin_x_, margin_y_;
    AiryModes modes_;
    PlaneTransform transform_;
    AiryState state_;
    std::vector<ForcedModes> makers_;
    std::optional<DirectionalDamping> damping_x_, damping_y_;
    SeaCoverage coverage_;
    double time_s_ = 0;
    std::int64_t steps_ = 0;
    Surface surface_;
    bool surface_is_present_ = false;
    Field<float> slots_, across_;  ///< planes to work in
};

Airy::Airy(const AirySettings& settings)
    : settings_(settings),
      margin_x_(
          make_margin(settings.boundary.x, settings.grid.nx, settings.grid.dx_m, settings.margin_m, settings.water)),
      margin_y_(
          make_margin(settings.boundary.y, settings.grid.ny, settings.grid.dy_m, settings.margin_m, settings.water)),
      modes_(make_airy_modes(settings.grid, settings.boundary, settings.water, {margin_x_.cells, margin_y_.cells})),
      transform_(modes_.x, modes_.y),
      state_{Field<double>(modes_.x.n, modes_.y.n), Field<double>(modes_.x.n, modes_.y.n), 0},
      surface_(settings.grid, settings.boundary),
      slots_(transform_.make_plane()),
      across_(transform_.make_plane()) {
    for (const StandingWave& wave : settings.standing) add_standing(wave, settings.boundary, modes_, state_);
    for (const Sine& sine : settings.sines) add_sine(sine, settings.boundary, modes_, state_);
    if (settings.sea) coverage_ = add_sea(*settings.sea, modes_, state_);
    for (const Source& source : settings.sources)
        if (const auto* maker = std::get_if<Wavemaker>(&source))
            makers_.emplace_back(*maker, settings.grid, modes_, transform_);
    if (margin_x_.cells > 0) damping_x_.emplace(modes_.x, margin_x_);
    if (margin_y_.cells > 0) damping_y_.emplace(modes_.y, margin_y_);
}

void Airy::add_sources(double from_s, double to_s) {
    std::vector<Drop> drops;
    for (const Source& source : settings_.sources) {
        if (const auto* drop = std::get_if<Drop>(&source); drop && drop->time_s >= from_s && drop->time_s < to_s)
            drops.push_back(*drop);
        if (const auto* rain = std::get_if<Rain>(&source))
            for (const Drop& drop : drops_of(*rain, settings_.grid, from_s, to_s)) drops.push_back(drop);
    }
    if (!drops.empty()) add_drops(modes_, drops, state_);
    for (const ForcedModes& maker : makers_) maker.add(from_s, to_s, state_);
}

void Airy::damp(double step_s) {
    evaluate_modes(modes_, state_, time_s_, slots_, &across_);
    if (damping_x_) damping_x_->damp_rows(step_s, modes_.y.n, slots_, across_);
    if (damping_y_) damping_y_->damp_columns(step_s, modes_.x.n, slots_, across_);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < modes_.y.n; ++j) {
        std::copy_n(slots_.row(j), modes_.x.n, state_.a.row(j));
        std::copy_n(across_.row(j), modes_.x.n, state_.b.row(j));
    }
    state_.start_s = time_s_;
}

void Airy::advance(double frame_s) {
    assert(frame_s >= 0);
    double longest = std::max(frame_s, 1e-300);
    for (const AbsorbingMargin* margin : {&margin_x_, &margin_y_})
        if (margin->cells > 0) longest = std::min(longest, margin->step_s);
    const auto count = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(frame_s / longest)));
    const double from_s = time_s_;
    for (std::int64_t n = 1; n <= count; ++n) {
        const double next_s = from_s + frame_s * static_cast<double>(n) / static_cast<double>(count);
        const double step_s = next_s - time_s_;
        add_sources(time_s_, next_s);
        time_s_ = next_s;
        if (damping_x_ || damping_y_) damp(step_s);
        ++steps_;
    }
    surface_is_present_ = false;
}

void Airy::disturb(std::span<const Disturbance> disturbances) {
    for (const Disturbance& d : disturbances) waterlight::require_valid(d);
    add_disturbances(modes_, disturbances, time_s_, state_);
    surface_is_present_ = false;
}

const Surface& Airy::surface() {
    if (surface_is_present_) return surface_;
    evaluate_modes(modes_, state_, time_s_, slots_, nullptr);
    transform_.columns_to_space(slots_, true, across_);
    transform_.rows_to_space(across_, false, modes_.visible, surface_.slope_y);
    transform_.columns_to_space(slots_, false, across_);
    transform_.rows_to_space(across_, false, modes_.visible, surface_.elevation);
    transform_.rows_to_space(across_, true, modes_.visible, surface_.slope_x);
    surface_.time_s = time_s_;
    surface_is_present_ = true;
    return surface_;
}

/// Of the surface itself and not of the modes that it is made from, so that a drift of either shows.
double Airy::potential_energy_j(const WaveDiagnostics& sums) const {
    const Water& water = settings_.water;
    const double area = modes_.area_m2(), level = sums.volume_m3 / area;
    return 0.5 * area *
           (water.density_kg_m3 * water.gravity_m_s2 * (sums.variance_m2 + level * level) +
            water.surface_tension_n_m * sums.slope_variance);
}

WaveDiagnostics Airy::diagnostics() {
    WaveDiagnostics sums = surface_sums(surface());
    evaluate_modes(modes_, state_, time_s_, slots_, &across_);
    const bool whole_tank = !damping_x_ && !damping_y_;
    sums.energy_j =
        (whole_tank ? potential_energy_j(sums) : plane_energy_j(modes_, slots_)) + plane_energy_j(modes_, across_);
    return sums;
}

void Airy::exchange_state(StateArchive& state) {
    state.value(time_s_);
    state.value(steps_);
    state.value(state_.start_s);
    state.values(state_.a.values());
    state.values(state_.b.values());
    surface_is_present_ = surface_is_present_ && !state.restores();
}

}  // namespace

std::unique_ptr<AiryModel> make_airy(const AirySettings& settings) {
    require_valid(settings);
    return std::make_unique<Airy>(settings);
}

}  // namespace waterlight
