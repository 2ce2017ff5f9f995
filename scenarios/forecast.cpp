#include "scenarios/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "scenarios/costs.hpp"
#include "scenarios/memory.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

using std::numbers::pi;
constexpr int most_cells = 16384;  // along a side
constexpr int least_cells = 4;

using ErrorOfWave = std::function<double(const WaveTrain&)>;

/// Root mean square over the waves, each by its share in the elevation.
double mean_error(const SceneSpectrum& scene, const ErrorOfWave& error) {
    double sum = 0;
    for (const SceneWave& wave : scene.waves) {
        const double one = error(wave.train);
        sum += wave.variance_m2 * one * one;
    }
    const double all = scene.variance_m2();
    return all > 0 ? std::sqrt(sum / all) : 0;
}

/// Of straight lines between cells in place of a sine: (k dx)^2 / sqrt(120) of its root mean square.
double between_cells(const WaveTrain& wave, double dx) {
    const double kdx = wave.wave_number * dx;
    return std::min(kdx * kdx / std::sqrt(120.0) / (2 * pi), largest_shift);
}

double cfl_of(const Scenario& s, ModelChoice model) {
    return s.waves.cfl.value_or(model == ModelChoice::linear ? 0.9 : 0.8);
}

/// Of the fronts, shores and vortices that a shallow-water run starts from.
double feature_error(const SceneSpectrum& scene, double dx) {
    double sum = 0;
    for (const Feature& feature : scene.features)
        sum = std::hypot(sum, feature.factor * std::pow(dx / feature.length_m, feature.order));
    return std::min(sum, largest_shift);
}

double grid_error(const Scenario& s, const SceneSpectrum& scene, ModelChoice model, double dx) {
    const double drawn = mean_error(scene, [dx](const WaveTrain& w) { return between_cells(w, dx); });
    if (model == ModelChoice::linear) {
        const double courant = cfl_of(s, model) / std::numbers::sqrt2;
        return std::hypot(drawn, mean_error(scene, [&](const WaveTrain& w) {
                              return shift_error(w.wavelengths * leapfrog_lag(w.wave_number, dx, courant));
                          }));
    }
    if (model != ModelChoice::shallow_water) return drawn;
    const double diffusion =
        mean_error(scene, [&](const WaveTrain& w) { return finite_volume_error(w.wave_number, dx, w.wavelengths); });
    return std::hypot(drawn, std::hypot(diffusion, feature_error(scene, dx)));
}

/// Bores, and states that are exact in shallow water, steepen no further and have no form that dispersion would keep.
double model_error(const SceneSpectrum& scene, ModelChoice model, const Water& water) {
    return mean_error(scene, [&](const WaveTrain& wave) {
        if (model == ModelChoice::airy) return linear_error(wave, 0, water);
        const double excess = long_wave_excess(wave.wave_number, water);
        if (model == ModelChoice::linear) return linear_error(wave, excess, water);
        return scene.jump_m > 0 ? shift_error(wave.wavelengths * excess) : shallow_error(wave, water);
    });
}

/// The largest cell that meets the target; errors grow with the cell.
double largest_cell(const std::function<double(double)>& error, double target, double longest_m) {
    double low = longest_m / most_cells, high = longest_m / least_cells;
    if (error(high) <= target) return high;
    constexpr int halvings = 30;
    for (int i = 0; i < halvings; ++i) {
        const double middle = std::sqrt(low * high);
        (error(middle) <= target ? low : high) = middle;
    }
    return low;
}

/// At least n, a product of 2, 3 and 5, even: what transforms well.
int smooth_count(int n) {
    for (int even = n + n % 2;; even += 2) {
        int rest = even;
        for (const int prime : {2, 3, 5})
            while (rest % prime == 0) rest /= prime;
        if (rest == 1) return even;
    }
}

/// The largest cell on which every stated wave can be told: the models refuse two cells a wave and fewer.
double cell_of_waves(const Scenario& s) {
    constexpr double cells_a_wave = 2.5;
    double shortest = std::numeric_limits<double>::infinity();
    for (const Sine& sine : s.waves.sines) shortest = std::min(shortest, sine.wavelength_m);
    for (const StandingWave& wave : s.waves.standing) {
        if (wave.half_waves_x > 0) shortest = std::min(shortest, 2 * s.domain.size_m.x / wave.half_waves_x);
        if (wave.half_waves_y > 0) shortest = std::min(shortest, 2 * s.domain.size_m.y / wave.half_waves_y);
    }
    return shortest / cells_a_wave;
}

glm::ivec2 cells_of(glm::dvec2 size_m, double cell_m) {
    const auto along = [cell_m](double length) {
        const double n = std::ceil(length / cell_m - 1e-9);
        return smooth_count(static_cast<int>(std::clamp<double>(n, least_cells, most_cells)));
    };
    return {along(size_m.x), along(size_m.y)};
}

