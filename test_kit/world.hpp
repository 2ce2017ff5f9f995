// A world to test against: a scenario whose time is in the test's hands, and nothing written.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "caustics/floor.hpp"
#include "scenarios/build.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

class World {
  public:
    /// From a scenario with overrides ("key=value") laid over it, at its start, on the CPU. Its duration, outputs and
    /// checks are not used. Throws InputError in one line, as the program does.
    static World from(const std::filesystem::path& scenario, const std::vector<std::string>& overrides = {});
    /// From the text of a scenario. Files that it names lie beside the working folder or below $WATERLIGHT_DATA.
    static World from_text(std::string_view toml, const std::vector<std::string>& overrides = {});

    /// Moves the water forward by seconds >= 0. Throws WorldError where it no longer is a number.
    void advance(double seconds);
    /// Since the start.
    double time_s() const { return time_s_; }

    /// The water now; valid until the next advance().
    const Surface& surface() { return waves_.model->surface(); }
    /// The map of light below it, by the section caustics.floor and its method, but for the truth, of parallel light of
    /// one colour; computed when first asked for after an advance(). Throws InputError where the scenario has none.
    const FloorMap& floor_map();

    WaveDiagnostics diagnostics() { return waves_.model->diagnostics(); }
    /// Of the water (m3).
    double volume_m3();
    /// Kinetic, potential above still water, and of the surface's tension (J); NaN of prescribed surfaces.
    double energy_j() { return diagnostics().energy_j; }
    /// Elevation (m) of the smooth surface through the cells.
    double elevation_at(glm::dvec2 at_m);

    const Scenario& scenario() const { return scenario_; }
    Grid grid() const;

  private:
    explicit World(Scenario scenario);

    Scenario scenario_;
    BuiltModel waves_;
    std::unique_ptr<FloorMapper> mapper_;
    FloorMap map_;
    double time_s_ = 0;
    bool is_mapped_ = false;  ///< map_ is that of the present surface
};

}  // namespace waterlight
