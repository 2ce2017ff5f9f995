// Landed quads shared exactly among the pixels of a floor map.
#pragma once

#include <vector>

#include "caustics/cell_shares.hpp"
#include "caustics/quad_batch.hpp"
#include "caustics/quads_land.hpp"
#include "caustics/surface_rows.hpp"

namespace waterlight {

/// Adds up the light of all quads on the map, pixel by pixel in the order of the quads, whatever the number of threads.
/// A quad's light is even over it; of one that crosses itself each of two triangles has half.
class QuadSharer {
  public:
    /// Takes from `ledger`, row by row, what does not land on the map. Returns the sum over its pixels (W/m2).
    double collect(const FloorFrame& frame, const SurfaceRows& surface, const LandedQuads& landed, Field<float>& map,
                   std::vector<RowLedger>& ledger);

  private:
    struct Scratch {
        std::vector<float> channels, shares, counted;
        std::vector<int> pixel;
        std::array<unsigned char, QuadBatch::size> left_over;
        QuadBatch nine;
        CellShares exact;
    };
    class Band;
    std::vector<Scratch> scratch_;
};

}  // namespace waterlight
