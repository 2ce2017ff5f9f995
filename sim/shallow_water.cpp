#include "sim/shallow_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/error.hpp"
#include "sim/kernels/linear.hpp"
#include "sim/kernels/shallow_water.hpp"
#include "sim/shallow_check.hpp"
#include "sim/shallow_disturbance.hpp"
#include "sim/shallow_records.hpp"
#include "sim/shallow_sides.hpp"
#include "sim/shallow_surface.hpp"
#include "sim/shallow_sweep.hpp"

namespace waterlight {

namespace {

// A step shorter than this part of the time in which the initial water's waves cross a cell is a collapse.
constexpr double least_part = 1e-9;

template <class Real>
class ShallowWater final : public ShallowWaterModel {
  public:
    explicit ShallowWater(const ShallowWaterSettings& settings);

    std::string_view name() const override { return "shallow-water"; }
    void advance(double frame_s) override;
    const Surface& surface() override;
    WaveDiagnostics diagnostics() override { return shallow_diagnostics(surface(), totals()); }
    std::int64_t steps() const override { return steps_; }
    ShallowState state(int i, int j) const override { return state_of(view(), i, j); }
    double bed_m(int i, int j) const override { return ground_of(start_, i, j); }
    double step_s() const override { return steps_ > 0 ? dt_ : cfl_ / rate(); }
    ShallowTotals totals() const override { return shallow_totals(view(), wet_m_); }
    const ShallowRecords* records() const override { return records_ ? &*records_ : nullptr; }

  private:
    ShallowView<Real> view() const { return {grid_, water_, start_, now_, film_}; }
    double rate() const { return std::max({peak_.rate, side_rate_, least_rate_}); }
    ShallowStage<Real> stage(double dt, double time_s) const;
    double next_step(double remaining_s);
    void step(double dt);
    void look();
    [[noreturn]] void fail(const std::string& what) const;

    Grid grid_;
    Water water_;
    double manning_, cfl_, wet_m_;
    double film_;
    ShallowFrames<Real> frames_;
    ShallowSources<Real> sources_;
    ShallowStart<Real> start_;
    ShallowFields<Real> now_, change_;
    ShallowSweep<Real> sweep_;
    ShallowPeak peak_;
    double side_rate_ = 0;
    double least_rate_;  ///< what may come in with time must not be passed over, as long as hardly any water is there
    double least_step_s_;
    double time_s_ = 0, dt_ = 0;
    std::int64_t steps_ = 0;
    std::optional<ShallowRecords> records_;
    Surface surface_;
    bool surface_is_new_ = false;
};

template <class Real>
ShallowWater<Real>::ShallowWater(const ShallowWaterSettings& s)
    : grid_(s.grid),
      water_(s.water),
      manning_(s.manning),
      cfl_(s.cfl),
      wet_m_(s.wet_m),
      film_(film_depth(s)),
      frames_(s.grid, s.sides, s.water.gravity_m_s2, film_),
      sources_(s),
      start_(s.grid.nx, s.grid.ny),
      now_(s.grid.nx, s.grid.ny),
      change_(s.grid.nx, s.grid.ny),
      sweep_(s.grid.nx, s.grid.ny, std::holds_alternative<PeriodicSide>(s.sides.west),
             std::holds_alternative<PeriodicSide>(s.sides.south)),
      least_rate_(frames_.has_series() ? still_rate(s) : 0),
      least_step_s_(least_part / still_rate(s)),
      surface_(s.grid, boundary_of(s.sides)) {
    set_start(s, start_, now_);
    frames_.fill(start_);
    if (s.keep_records) records_ = first_records(view(), wet_m_);
    sources_.act(0, 0, start_, now_);
    look();
}

template <class Real>
ShallowStage<Real> ShallowWater<Real>::stage(double dt, double time_s) const {
    const double g = water_.gravity_m_s2;
    return {.dt = static_cast<Real>(dt),
            .per_dx = static_cast<Real>(1 / grid_.dx_m),
            .per_dy = static_cast<Real>(1 / grid_.dy_m),
            .gravity = static_cast<Real>(g),
            .gates = frames_.gates(time_s),
            .film = static_cast<Real>(film_),
            .friction = static_cast<Real>(0.5 * g * manning_ * manning_ * dt)};
}

template <class Real>
void ShallowWater<Real>::advance(double frame_s) {
    assert(frame_s >= 0);
    const double end = time_s_ + frame_s;
    for (double remaining = frame_s; remaining > 0;) {
        const double dt = next_step(remaining);
        step(dt);
        // The last step ends on the frame, whatever rounding says.
        time_s_ = dt == remaining ? end : time_s_ + dt;
        remaining = dt == remaining ? 0 : end - time_s_;
        if (sources_.act(time_s_ - dt, time_s_, start_, now_)) look();
        if (records_) add_records(view(), time_s_, wet_m_, *records_);
    }
    surface_is_new_ = false;
}

// The longest step that the Courant number allows, of which the remaining time is a multiple.
template <class Real>
double ShallowWater<Real>::next_step(double remaining_s) {
    side_rate_ = frames_.fill(start_, {time_s_, time_s_}, now_);
    if (!(peak_.finite && std::isfinite(side_rate_))) fail("a number is not finite");
    if (rate() * remaining_s <= cfl_) return remaining_s;
    const double longest = cfl_ / rate();
    if (longest < least_step_s_) fail(fmt::format("the time step fell to {:.3g} s", longest));
    return remaining_s / std::ceil(remaining_s / longest);
}

// Heun's method: change = dt L(u), then u += (change + dt L(u + change)) / 2; half of the friction before, half after.
template <class Real>
void ShallowWater<Real>::step(double dt) {
    const ShallowStage<Real> first = stage(dt, time_s_), second = stage(dt, time_s_ + dt);
    const ShallowMoment moment{time_s_, time_s_ + dt};
    if (first.friction > 0) sweep_.rub(first, start_, change_, now_);
    if (first.friction > 0 || frames_.has_series()) frames_.fill(start_, moment, now_);
    sweep_.first_stage(first, start_, now_, change_);
    frames_.fill(start_, moment, now_, change_);
    peak_ = sweep_.second_stage(second, start_, change_, now_);
    dt_ = dt;
    ++steps_;
}

template <class Real>
void ShallowWater<Real>::look() {
    peak_ = sweep_.look(stage(0, time_s_), start_, change_, now_);
    side_rate_ = frames_.fill(start_, {time_s_, time_s_}, now_);
    surface_is_new_ = false;
}

template <class Real>
void ShallowWater<Real>::fail(const std::string& what) const {
    throw WorldError(
        fmt::format("shallow-water: {} at t = {:.6g} s, step {}: {}", what, time_s_, steps_ + 1, fastest_cell(view())));
}

template <class Real>
const Surface& ShallowWater<Real>::surface() {
    if (surface_is_new_) return surface_;
    frames_.fill(start_, {time_s_, time_s_}, now_);
    surface_.time_s = time_s_;
    show_surface(view(), surface_);
    surface_is_new_ = true;
    return surface_;
}

}  // namespace

template <class Real>
std::unique_ptr<ShallowWaterModel> make_shallow_water(const ShallowWaterSettings& settings) {
    check_shallow(settings);
    return std::make_unique<ShallowWater<Real>>(settings);
}

template std::unique_ptr<ShallowWaterModel> make_shallow_water<float>(const ShallowWaterSettings&);
template std::unique_ptr<ShallowWaterModel> make_shallow_water<double>(const ShallowWaterSettings&);

}  // namespace waterlight
