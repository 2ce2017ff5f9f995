// Beams that objects stop in part, cut into pieces that they stop whole or not at all. Near an object a beam's triangle
// is halved until it is small beside it; where then some of its rays are stopped and some are not it is cut along the
// shadow's edge, which is found on its sides by bisection.
#pragma once

#include <array>
#include <vector>

#include "caustics/beams.hpp"
#include "caustics/objects/repeated_objects.hpp"
#include "caustics/objects/shadow_box.hpp"

namespace waterlight {

/// A corner of a beam.
struct BeamCorner {
    glm::dvec3 at_m{0, 0, 0};  ///< on the surface
    glm::dvec2 travel{0, 0};   ///< metres per metre of descent
    double path = 0;           ///< metres of way per metre of descent
    double end_z = 0;          ///< where its light ends, m
    double transmittance = 0;  ///< Fresnel
    double depth_m() const { return at_m.z - end_z; }
};

using BeamTriangle = std::array<BeamCorner, 3>;

/// The corners of beam b (2 i or 2 i + 1) in row j.
BeamTriangle triangle_of(const Beams& beams, int b, int j);

/// A piece of a beam: all of its rays have one fate.
struct BeamPiece {
    enum class Fate {
        goes_on,  ///< to the floor or the ground
        stopped,  ///< in the water, where the corners end
        shaded    ///< above the water
    };
    BeamTriangle corner;
    Fate fate = Fate::goes_on;
    double share = 1;  ///< of the beam's area, and so of its light
};

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

/// Pieces of many beams as beams of their own.
struct CutBeam {
    BeamPiece piece;
    glm::ivec2 of{0, 0};  ///< the beam, and its row
    double flux_w = 0;    ///< below the surface; none of shaded light
};

/// None where there are no pieces with light.
std::shared_ptr<BeamPieces> gather(const Beams& whole, const std::vector<std::vector<CutBeam>>& rows);

}  // namespace waterlight
