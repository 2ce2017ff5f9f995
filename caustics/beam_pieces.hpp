// Beams, and pieces of them, by their corners.
#pragma once

#include <array>
#include <vector>

#include "caustics/beams.hpp"

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

/// Pieces of many beams as beams of their own.
struct CutBeam {
    BeamPiece piece;
    glm::ivec2 of{0, 0};  ///< the beam, and its row
    double flux_w = 0;    ///< below the surface; none of shaded light
};

/// None where there are no pieces with light.
std::shared_ptr<BeamPieces> gather(const Beams& whole, const std::vector<std::vector<CutBeam>>& rows);

}  // namespace waterlight
