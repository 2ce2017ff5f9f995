// A picture of fewer rays, enlarged.
#pragma once

#include "caustics/beam_image.hpp"

namespace waterlight {

/// The camera of every `reduction`-th ray each way, spread evenly about the middle of the picture.
Camera reduced(const Camera& camera, int reduction);

/// Fills `picture` from `coarse`, as reduced() took it: bilinear between the four nearest rays, but with less weight
/// the more their way through the water differs from the pixel's own, so that the edges of the water stay sharp.
void enlarge(const BeamImageSettings& settings, const Beams& beams, const Field<float>& coarse, Field<float>& picture);

}  // namespace waterlight
