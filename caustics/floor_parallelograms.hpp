// The adaptive footprint on the CPU: each sample's parallelogram from the samples landed around it.
#pragma once

#include "caustics/floor_row_ledger.hpp"

namespace waterlight {

/// The parallelograms of one row of samples (caustics/kernels/footprint.glsl), and what they have in common.
struct ParallelogramRow {
    std::vector<float> width, height, slant, slide;
    float tallest = 1;     ///< the largest height
    float widest = 1;      ///< the largest width of a strip with its slant
    bool upright = false;  ///< they are boxes: slant and slide are 0
    bool clipped = false;  ///< one may reach out of the window
    bool on_rows = false;  ///< none reaches beyond the map's lowest or highest row
};

/// Makes rows of them; one thread at a time.
class ParallelogramShaper {
  public:
    /// Both must outlive it.
    ParallelogramShaper(const FloorFrame& frame, const SurfaceRows& surface);
    /// The parallelograms of row j, valid until the next call.
    const ParallelogramRow& shape(const LandedSamples& landed, int j);
    /// Takes from the ledger of row j, the one shaped last, what does not land on the map.
    void account(const LandedSamples& landed, int j, RowLedger& ledger);

  private:
    void measure(const LandedSamples& landed, int j);
    void share_span(const LandedSamples& landed, int j, Span span);

    const FloorFrame& frame_;
    const SurfaceRows& surface_;
    ParallelogramRow row_;
    std::vector<float> half_x_, half_y_;  ///< half of what each spans, in pixels
    std::vector<float> span_, shear_;     ///< columns that a strip of each spans, and how far it is from a box
    std::vector<float> counted_;
    Shares shares_;
};

/// Widens the lowest and highest of every row by all that its parallelograms may be higher than a pixel.
void widen(const FloorFrame& frame, LandedSamples& landed);

}  // namespace waterlight
