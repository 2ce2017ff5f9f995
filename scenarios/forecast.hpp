// What each rung of the ladder would make of a scene: its error by terms, the grid it needs, what it costs.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "scenarios/scene_spectrum.hpp"

namespace waterlight {

/// Errors are shifts, fractions of a wavelength (sim/wave_terms.hpp).
struct Forecast {
    ModelChoice model = ModelChoice::airy;
    bool allowed = true;
    std::string refusal;          ///< the key of the scenario that the model cannot carry
    double dispersion_error = 0;  ///< of all waves having one speed
    double amplitude_error = 0;   ///< of waves having the speed and form of small ones
    double model_error = 0;       ///< of both together: of the equations
    double grid_error = 0;        ///< of the scheme, and of lines between cells in place of the surface
    glm::ivec2 cells{1, 1};
    double step_s = 0;   ///< 0: as long as a frame
    double steps = 0;    ///< of the whole run
    double seconds = 0;  ///< of the waves, whole run
    double bytes = 0;    ///< of the whole run

    double error() const;
    /// "dispersion", "amplitude" or "the grid": the largest.
    const char* binding() const;
};

/// Frames of the run.
double frames_of_run(const Scenario& scenario);
/// Frames of the run, and rows of probes between them.
double moments_of_run(const Scenario& scenario);

/// What the light asks of cells: their size (m) at most; infinity where there is no light.
struct GridNeeds {
    double tolerance = 0.02;
    double light_cell_m = 0;
};

/// The forecast of one model: with the scenario's cells where it states them, else with the fewest square cells that
/// keep the whole error within the tolerance, or half of it for the grid where the model alone is beyond.
Forecast forecast(const Scenario& scenario, const SceneSpectrum& scene, ModelChoice model, const GridNeeds& needs);

}  // namespace waterlight
