// Which physics a scene needs: the cheapest wave model, grid and map of light that meet the tolerance of [accuracy].
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/forecast.hpp"

namespace waterlight {

/// What the light below asks for. Lengths in m, contrasts relative to the mean irradiance.
struct LightDemand {
    double shortest_m = 0;       ///< of the waves whose contrast on the floor is above the tolerance; 0: none is
    double contrast = 0;         ///< of the wave with the most
    double strongest_m = 0;      ///< the length of that wave
    double focus_m = 0;          ///< depth of its first focus; infinity without waves
    glm::dvec2 reach_m{0, 0};    ///< how far along the map's axes the steepest slopes throw their light
    double spread = 0;           ///< by how much the widest footprint exceeds its sample, in samples
    double footprint_error = 0;  ///< RMSE of the floor map by its method, relative; the contrast at most
    double pixel_error = 0;      ///< the same, were it the pixel-wide one
    glm::ivec2 pixels{0, 0};     ///< of the floor map, as stated or chosen
    glm::ivec2 window{0, 0};     ///< samples and channels that hold reach_m
    glm::ivec2 beams{0, 0};      ///< of the beam grid, as stated or chosen
    double seconds = 0;          ///< of all of it, whole run
    FloorMethod method = FloorMethod::two_pass;
};

/// Why the waves of a scene are beyond every model.
enum class Beyond { nothing, breaking, dispersive_and_nonlinear, bores_in_deep_water };

struct Decision {
    SceneSpectrum scene;
    double tolerance = 0;
    std::vector<Forecast> rungs;  ///< linear, airy, shallow-water; or prescribed alone
    std::size_t chosen = 0;       ///< of rungs
    bool stated = false;          ///< the model is the scenario's own choice
    bool meets = false;           ///< the chosen one's error is within the tolerance
    Beyond beyond = Beyond::nothing;
    double breaking = 0;  ///< the largest breaking_ratio() of the waves; 0 of bores, which do break
    LightDemand light;

    const Forecast& choice() const { return rungs[chosen]; }
    /// In plain words, for the report: what was chosen and why, each other rung and what speaks against it.
    std::vector<std::string> reasons() const;
    /// What a reader must know before trusting the run; empty where the tolerance is met.
    std::string warning() const;
    /// The same of the floor map.
    std::string light_warning() const;
};

/// Chooses for a scenario whose keys go together and whose data files have been found. Throws InputError where such a
/// file cannot be used.
Decision choose(const Scenario& scenario);

/// Whether the scenario leaves something to be chosen.
bool is_open(const Scenario& scenario);

/// Writes what was chosen where the scenario left it open, and the reasons beside it. Throws InputError where no model
/// meets the tolerance and the scenario insists (accuracy.strict).
void settle(Scenario& scenario, const Decision& decision);

/// Of a scenario that leaves nothing open and whose data files have been found: notes a warning beside its model where
/// that is linear or airy and the waves are steeper than those that break. Throws InputError where the scenario
/// insists.
void warn_of_breaking(Scenario& scenario);

/// The names of the models as a scenario has them.
std::string_view name_of(ModelChoice model);

}  // namespace waterlight
