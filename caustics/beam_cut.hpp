// Beams that objects stop in part, cut into pieces that they stop whole or not at all. Near an object a beam's triangle
// is halved until it is small beside it; where then some of its rays are stopped and some are not it is cut along the
// shadow's edge, which is found on its sides by bisection.
#pragma once

#include <vector>

#include "caustics/beam_pieces.hpp"
#include "caustics/objects/repeated_objects.hpp"
#include "caustics/objects/shadow_box.hpp"

namespace waterlight {

/// Cuts the beams of one surface. Any number of threads at once.
class BeamCutter {
  public:
    /// `beams` has its domain, its sides and which way is up; it must outlive the cutter.
    BeamCutter(const BeamSettings& settings, const Beams& beams);

    /// None where no object stops any of the beam: it then stays as it is.
    std::vector<BeamPiece> pieces(const BeamTriangle& beam) const;

    struct World {
        const Beams& beams;
        RepeatedObjects objects;
        std::vector<ShadowBox> boxes;  ///< of each object
        glm::dvec3 to_sun;
    };

  private:
    World world_;
};

}  // namespace waterlight
