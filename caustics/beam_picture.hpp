// What the back-ends of a picture share: its settings' ranges, the copies of the beams that it shows, how far its rays
// see.
#pragma once

#include <vector>

#include "caustics/beam_image.hpp"
#include "caustics/beam_view.hpp"

namespace waterlight {

/// Throws InputError where a setting is out of its range or does not go with the beams.
void validate(const BeamImageSettings& settings, const Beams& beams);

/// Whole periods (m) by which the domain is moved for the beams that lie within the picture's range; {0, 0} where no
/// side is periodic.
std::vector<glm::vec2> copies_in_range(const BeamImageSettings& settings, const Beams& beams);

/// Makes `image` as large as the picture.
void resize(const BeamImageSettings& settings, BeamImage& image);

}  // namespace waterlight
