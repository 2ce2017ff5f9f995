// The surface at the samples of a floor map, row by row: bilinear in elevation and slopes.
#pragma once

#include <vector>

#include "caustics/floor_frame.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// One row of samples. `lit` is the part of a sample that light reaches (walls cut it), `counted` the part that the
/// ledger counts as its own.
struct SampleRow {
    std::vector<float> elevation, slope_x, slope_y, lit, counted;
    explicit SampleRow(int count) : elevation(count), slope_x(count), slope_y(count), lit(count), counted(count) {}
};

/// Reads a surface at the samples of a frame; both must outlive it. Safe to call from several threads, each with its
/// own SampleRow and Scratch.
class SurfaceRows {
  public:
    /// A row of the surface's cells read at the columns of the lattice.
    struct CellRow {
        int row = -1;
        std::vector<float> elevation, slope_x, slope_y;
    };
    /// The two rows of cells around the row of samples read last: many rows of samples share them.
    struct Scratch {
        CellRow low, high;
        std::vector<float> with_ghosts;  ///< a row of cells with a ghost at both ends and two cells of still water
    };

    SurfaceRows(const FloorFrame& frame, const Surface& surface);
    Scratch scratch() const;
    /// Fills `out` with row j of the lattice.
    void read(int j, Scratch& scratch, SampleRow& out) const;
    /// The part of each sample of row j that light reaches.
    void read_lit(int j, std::vector<float>& lit) const;
    /// The part of each sample of row j that the ledger counts.
    void read_counted(int j, std::vector<float>& counted) const;

  private:
    void read_aligned(int j, Scratch& scratch, SampleRow& out) const;
    void read_turned(int j, SampleRow& out) const;
    void read_cells(int row, CellRow& out, std::vector<float>& with_ghosts) const;

    const FloorFrame& frame_;
    const Surface& surface_;
    glm::vec2 climb_;  ///< of the surface over one period
    // Aligned maps: what column i of the lattice needs of any row of cells.
    std::vector<int> cell_;
    std::vector<float> weight_, climb_x_, lit_x_, counted_x_;
};

}  // namespace waterlight
