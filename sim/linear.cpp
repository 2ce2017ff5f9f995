#include "sim/linear.hpp"

#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "sim/kernels/linear.hpp"
#include "sim/linear_energy.hpp"
#include "sim/linear_initial.hpp"
#include "sim/linear_sweep.hpp"
#include "sim/sponge.hpp"
#include "sim/surface_sums.hpp"

namespace waterlight {

namespace {

// The sponge along one axis: none unless its sides absorb.
Sponge sponge_of(const LinearSettings& settings, Side side, double domain_m, double cell_m, double speed) {
    if (side != Side::absorbing) return {};
    return make_sponge(settings.sponge_m, domain_m, cell_m, speed);
}

Grid with_margins(const Grid& grid, int margin_x, int margin_y) {
    Grid wide = grid;
    wide.nx += 2 * margin_x;
    wide.ny += 2 * margin_y;
    wide.x0_m -= margin_x * grid.dx_m;
    wide.y0_m -= margin_y * grid.dy_m;
    return wide;
}

template <class Real>
LinearInflow<Real> make_inflow(const Wavemaker& maker, const LinearSettings& settings, const Grid& grid, double speed) {
    const double k = 2 * std::numbers::pi / (maker.period_s * speed);
    const Field<double> shape = inflow_shape(carried_on(maker, settings.grid), grid, k, speed);
    LinearInflow<Real> inflow{PaddedRows<Real>(grid.nx, grid.ny), {}, {}};
    for (int j = 0; j < grid.ny; ++j) {
        Real* to = inflow.shape.row(j);
        int begin = grid.nx;
        int end = 0;
        for (int i = 0; i < grid.nx; ++i) {
            // Far from the line the shape underflows; such numbers would only slow the loop down.
            to[i] = std::abs(shape(i, j)) < 1e-30 ? Real(0) : static_cast<Real>(shape(i, j));
            if (to[i] == 0) continue;
            begin = std::min(begin, i);
            end = i + 1;
        }
        inflow.begin.push_back(begin);
        inflow.end.push_back(end);
    }
    return inflow;
}

template <class Real>
class Leapfrog final : public LinearModel<Real> {
  public:
    explicit Leapfrog(const LinearSettings& settings);

    std::string_view name() const override { return "linear"; }
    void advance(double frame_s) override;
    void disturb(std::span<const Disturbance> disturbances) override;
    void set_rain(std::span<const Rain> rain) override { replace_rain(settings_.sources, rain); }
    const Surface& surface() override;
    WaveDiagnostics diagnostics() override;
    std::int64_t steps() const override { return steps_; }
    Real elevation_m(int i, int j) const override { return shown().row(j + sponge_y_.cells)[i + sponge_x_.cells]; }
    double step_s() const override { return dt_; }
    void exchange_state(StateArchive& state) override;

  private:
    // What disturbs the water, and the step before which it does.
    struct Fall {
        std::int64_t step;
        Disturbance what;
    };

    double time_of(std::int64_t step) const { return static_cast<double>(step) * dt_; }
    double step_for(double frame_s) const;
    std::vector<Fall> falls_until(std::int64_t last) const;
    void let_fall(const Disturbance& what);
    LinearDecay<Real> decay_over(double duration_s) const;
    LinearStep<Real> step_of(double duration_s, const LinearDecay<Real>& decay) const;
    double kick_duration(double step_s) const { return 0.5 * (step_s + (steps_ == 0 ? 0 : dt_)); }
    void take_steps(std::int64_t last);
    void part_step(double part_s);
    const PaddedRows<Real>& shown() const { return between_ ? part_elevation_ : elevation_; }