double tank_cells(const Scenario& s, glm::ivec2 cells, ModelChoice model) {
    const Boundary sides = resolve_boundary(s);
    const bool margins = model == ModelChoice::linear || model == ModelChoice::airy;
    // A hidden margin of a quarter of the domain on each side.
    const double x = margins && sides.x == Side::absorbing ? 1.5 : 1,
                 y = margins && sides.y == Side::absorbing ? 1.5 : 1;
    return x * y * cells.x * static_cast<double>(cells.y);
}

void add_cost(const Scenario& s, const SceneSpectrum& scene, Forecast& f) {
    const double dx = s.domain.size_m.x / f.cells.x, dy = s.domain.size_m.y / f.cells.y;
    const double n = tank_cells(s, f.cells, f.model), frames = moments_of_run(s), duration = s.waves.duration_s;
    const double g = s.water.gravity_m_s2, amplitude = std::max(scene.amplitude_m(), scene.jump_m);
    if (f.model == ModelChoice::linear)
        f.step_s = cfl_of(s, f.model) / (std::sqrt(g * s.domain.depth_m) * std::sqrt(1 / (dx * dx) + 1 / (dy * dy)));
    if (f.model == ModelChoice::shallow_water) {
        const double c = std::sqrt(g * (s.domain.depth_m + amplitude)), u = amplitude * g / c;
        f.step_s = cfl_of(s, f.model) / ((c + u) / dx + c / dy);
    }
    // Frames of the model linear may end between two steps, those of shallow-water take one at least.
    f.steps = f.step_s > 0 ? std::ceil(duration / f.step_s) : frames;
    if (f.model == ModelChoice::shallow_water) f.steps = std::max(f.steps, frames - 1);
    using namespace costs;
    switch (f.model) {
        case ModelChoice::linear:
            f.seconds =
                f.steps * (linear_step + n * linear_cell_step) + frames * (linear_frame + n * surface_cell_frame);
            break;
        case ModelChoice::shallow_water:
            f.seconds = f.steps * (shallow_step + n * shallow_cell_step) + frames * n * surface_cell_frame;
            break;
        case ModelChoice::prescribed:
            f.seconds =
                frames * n * prescribed_cell_wave_frame * std::max<double>(1, static_cast<double>(scene.waves.size()));
            break;
        default:
            f.seconds = frames * (airy_frame + n * airy_cell_frame);
    }
    Scenario sized = s;
    sized.waves.model = f.model;
    sized.domain.cells = f.cells;
    f.bytes = estimate_memory(sized).total();
}

}  // namespace

double Forecast::error() const { return std::hypot(model_error, grid_error); }

const char* Forecast::binding() const {
    if (grid_error >= std::max(dispersion_error, amplitude_error)) return "the grid";
    return dispersion_error > amplitude_error ? "dispersion" : "amplitude";
}

double frames_of_run(const Scenario& scenario) {
    return 1 + std::ceil(scenario.waves.duration_s / scenario.output.every_s - 1e-9);
}

double moments_of_run(const Scenario& scenario) {
    const double every = scenario.probes.empty() ? scenario.output.every_s
                                                 : scenario.output.probe_every_s.value_or(scenario.output.every_s);
    return 1 + std::ceil(scenario.waves.duration_s / every - 1e-9);
}

Forecast forecast(const Scenario& scenario, const SceneSpectrum& scene, ModelChoice model, const GridNeeds& needs) {
    const Water& water = scenario.water;
    Forecast f;
    f.model = model;
    if (model == ModelChoice::linear || model == ModelChoice::shallow_water)
        f.dispersion_error = mean_error(scene, [&](const WaveTrain& w) {
            return shift_error(w.wavelengths * long_wave_excess(w.wave_number, water));
        });
    if (model == ModelChoice::linear || model == ModelChoice::airy)
        f.amplitude_error = mean_error(scene, [&](const WaveTrain& w) { return linear_error(w, 0, water); });
    if (model != ModelChoice::prescribed) f.model_error = model_error(scene, model, water);
    const auto error = [&](double dx) { return grid_error(scenario, scene, model, dx); };
    const glm::dvec2 size = scenario.domain.size_m;
    if (scenario.domain.cells.x > 0) {
        f.cells = scenario.domain.cells;
    } else {
        const double left = std::sqrt(std::max(needs.tolerance * needs.tolerance - f.model_error * f.model_error, 0.0));
        constexpr double kept = 0.9;  // of what is left, for the grid
        const double target = kept * std::max(left, 0.5 * needs.tolerance);
        const double cell = largest_cell(error, target, std::max(size.x, size.y));
        f.cells = cells_of(size, std::min({cell, needs.light_cell_m, cell_of_waves(scenario)}));
    }
    // Where the scenario has cells that are not square, its waves run along the fine ones.
    f.grid_error = error(std::min(size.x / f.cells.x, size.y / f.cells.y));
    add_cost(scenario, scene, f);
    return f;
}

}  // namespace waterlight
