// Wave models against their exact solutions, by cells a wave, and what a second of water costs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/airy.hpp"
#include "sim/linear.hpp"
#include "sim/shallow_initial.hpp"
#include "sim/shallow_means.hpp"
#include "tests/bench/accuracy/report.hpp"
#include "tests/bench/seconds_of.hpp"
#include "tests/support/airy_runs.hpp"
#include "tests/support/linear_runs.hpp"

namespace waterlight::accuracy {

namespace {

constexpr Boundary walls{Side::wall, Side::wall};
constexpr int waves_a_side = 4;
constexpr double side_m = 2;

/// Two crossed standing waves: four waves along x, three along y.
const StandingWave wave{.01, 2 * waves_a_side, 6};

Field<double> exact_elevation(const Grid& grid, double omega, double time_s) {
    Field<double> all(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            all(i, j) = evaluate(wave, grid, omega, {grid.x_m(i), grid.y_m(j)}, time_s).elevation_m;
    return all;
}

/// Error of the surface over the amplitude's RMS, so that it is the same whenever the wave passes through zero.
double error_of(const Field<float>& elevation, const Grid& grid, double omega, double time_s) {
    Field<double> off = box_means(elevation, 1, 1);
    const Field<double> now = exact_elevation(grid, omega, time_s), crest = exact_elevation(grid, omega, 0);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) off(i, j) += crest(i, j) - now(i, j);
    return relative_rms(off, crest);
}

/// What a model did over some frames.
struct Run {
    double exact = 0;     ///< error against the continuous wave
    double discrete = 0;  ///< against the scheme's own relation; NaN where there is none
    double ms_a_second = 0;
};

/// Five and a quarter periods, when the wave passes through zero and its phase shows, in frames of some 1/60 s.
struct Frames {
    int count;
    double frame_s;
    explicit Frames(double omega) {
        const double end_s = 5.25 * 2 * std::numbers::pi / omega;
        count = static_cast<int>(std::lround(60 * end_s));
        frame_s = end_s / count;
    }
    double end_s() const { return count * frame_s; }
};

Run advance(WaveModel& model, const Grid& grid, double omega) {
    const Frames frames(omega);
    const double seconds = seconds_of([&] {
        for (int k = 0; k < frames.count; ++k) {
            model.advance(frames.frame_s);
            model.surface();
        }
    });
    return {error_of(model.surface().elevation, grid, omega, frames.end_s()), std::nan(""),
            1e3 * seconds / frames.end_s()};
}

Run linear(int cells) {
    LinearSettings s = testing::basin(cells * waves_a_side, cells * waves_a_side, side_m, side_m, walls);
    s.standing = {wave};
    const auto model = make_linear<float>(s);
    const glm::dvec2 k = wave_vector(wave, s.grid);
    const double omega = glm::length(k) * std::sqrt(s.water.gravity_m_s2 * s.water.depth_m);
    Run run = advance(*model, s.grid, omega);
    const double discrete = testing::leapfrog_frequency(k, s.grid, model->step_s());
    run.discrete = error_of(model->surface().elevation, s.grid, discrete, Frames(omega).end_s());
    return run;
}

Run airy(int cells) {
    const int n = cells * waves_a_side;
    AirySettings s = testing::tank(n, n, side_m, side_m, walls, 1);
    s.standing = {wave};
    return advance(*make_airy(s), s.grid, testing::textbook_omega(glm::length(wave_vector(wave, s.grid)), s.water));
}

void report_linear_waves(const Options& options, Choices& choices) {
    fmt::print(
        R"(
### `linear` and `airy`

A standing wave, four waves along x and three along y between walls, five and a quarter periods in frames of some 1/60 s: RMS
error of the elevation over the amplitude's RMS. `linear` against the wave equation and against its own discrete relation,
`airy` against the dispersion relation of textbooks. Costs are milliseconds for a second of water, surface and slopes of each
frame included.
)");
    print_heads({"cells a wave", "linear", "linear, discrete", "linear, ms/s", "airy", "airy, ms/s", "airy / linear"});
    std::vector<int> resolutions;
    std::vector<double> errors;
    for (int cells = 8; cells <= (options.quick ? 32 : 128); cells *= 2) {
        Run a = linear(cells), b = airy(cells);
        for (int again = 0; again < 256 / cells; ++again) {  // the fastest: what others do only adds
            a.ms_a_second = std::min(a.ms_a_second, linear(cells).ms_a_second);
            b.ms_a_second = std::min(b.ms_a_second, airy(cells).ms_a_second);
        }
        resolutions.push_back(cells);
        errors.push_back(a.exact);
        print_row({std::to_string(cells), percent(a.exact), percent(a.discrete), digits(a.ms_a_second),
                   percent(b.exact), digits(b.ms_a_second), digits(b.ms_a_second / a.ms_a_second)});
        choices.add("linear, standing wave (ms a second)", {fmt::format("{} cells", cells), a.exact, a.ms_a_second});
        choices.add("airy, standing wave (ms a second)", {fmt::format("{} cells", cells), b.exact, b.ms_a_second});
    }
    print_row({"order", fmt::format("{:.2f}", order_of(resolutions, errors)), "", "", "", "", ""});
}

void report_dispersion() {
    fmt::print(
        R"(
### Waves of one speed

How far `linear` and `shallow-water`, whose waves all travel with sqrt(g h), are from `airy` at a depth of kh, whatever
their grid:
)");
    print_heads({"kh", "speed too high by", "lead after 10 waves, of a wave"});
    for (const double kh : {.1, .2, .5, 1.0, 2.0}) {
        Water water;
        water.surface_tension_n_m = 0;
        const double omega = testing::textbook_omega(kh / water.depth_m, water);
        const double speed = omega / (kh / water.depth_m),
                     off = std::sqrt(water.gravity_m_s2 * water.depth_m) / speed - 1;
        print_row({fmt::format("{:g}", kh), percent(off), fmt::format("{:.2g}", 10 * off)});
    }
}

/// RMSE of depth over the RMS by which the water departs from still.
double error_of(const Field<double>& depth, const Field<double>& exact, const Field<double>& bed_m) {
    double off = 0, departure = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
        const double d = depth.data()[k] - exact.data()[k];
        const double e = exact.data()[k] - std::max(0.0, -bed_m.data()[k]);
        off += d * d;
        departure += e * e;
    }
    return std::sqrt(off / departure);
}

void exact_rows(const std::string& name, const ShallowExact& state, const ShallowSides& sides,
                const std::vector<Grid>& grids, double end_s, Choices& choices) {
    std::vector<int> resolutions;
    std::vector<double> errors;
    for (const Grid& grid : grids) {
        ShallowWaterSettings s;
        s.grid = grid;
        s.sides = sides;
        s.bed_m = bed_at_centres(state, grid);
        set_initial({ExactStart{state, 0}}, s);
        const auto model = make_shallow_water<float>(s);
        const double seconds = seconds_of([&] { model->advance(end_s); });
        Field<double> depth(grid.nx, grid.ny);
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) depth(i, j) = model->state(i, j).depth_m;
        resolutions.push_back(grid.nx);
        errors.push_back(error_of(depth, cell_means(state, grid, end_s).depth_m, s.bed_m));
        const double cost = 1e3 * seconds / end_s;
        print_row({name, fmt::format("{} x {}", grid.nx, grid.ny), percent(errors.back()), digits(cost)});
        choices.add(fmt::format("shallow-water, {} (ms a second)", name),
                    {fmt::format("{} x {} cells", grid.nx, grid.ny), errors.back(), cost});
    }
    print_row({name, "order", fmt::format("{:.2f}", order_of(resolutions, errors)), ""});
}

