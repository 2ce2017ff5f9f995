// The corners of the quads of a floor map, landed; and the power that each quad takes down.
#pragma once

#include <array>
#include <vector>

#include "caustics/floor_collect.hpp"
#include "caustics/floor_frame.hpp"
#include "caustics/object_shadows.hpp"

namespace waterlight {

/// A triangle of what a wall leaves of a quad, landed.
struct CutPiece {
    std::array<glm::dvec2, 3> pixel;  ///< of the map
    double power = 0;                 ///< W per area of a pixel
    double counted = 1;               ///< the part that the ledger counts
};

/// Quad (i, j) of the frame has corners (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1). Corner (i, j) lands at base
/// pixel (i, j) + displacement.
struct LandedQuads {
    LandedSamples corners;                      ///< `power` is the quads'; `lowest` and `highest` are of rows of quads
    std::vector<std::vector<CutPiece>> pieces;  ///< of each row of quads; their quads have no power
};

/// Lands them, with the ledger as if all light fell on the map. Widens the frame's window where it does not hold all.
void land_quads(FloorFrame& frame, const FloorSettings& settings, const Surface& surface, const ShadowRows& shadows,
                LandedQuads& landed, std::vector<RowLedger>& ledger);

}  // namespace waterlight
