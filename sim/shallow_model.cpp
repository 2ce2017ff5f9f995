#include "sim/shallow_model.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "sim/error.hpp"
#include "sim/shallow_sides.hpp"

namespace waterlight {

// A step shorter than this part of the time in which the initial water's waves cross a cell is a collapse.
static constexpr double least_part = 1e-9;

template <class Real>
ShallowModel<Real>::ShallowModel(const ShallowWaterSettings& s, std::unique_ptr<ShallowSolver<Real>> solver)
    : grid_(s.grid),
      water_(s.water),
      cfl_(s.cfl),
      wet_m_(s.wet_m),
      film_(film_depth(s)),
      keep_records_(s.keep_records),
      sources_(s),
      solver_(std::move(solver)),
      least_rate_(has_series(s.sides) ? still_rate(s) : 0),
      least_step_s_(least_part / still_rate(s)),
      surface_(s.grid, boundary_of(s.sides)) {
    disturb_since(0);
    peak_ = solver_->look(0);
    if (keep_records_) solver_->record(0);
}

template <class Real>
void ShallowModel<Real>::advance(double frame_s) {
    assert(frame_s >= 0);
    const double end = time_s_ + frame_s;
    for (double remaining = frame_s; remaining > 0;) {
        dt_ = next_step(remaining);
        peak_ = solver_->step(time_s_, dt_);
        ++steps_;
        // The last step ends on the frame, whatever rounding says.
        const double from = time_s_;
        time_s_ = dt_ == remaining ? end : time_s_ + dt_;
        remaining = dt_ == remaining ? 0 : end - time_s_;
        if (disturb_since(from)) peak_ = solver_->look(time_s_);
        if (keep_records_) solver_->record(time_s_);
    }
    surface_is_new_ = false;
}

// The longest step that the Courant number allows, of which the remaining time is a multiple.
template <class Real>
double ShallowModel<Real>::next_step(double remaining_s) const {
    if (!peak_.finite) fail("a number is not finite");
    if (rate() * remaining_s <= cfl_) return remaining_s;
    const double longest = cfl_ / rate();
    if (longest < least_step_s_) fail(fmt::format("the time step fell to {:.3g} s", longest));
    return remaining_s / std::ceil(remaining_s / longest);
}

// What the sources have done since then. Returns whether there was anything.
template <class Real>
bool ShallowModel<Real>::disturb_since(double from_s) {
    const std::vector<DropPatch> patches = sources_.between(from_s, time_s_);
    for (const DropPatch& patch : patches) waterlight::disturb(patch, solver_->start(), solver_->fields());
    return !patches.empty();
}

template <class Real>
void ShallowModel<Real>::disturb(std::span<const Disturbance> disturbances) {
    for (const Disturbance& d : disturbances) require_valid(d);
    for (const Disturbance& d : disturbances)
        waterlight::disturb(patch_of(d, grid_, surface_.boundary), solver_->start(), solver_->fields());
    peak_ = solver_->look(time_s_);
    if (keep_records_) solver_->record(time_s_);
    surface_is_new_ = false;
}

template <class Real>
void ShallowModel<Real>::fail(const std::string& what) const {
    throw WorldError(
        fmt::format("shallow-water: {} at t = {:.6g} s, step {}: {}", what, time_s_, steps_ + 1, fastest_cell(view())));
}

template <class Real>
const Surface& ShallowModel<Real>::surface() {
    if (surface_is_new_) return surface_;
    surface_.time_s = time_s_;
    show_surface(view(), surface_);
    surface_is_new_ = true;
    return surface_;
}

template <class Real>
void ShallowModel<Real>::exchange_state(StateArchive& state) {
    state.value(time_s_);
    state.value(dt_);
    state.value(steps_);
    state.value(peak_.rate);
    state.value(peak_.finite);
    solver_->exchange_state(state);
    surface_is_new_ = surface_is_new_ && !state.restores();
}

template class ShallowModel<float>;
template class ShallowModel<double>;

}  // namespace waterlight
