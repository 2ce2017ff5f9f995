// What the back-ends of a picture share: its settings' ranges, the copies of the beams that it shows, how far its rays
// see.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "caustics/beam_image.hpp"
#include "caustics/beam_view.hpp"

namespace waterlight {

/// Throws InputError where a setting is out of its range or does not go with the beams.
void validate(const BeamImageSettings& settings, const Beams& beams);

/// Whole periods (m) by which the domain is moved for the beams that the picture may show: within its range and its
/// frame. At most {0, 0} where no side is periodic.
std::vector<glm::vec2> copies_in_sight(const BeamImageSettings& settings, const Beams& beams);

/// Whether the box around these corners, relative to the eye, comes within range of it.
bool in_range(std::span<const glm::vec3, 8> corners, double range_m);

/// How far each pixel's ray goes, in t: to uneven ground or to an object; empty where there is neither.
Field<float> picture_reach(const BeamImageSettings& settings, const Beams& beams);

/// Makes `image` as large as the picture.
void resize(const BeamImageSettings& settings, BeamImage& image);

/// Adds a picture of other beams by the same camera.
void add(const BeamImage& more, BeamImage& image);

/// Draws by `draw` as many rays as the settings' reduction asks for, the pieces of cut beams too, and enlarges. `draw`
/// leaves the pieces out; its third argument is of picture_reach().
using DrawAll = std::function<void(const BeamImageSettings&, const Beams&, const Field<float>&, BeamImage&)>;
void draw_reduced(const BeamImageSettings& settings, const Beams& beams, const DrawAll& draw, BeamImage& image);

}  // namespace waterlight
