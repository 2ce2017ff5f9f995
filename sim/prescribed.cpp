#include "sim/prescribed.hpp"

#include <algorithm>
#include <cassert>

#include "sim/error.hpp"
#include "sim/kernels/linear.hpp"
#include "sim/prescribed_file.hpp"
#include "sim/prescribed_formula.hpp"
#include "sim/surface_sums.hpp"

namespace waterlight {

namespace {

// What both kinds share: a clock and a surface made when it is asked for.
class Prescribed : public PrescribedModel {
  public:
    explicit Prescribed(const PrescribedSettings& settings) : surface_(settings.grid, settings.boundary) {
        surface_.tilt = settings.slope;
    }

    std::string_view name() const override { return "prescribed"; }
    void advance(double frame_s) override {
        assert(frame_s >= 0);
        if (frame_s == 0) return;
        time_s_ += frame_s;
        ++steps_;
        surface_is_new_ = false;
    }
    void disturb(std::span<const Disturbance>) override { refuse_disturbance(); }
    void set_rain(std::span<const Rain> rain) override {
        if (!rain.empty()) refuse_disturbance();
    }
    const Surface& surface() override {
        if (!surface_is_new_) {
            surface_.time_s = time_s_;
            set_surface(surface_);
            surface_is_new_ = true;
        }
        return surface_;
    }
    WaveDiagnostics diagnostics() override { return surface_sums(surface()); }
    std::int64_t steps() const override { return steps_; }
    void exchange_state(StateArchive& state) override {
        state.value(time_s_);
        state.value(steps_);
        surface_is_new_ = surface_is_new_ && !state.restores();
    }

  private:
    [[noreturn]] static void refuse_disturbance() { throw InputError("a prescribed surface cannot be disturbed"); }
    // Sets elevation and slopes at surface.time_s.
    virtual void set_surface(Surface& surface) = 0;

    Surface surface_;
    double time_s_ = 0;
    std::int64_t steps_ = 0;
    bool surface_is_new_ = false;
};

class FormulaModel final : public Prescribed {
  public:
    explicit FormulaModel(const PrescribedSettings& settings) : Prescribed(settings), formula_(settings) {}
    const SurfaceFormula* formula() const override { return &formula_; }

  private:
    void set_surface(Surface& surface) override { formula_.evaluate_on(surface, surface.time_s); }

    SumFormula formula_;
};

// The neighbour of index n of `count`: wrapped, mirrored, or -1 for still water.
int neighbour(int n, int count, Side side) {
    if (n >= 0 && n < count) return n;
    if (side == Side::periodic) return (n + count) % count;
    return side == Side::wall ? std::clamp(n, 0, count - 1) : -1;
}

// Central differences of the elevation, respecting the sides.
void set_slopes(Surface& surface) {
    const Grid& grid = surface.grid;
    const Field<float>& eta = surface.elevation;
    const auto value = [&](int i, int j) { return i < 0 || j < 0 ? 0.0f : eta(i, j); };
    const auto dx = static_cast<float>(grid.dx_m);
    const auto dy = static_cast<float>(grid.dy_m);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < grid.ny; ++j) {
        const int south = neighbour(j - 1, grid.ny, surface.boundary.y);
        const int north = neighbour(j + 1, grid.ny, surface.boundary.y);
        for (int i = 0; i < grid.nx; ++i) {
            const int west = neighbour(i - 1, grid.nx, surface.boundary.x);
            const int east = neighbour(i + 1, grid.nx, surface.boundary.x);
            surface.slope_x(i, j) = f32::central_slope(value(west, j), value(east, j), dx);
            surface.slope_y(i, j) = f32::central_slope(value(i, south), value(i, north), dy);
        }
    }
}

void add_tilt(Surface& surface) {
    const Grid& grid = surface.grid;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            surface.elevation(i, j) += static_cast<float>(surface.tilt.x * grid.x_m(i) + surface.tilt.y * grid.y_m(j));
            surface.slope_x(i, j) += static_cast<float>(surface.tilt.x);
            surface.slope_y(i, j) += static_cast<float>(surface.tilt.y);
        }
    }
}

class FileModel final : public Prescribed {
  public:
    explicit FileModel(const PrescribedSettings& settings)
        : Prescribed(settings), series_(*settings.file, settings.grid, settings.boundary) {}
    const SurfaceFormula* formula() const override { return nullptr; }

  private:
    void set_surface(Surface& surface) override {
        series_.elevation_at(surface.time_s, surface.elevation);
        set_slopes(surface);
        add_tilt(surface);
    }

    FileSeries series_;
};

}  // namespace

std::unique_ptr<PrescribedModel> make_prescribed(const PrescribedSettings& settings) {
    if (!settings.file) return std::make_unique<FormulaModel>(settings);
    if (!settings.sines.empty() || settings.gerstner) {
        throw InputError("prescribed: a file stands instead of sines and Gerstner waves, not beside them");
    }
    return std::make_unique<FileModel>(settings);
}

}  // namespace waterlight