void report_shallow_water(const Options& options, Choices& choices) {
    fmt::print(
        R"(
### `shallow-water`

RMSE of depth, cell averages, over the RMS by which the water departs from still; single precision. More solutions, and
errors in L1, are in [shallow-water.md](shallow-water.md).
)");
    print_heads({"exact state", "cells", "RMSE", "ms/s"});
    const int finest = options.quick ? 64 : 256;
    std::vector<Grid> bowls, boxes;
    for (int n = 32; n <= finest; n *= 2) bowls.push_back(make_grid(n, n, 4, 4));
    for (int n = 32; n <= finest; n *= 2) boxes.push_back({n, n, 12.0 / n, 12.0 / n, -6, -6});
    const ThackerPlanar bowl;
    exact_rows("Thacker's bowl, one period", bowl, {}, bowls, bowl.period_s(), choices);
    exact_rows("travelling vortex, 2 s", TravellingVortex{},
               {PeriodicSide{}, PeriodicSide{}, PeriodicSide{}, PeriodicSide{}}, boxes, 2, choices);
}

}  // namespace

void report_waves(const Options& options, Choices& choices) {
    fmt::print("\n## Waves\n");
    report_linear_waves(options, choices);
    report_dispersion();
    report_shallow_water(options, choices);
}

}  // namespace waterlight::accuracy
