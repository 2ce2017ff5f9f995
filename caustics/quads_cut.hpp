// Quads of the floor map that a wall cuts: what of them is water is landed by itself, in double precision.
#pragma once

#include "caustics/quads_land.hpp"
#include "caustics/truth_ray.hpp"

namespace waterlight {

class QuadCutter {
  public:
    /// All must outlive it.
    QuadCutter(const FloorFrame& frame, const FloorSettings& settings, const Surface& surface);
    QuadCutter(const QuadCutter&) = delete;

    /// Whether there are walls.
    bool cuts() const { return walls_.x || walls_.y; }
    /// Adds the pieces of the quad of a base pixel, and their light to the ledger as if it fell on the map. `shadow`:
    /// what objects stop, if anything.
    void cut(glm::ivec2 base, double counted, const f64::SampleShadow* shadow, std::vector<CutPiece>& pieces,
             RowLedger& row) const;

  private:
    const FloorFrame& frame_;
    const FloorSettings& settings_;
    glm::bvec2 walls_;
    glm::dvec2 low_m_, high_m_;  ///< of the domain
    TruthSurface surface_;
    TruthCaster caster_;
};

}  // namespace waterlight