    LinearSettings settings_;
    double speed_;
    Sponge sponge_x_;
    Sponge sponge_y_;
    Grid grid_;  // with the sponges
    std::vector<Wavemaker> makers_;
    std::vector<LinearInflow<Real>> inflows_;  // one for each maker
    PaddedRows<Real> elevation_;               // after steps_ steps
    PaddedRows<Real> rate_;                    // half a step before; at the same time before the first
    PaddedRows<Real> still_;                   // one row
    LinearSweep<Real> sweep_;
    double dt_;
    std::int64_t steps_ = 0;
    double time_s_ = 0;
    std::vector<Fall> waiting_;  // for the next step, since the frame ended between two
    bool between_ = false;       // the frame ended between two steps, with part_elevation_
    PaddedRows<Real> part_elevation_;
    PaddedRows<Real> part_rate_;
    Surface surface_;
    bool surface_is_new_ = false;
};

template <class Real>
Leapfrog<Real>::Leapfrog(const LinearSettings& settings)
    : settings_(settings),
      speed_(f64::long_wave_speed(settings.water.gravity_m_s2, settings.water.depth_m)),
      sponge_x_(sponge_of(settings, settings.boundary.x, settings.grid.width_m(), settings.grid.dx_m, speed_)),
      sponge_y_(sponge_of(settings, settings.boundary.y, settings.grid.height_m(), settings.grid.dy_m, speed_)),
      grid_(with_margins(settings.grid, sponge_x_.cells, sponge_y_.cells)),
      elevation_(grid_.nx, grid_.ny),
      rate_(grid_.nx, grid_.ny),
      still_(grid_.nx, 1),
      sweep_(grid_.nx, grid_.ny, settings.boundary, omp_get_max_threads()),
      dt_(settings.cfl / f64::leapfrog_courant(speed_, 1, grid_.dx_m, grid_.dy_m)),
      surface_(settings.grid, settings.boundary) {
    set_linear_elevation(settings_, grid_, elevation_);
    set_linear_rate(settings_, grid_, dt_, rate_);
    for (const Source& source : settings.sources) {
        if (const auto* maker = std::get_if<Wavemaker>(&source)) {
            makers_.push_back(*maker);
            inflows_.push_back(make_inflow<Real>(*maker, settings, grid_, speed_));
        } else if (const auto* drop = std::get_if<Drop>(&source); drop && drop->time_s == 0) {
            let_fall(*drop);
        }
    }
}

// The longest step that the first frame is a multiple or a whole part of.
template <class Real>
double Leapfrog<Real>::step_for(double frame_s) const {
    const double longest = dt_ * (1 + 1e-12);
    return frame_s >= longest ? frame_s / std::ceil(frame_s / longest) : frame_s * std::floor(longest / frame_s);
}

template <class Real>
void Leapfrog<Real>::advance(double frame_s) {
    assert(frame_s >= 0);
    if (frame_s == 0) return;
    if (time_s_ == 0) {
        dt_ = step_for(frame_s);
        // Only now is it known with which steps sines travel.
        if (!settings_.sines.empty()) set_linear_rate(settings_, grid_, dt_, rate_);
    }
    time_s_ += frame_s;
    take_steps(static_cast<std::int64_t>(std::floor(time_s_ / dt_ + 1e-7)));
    between_ = time_s_ - time_of(steps_) > 2e-7 * dt_;
    if (between_) part_step(time_s_ - time_of(steps_));
    surface_is_new_ = false;
}

// What waits, and the drops from now until step `last`, each at the first step at or after its time. What is added to
// the elevation at a step acts as if it had come half a step before, so that drops are in time on average.
template <class Real>
std::vector<typename Leapfrog<Real>::Fall> Leapfrog<Real>::falls_until(std::int64_t last) const {
    const double begin = time_of(steps_);
    const double end = time_of(last);
    std::vector<Fall> found = waiting_;
    const auto add = [&](const Drop& drop) {
        const auto step = static_cast<std::int64_t>(std::ceil(drop.time_s / dt_ - 1e-9));
        found.push_back({std::clamp(step, steps_, last), drop});
    };
    for (const Source& source : settings_.sources) {
        if (const auto* drop = std::get_if<Drop>(&source)) {
            if (drop->time_s > begin && drop->time_s <= end) add(*drop);
        } else if (const auto* rain = std::get_if<Rain>(&source)) {
            for (const Drop& each : drops_of(*rain, settings_.grid, begin, end)) add(each);
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const Fall& a, const Fall& b) { return a.step < b.step; });
    return found;
}

template <class Real>
void Leapfrog<Real>::let_fall(const Disturbance& what) {
    const DropPatch patch = patch_of(what, grid_, settings_.boundary);
    for (int j = 0; j < patch.elevation_m.ny(); ++j) {
        Real* eta = elevation_.row(patch.j0 + j);
        const double* gain = patch.elevation_m.row(j);
        for (int i = 0; i < patch.elevation_m.nx(); ++i) {
            eta[patch.i0 + i] = static_cast<Real>(eta[patch.i0 + i] + gain[i]);
        }
        set_ghosts(eta, grid_.nx, settings_.boundary.x);
    }
}

template <class Real>
void Leapfrog<Real>::disturb(std::span<const Disturbance> disturbances) {
    for (const Disturbance& d : disturbances) require_valid(d);
    for (const Disturbance& d : disturbances) {
        if (between_)
            waiting_.push_back({steps_ + 1, d});
        else
            let_fall(d);
    }
    surface_is_new_ = false;
}

template <class Real>
LinearDecay<Real> Leapfrog<Real>::decay_over(double duration_s) const {
    const std::vector<double> x = sponge_decay(sponge_x_, settings_.grid.nx, duration_s);
    const std::vector<double> y = sponge_decay(sponge_y_, settings_.grid.ny, duration_s);
    return {{x.begin(), x.end()}, {y.begin(), y.end()}, sponge_x_.cells};
}

// The step that follows on steps_, of `duration_s`: its kick brings the rate from half a step before now, or from now
// if it is the first, to the middle of the step. `decay` is over that time.
template <class Real>
LinearStep<Real> Leapfrog<Real>::step_of(double duration_s, const LinearDecay<Real>& decay) const {
    const double c2_dt = speed_ * speed_ * kick_duration(duration_s);
    LinearStep<Real> step{static_cast<Real>(duration_s),
                          static_cast<Real>(c2_dt / (grid_.dx_m * grid_.dx_m)),
                          static_cast<Real>(c2_dt / (grid_.dy_m * grid_.dy_m)),
                          &decay,
                          {}};
    for (const Wavemaker& maker : makers_) {
        step.signals.push_back(static_cast<Real>(inflow_signal(maker, time_of(steps_) + 0.5 * duration_s)));
    }
    return step;
}

template <class Real>
void Leapfrog<Real>::take_steps(std::int64_t last) {
    if (last <= steps_) return;
    const LinearDecay<Real> first_decay = decay_over(kick_duration(dt_));
    const LinearDecay<Real> decay = decay_over(dt_);
    const std::vector<Fall> falls = falls_until(last);
    waiting_.clear();
    auto next = falls.begin();
    std::vector<LinearStep<Real>> pass;
    while (true) {
        for (; next != falls.end() && next->step == steps_; ++next) let_fall(next->what);
        if (steps_ == last) return;
        // As many steps as one pass holds, until the next drop.
        const std::int64_t stop = next == falls.end() ? last : next->step;
        const std::int64_t pass_end = std::min<std::int64_t>(stop, steps_ + sweep_.depth());
        pass.clear();
        for (; steps_ < pass_end; ++steps_) pass.push_back(step_of(dt_, steps_ == 0 ? first_decay : decay));
        sweep_.run(elevation_, rate_, pass, inflows_);
    }
}

// Leaves in part_elevation_ and part_rate_ the elevation part_s after the last step, 0 <= part_s < dt, and the rate in
// the middle of that time.
template <class Real>
void Leapfrog<Real>::part_step(double part_s) {
    if (part_elevation_.ny() == 0) {
        part_elevation_ = PaddedRows<Real>(grid_.nx, grid_.ny);
        part_rate_ = PaddedRows<Real>(grid_.nx, grid_.ny);
    }
    part_elevation_.copy(elevation_);
    part_rate_.copy(rate_);
    const LinearDecay<Real> decay = decay_over(kick_duration(part_s));
    const LinearStep<Real> step = step_of(part_s, decay);
    sweep_.run(part_elevation_, part_rate_, {&step, 1}, inflows_);
}

template <class Real>
const Surface& Leapfrog<Real>::surface() {
    if (surface_is_new_) return surface_;
    surface_.time_s = time_s_;
    const int nx = settings_.grid.nx;
    const int lead = sponge_x_.cells;
    const Real dx = static_cast<Real>(grid_.dx_m);
    const Real dy = static_cast<Real>(grid_.dy_m);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < settings_.grid.ny; ++j) {
        const int row = j + sponge_y_.cells;
        const Side side = settings_.boundary.y;
        const Real* __restrict eta = shown().row(row) + lead;
        const Real* __restrict south = neighbour_row(shown(), row, -1, side, still_.row(0)) + lead;
        const Real* __restrict north = neighbour_row(shown(), row, 1, side, still_.row(0)) + lead;
        float* __restrict elevation = surface_.elevation.row(j);
        float* __restrict slope_x = surface_.slope_x.row(j);
        float* __restrict slope_y = surface_.slope_y.row(j);
#pragma GCC ivdep
        for (int i = 0; i < nx; ++i) {
            using f32::central_slope;
            using f64::central_slope;
            elevation[i] = static_cast<float>(eta[i]);
            slope_x[i] = static_cast<float>(central_slope(eta[i - 1], eta[i + 1], dx));
            slope_y[i] = static_cast<float>(central_slope(south[i], north[i], dy));
        }
    }
    surface_is_new_ = true;
    return surface_;
}

template <class Real>
WaveDiagnostics Leapfrog<Real>::diagnostics() {
    WaveDiagnostics diagnostics = surface_sums(surface());
    // A step of no length brings the rate to the time of the elevation. What it spoils is made again.
    part_step(0);
    LinearState state{grid_, settings_.boundary, settings_.water, dt_, {}, {}};
    state.elevation_m = Field<double>(grid_.nx, grid_.ny);
    state.rate_m_s = Field<double>(grid_.nx, grid_.ny);
    for (int j = 0; j < grid_.ny; ++j) {
        std::copy_n(part_elevation_.row(j), grid_.nx, state.elevation_m.row(j));
        std::copy_n(part_rate_.row(j), grid_.nx, state.rate_m_s.row(j));
    }
    if (between_) part_step(time_s_ - time_of(steps_));
    diagnostics.energy_j = linear_energy(std::move(state));
    return diagnostics;
}

template <class Real>
void Leapfrog<Real>::exchange_state(StateArchive& state) {
    state.value(dt_);
    state.value(steps_);
    state.value(time_s_);
    state.value(between_);
    state.list(waiting_);
    state.values(elevation_.values());
    state.values(rate_.values());
    if (!state.restores()) return;
    if (between_) part_step(time_s_ - time_of(steps_));
    surface_is_new_ = false;
}

}  // namespace

template <class Real>
std::unique_ptr<LinearModel<Real>> make_linear(const LinearSettings& settings) {
    check_linear(settings);
    return std::make_unique<Leapfrog<Real>>(settings);
}

template std::unique_ptr<LinearModel<float>> make_linear<float>(const LinearSettings&);
template std::unique_ptr<LinearModel<double>> make_linear<double>(const LinearSettings&);

}  // namespace waterlight
