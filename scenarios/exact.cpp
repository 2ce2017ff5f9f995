#include "scenarios/exact.hpp"

#include <cassert>
#include <cmath>

#include "scenarios/build_shallow.hpp"
#include "scenarios/resolve.hpp"
#include "sim/airy_dispersion.hpp"
#include "sim/shallow_initial.hpp"

namespace waterlight {

namespace {

/// Waves that pass through each other and the sides unchanged, and nothing else.
bool is_of_free_waves(const Scenario& s) {
    const WavesSection& w = s.waves;
    const ModelChoice model = resolve_model(s).model;
    const Boundary sides = resolve_boundary(s);
    const bool absorbs = sides.x == Side::absorbing || sides.y == Side::absorbing;
    const bool repeats = sides.x == Side::periodic && sides.y == Side::periodic;
    if (model != ModelChoice::airy && model != ModelChoice::linear) return false;
    if (w.spectrum || w.buoy || !w.sources.empty() || absorbs) return false;
    return w.sines.empty() ? !w.standing.empty() : repeats;
}

/// Angular frequency (rad/s) at wave number k by the model's equation.
double omega_of(const Scenario& s, double k) {
    if (resolve_model(s).model == ModelChoice::airy) return airy_omega(k, s.water);
    return k * std::sqrt(s.water.gravity_m_s2 * s.water.depth_m);
}

double length(glm::dvec2 v) { return std::hypot(v.x, v.y); }

SurfacePoint waves_at(const Scenario& s, const Grid& grid, glm::dvec2 at_m, double time_s) {
    SurfacePoint sum;
    const auto add = [&sum](const SurfacePoint& p) {
        sum.elevation_m += p.elevation_m;
        sum.slope += p.slope;
    };
    for (const Sine& sine : s.waves.sines) add(evaluate(sine, omega_of(s, length(wave_vector(sine))), at_m, time_s));
    for (const StandingWave& wave : s.waves.standing)
        add(evaluate(wave, grid, omega_of(s, length(wave_vector(wave, grid))), at_m, time_s));
    return sum;
}

bool is_exact_start(const Scenario& s) {
    return !s.waves.initial.empty() && std::holds_alternative<ExactStart>(s.waves.initial.front());
}

}  // namespace

bool has_exact(const Scenario& scenario, std::string_view field) {
    if (field == "surface.depth") return is_exact_start(scenario);
    const bool is_wave = field == "surface.elevation" || field.starts_with("surface.slope_");
    return is_wave && is_of_free_waves(scenario);
}

Field<double> exact_field(const Scenario& scenario, std::string_view field, double time_s) {
    assert(has_exact(scenario, field));
    if (field == "surface.depth") return *exact_depth(scenario, time_s);
    const Grid grid = grid_of(scenario);
    Field<double> exact(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const SurfacePoint p = waves_at(scenario, grid, {grid.x_m(i), grid.y_m(j)}, time_s);
            exact(i, j) = field == "surface.elevation" ? p.elevation_m
                          : field == "surface.slope_x" ? p.slope.x
                                                       : p.slope.y;
        }
    return exact;
}

}  // namespace waterlight
