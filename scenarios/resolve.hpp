// What a scenario leaves open, decided; and its settings for the grid and the floor map.
#pragma once

#include <string>
#include <vector>

#include "caustics/beam_image.hpp"
#include "caustics/floor.hpp"
#include "scenarios/scenario.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// As settle() decided or the scenario states. Where neither has been, the model that its keys leave: prescribed,
/// shallow-water or else airy, by which they can be checked.
ModelDecision resolve_model(const Scenario& scenario);
/// The sides as stated, each by itself before its axis; those left open are periodic for the model prescribed and for a
/// spectrum or a buoy, else walls.
SideChoices resolve_sides(const Scenario& scenario);
/// The same as the models of equal sides and the light take them: a wall where one of both is (a piston is one),
/// absorbing where both let waves out.
Boundary resolve_boundary(const Scenario& scenario);
/// Whether neither waves nor water pass a side.
bool is_closed(const Scenario& scenario);
/// Time (s) after which energy neither comes in nor goes out; infinite where it always may.
double conserves_energy_from_s(const Scenario& scenario);
/// What the volume of WaveDiagnostics leaves out (m3): the water below level 0, but for the model shallow-water.
double still_volume_m3(const Scenario& scenario);
Grid grid_of(const Scenario& scenario);
/// Of the floor's map. The scenario has one.
FloorSettings floor_settings(const Scenario& scenario);
/// Of the beams. The scenario has them.
BeamSettings beam_settings(const Scenario& scenario);
/// Of the beams of reflected light. The scenario has them.
BeamSettings reflected_settings(const Scenario& scenario);
/// Whether the scenario has a camera that is above still water.
bool looks_from_air(const Scenario& scenario);
/// Whether it has a camera that sees the light of its beams, those in the water from there, else the reflected ones.
bool sees_scattered_light(const Scenario& scenario);
/// Whether pictures of the scene are traced on the CPU: those of objects and lamps are.
bool traces_pictures(const Scenario& scenario);
/// Of the picture, where it is taken in the air that of the mirrored camera. The scenario has a camera. Left open, its
/// range is where a thousandth of the light is left, at most twice the domain's longer side.
BeamImageSettings beam_image_settings(const Scenario& scenario);

}  // namespace waterlight
