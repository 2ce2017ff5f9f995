// Passes 1 and 2 of the floor map on the CPU.
#pragma once

#include <vector>

#include "caustics/floor_frame.hpp"
#include "caustics/surface_rows.hpp"
#include "sim/field.hpp"

namespace waterlight {

/// What one row of samples adds to the ledger, W/m2 of surface.
struct RowLedger {
    double incident = 0, reflected = 0, extinguished = 0, outside = 0, lost = 0, objects = 0, entered = 0;
};

/// Landed samples of the whole lattice: displacement from the base pixel (pixels) and power (W/m2 of surface).
struct LandedSamples {
    Field<float> x, y, power;
    /// Least and largest y displacement in each row; of samples whose footprint is higher than a pixel, of those of
    /// its ends that lie half a pixel within it.
    std::vector<float> lowest, highest;

    void resize(const FloorFrame& frame);
};

/// Adds up the light of all samples on the map and returns the sum over its pixels (W/m2). Every sample's box touches
/// two columns and two rows; pass 1 adds its four shares to the four channels of the lower left of these pixels, pass 2
/// sums for each pixel the channels of itself and of its left and lower neighbours. The same sums as the paper's gather
/// of N samples in M + 1 rows, at a cost that depends on neither. Each thread takes a band of rows and holds the
/// channels of about M + 6 of them; the order of additions does not depend on the number of threads.
class FloorCollector {
  public:
    double collect(const FloorFrame& frame, const LandedSamples& landed, Field<float>& map);

  private:
    /// Scratch of one thread, kept between frames.
    struct Scratch {
        std::vector<float> channels, shares;
        std::vector<int> pixel;
    };
    class Band;
    std::vector<Scratch> scratch_;
};

/// The same for parallelograms, which it makes from the landed samples around each. Pass 1 adds the shares of blocks of
/// two columns and two rows, as many as a parallelogram touches.
class FloorSpreader {
  public:
    /// Takes from `ledger`, row by row, what does not land on the map. Widens `lowest` and `highest`.
    double collect(const FloorFrame& frame, const SurfaceRows& surface, LandedSamples& landed, Field<float>& map,
                   std::vector<RowLedger>& ledger);

  private:
    struct Scratch {
        std::vector<float> channels, shares;
        std::vector<int> pixel;
        std::vector<unsigned char> left_over;
    };
    class Band;
    std::vector<Scratch> scratch_;
};

}  // namespace waterlight
