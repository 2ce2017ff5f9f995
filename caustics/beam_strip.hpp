// A strip of a picture's columns, to which beams are added one after another. Beams stand upright in most pictures, so
// the loops run up the columns.
#pragma once

#include <cstdint>
#include <vector>

#include "caustics/beam_image.hpp"
#include "caustics/beam_view.hpp"
#include "caustics/phase.hpp"

namespace waterlight {

class BeamStrip {
  public:
    static constexpr int columns = 32;

    /// `reach`: of ground_reach(). All outlive the strip.
    BeamStrip(const BeamImageSettings& settings, const Beams& beams, const Field<float>& reach);

    /// Starts at this column of the picture, dark.
    void begin(int first_column);
    /// Adds the beams of one cell; returns the rays that may meet them.
    template <class PhaseFunction>
    std::int64_t add(const CellCopy& copy, const PhaseFunction& phase);
    /// Writes the strip to the picture; returns the pixels that saw a beam.
    std::int64_t finish(Field<float>& radiance) const;

  private:
    const BeamImageSettings& settings_;
    const Beams& beams_;
    const Field<float>& reach_;
    Viewpoint view_;
    ViewRays view_rays_;
    bool uneven_;  ///< beams end on ground of their own
    int first_column_ = 0;
    Field<float> length_, per_length_, near_, far_, sum_;  ///< a row for each column of the strip
};

}  // namespace waterlight
