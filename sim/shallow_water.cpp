#include "sim/shallow_water.hpp"

#include <algorithm>
#include <cmath>

#include "sim/shallow_check.hpp"
#include "sim/shallow_model.hpp"
#include "sim/shallow_records.hpp"
#include "sim/shallow_sides.hpp"
#include "sim/shallow_sweep.hpp"

namespace waterlight {

namespace {

/// Sweeps over rows on the CPU.
template <class Real>
class RowSolver final : public ShallowSolver<Real> {
  public:
    explicit RowSolver(const ShallowWaterSettings& s)
        : constants_(s),
          sides_(s.sides),
          frames_(s.grid, s.water.gravity_m_s2, constants_.film),
          start_(s.grid.nx, s.grid.ny),
          now_(s.grid.nx, s.grid.ny),
          change_(s.grid.nx, s.grid.ny),
          sweep_(s.grid.nx, s.grid.ny, std::holds_alternative<PeriodicSide>(s.sides.west),
                 std::holds_alternative<PeriodicSide>(s.sides.south)) {
        set_start(s, start_, now_);
        frames_.fill(side_demands(sides_, {0, 0, 0}), start_);
        if (s.keep_records) records_ = empty_records(s.grid.nx, s.grid.ny);
    }

    const ShallowStart<Real>& start() const override { return start_; }
    ShallowFields<Real>& fields() override { return now_; }

    ShallowPeak look(double time_s) override {
        return with_sides(time_s, sweep_.look(constants_.stage<Real>(0), start_, change_, now_));
    }

    ShallowPeak step(double time_s, double dt) override {
        const double end_s = time_s + dt;
        const SideDemands first = side_demands(sides_, {time_s, time_s, end_s});
        const SideDemands second = side_demands(sides_, {end_s, time_s, end_s});
        ShallowStage<Real> stage = constants_.stage<Real>(dt);
        if (stage.friction > 0) sweep_.rub(stage, start_, change_, now_);
        if (stage.friction > 0 || has_series(sides_)) frames_.fill(first, start_, now_);
        stage.gates = gates_of(first);
        sweep_.first_stage(stage, start_, now_, change_);
        frames_.fill(second, start_, now_, change_);
        stage.gates = gates_of(second);
        return with_sides(end_s, sweep_.second_stage(stage, start_, change_, now_));
    }

    void record(double time_s) override { add_records(constants_, start_, now_, time_s, records_); }
    const ShallowRecords& records() override { return records_; }

    void exchange_state(StateArchive& state) override {
        for (FramedRows<Real>* rows : {&now_.rise, &now_.qx, &now_.qy}) state.values(rows->values());
        sweep_.exchange_state(state);
        for (Field<float>* field : {&records_.max_elevation_m, &records_.max_speed_m_s, &records_.arrival_s})
            state.values(field->values());
    }

  private:
    ShallowPeak with_sides(double time_s, ShallowPeak inside) {
        const double rate = frames_.fill(side_demands(sides_, {time_s, time_s, time_s}), start_, now_);
        return {std::max(inside.rate, rate), inside.finite && std::isfinite(rate)};
    }

    ShallowConstants constants_;
    ShallowSides sides_;
    ShallowFrames<Real> frames_;
    ShallowStart<Real> start_;
    ShallowFields<Real> now_, change_;
    ShallowSweep<Real> sweep_;
    ShallowRecords records_;
};

}  // namespace

template <class Real>
std::unique_ptr<ShallowWaterModel> make_shallow_water(const ShallowWaterSettings& settings) {
    check_shallow(settings);
    return std::make_unique<ShallowModel<Real>>(settings, std::make_unique<RowSolver<Real>>(settings));
}

template std::unique_ptr<ShallowWaterModel> make_shallow_water<float>(const ShallowWaterSettings&);
template std::unique_ptr<ShallowWaterModel> make_shallow_water<double>(const ShallowWaterSettings&);

}  // namespace waterlight
