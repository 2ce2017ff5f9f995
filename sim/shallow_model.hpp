// The shallow-water model around a solver: how long its steps are, and what its state says.
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "sim/shallow_disturbance.hpp"
#include "sim/shallow_solver.hpp"
#include "sim/shallow_surface.hpp"

namespace waterlight {

template <class Real>
class ShallowModel final : public ShallowWaterModel {
  public:
    /// `settings` have passed check_shallow(); the solver starts from them.
    ShallowModel(const ShallowWaterSettings& settings, std::unique_ptr<ShallowSolver<Real>> solver);

    std::string_view name() const override { return "shallow-water"; }
    void advance(double frame_s) override;
    void disturb(std::span<const Disturbance> disturbances) override;
    void set_rain(std::span<const Rain> rain) override { sources_.set_rain(rain); }
    const Surface& surface() override;
    WaveDiagnostics diagnostics() override { return shallow_diagnostics(surface(), totals()); }
    std::int64_t steps() const override { return steps_; }
    ShallowState state(int i, int j) const override { return state_of(view(), i, j); }
    double bed_m(int i, int j) const override { return ground_of(solver_->start(), i, j); }
    double step_s() const override { return steps_ > 0 ? dt_ : cfl_ / rate(); }
    ShallowTotals totals() const override { return shallow_totals(view(), wet_m_); }
    const ShallowRecords* records() const override { return keep_records_ ? &solver_->records() : nullptr; }
    void exchange_state(StateArchive& state) override;

  private:
    ShallowView<Real> view() const { return {grid_, water_, solver_->start(), solver_->fields(), film_}; }
    double rate() const { return std::max(peak_.rate, least_rate_); }
    double next_step(double remaining_s) const;
    bool disturb_since(double from_s);
    [[noreturn]] void fail(const std::string& what) const;

    Grid grid_;
    Water water_;
    double cfl_, wet_m_, film_;
    bool keep_records_;
    ShallowSources sources_;
    std::unique_ptr<ShallowSolver<Real>> solver_;
    ShallowPeak peak_;
    double least_rate_;  ///< what may come in with time must not be passed over while hardly any water is there
    double least_step_s_;
    double time_s_ = 0, dt_ = 0;
    std::int64_t steps_ = 0;
    Surface surface_;
    bool surface_is_new_ = false;
};

extern template class ShallowModel<float>;
extern template class ShallowModel<double>;

}  // namespace waterlight
