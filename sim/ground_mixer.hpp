// Carries ground from a file's points to the cells of a grid, one point at a time and in any order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/bathymetry_file.hpp"

namespace waterlight {

/// Points in evenly spaced columns and rows.
struct Lattice {
    int nx = 1;
    int ny = 1;
    double dx_m = 1;
    double dy_m = 1;
    double x0_m = 0;  ///< of the first column
    double y0_m = 0;
};

/// What the points along one axis give to the cells along it.
class AxisShares {
  public:
    /// Of one point: its weight in the mean of a cell.
    struct Share {
        int cell = 0;
        double weight = 0;
    };
    /// `points` of which the first lies at first_m; cell k is [start_m + k cell_m, start_m + (k + 1) cell_m]. The
    /// weights of a cell sum to 1. Cells that the points do not reach take the outermost.
    struct Points {
        int count = 1;
        double first_m = 0;
        double spacing_m = 1;
    };
    struct Cells {
        int count = 1;
        double start_m = 0;
        double size_m = 1;
    };
    AxisShares(const Points& points, const Cells& cells);

    const Share* begin(int point) const { return shares_.data() + starts_[static_cast<std::size_t>(point)]; }
    const Share* end(int point) const { return shares_.data() + starts_[static_cast<std::size_t>(point) + 1]; }
    /// The first cell that lies beyond the points by more than half their spacing.
    std::optional<int> unreached_cell() const { return unreached_; }

  private:
    std::vector<std::size_t> starts_;
    std::vector<Share> shares_;
    std::optional<int> unreached_;
};

/// Sums up the weighted points of every cell: see read_ground() for the method.
class GroundMixer {
  public:
    /// `lattice` is in the file's coordinates. Throws InputError where it does not reach all cells of the grid, unless
    /// file.outside is `extend`, and where its numbers are out of all reason.
    GroundMixer(const GroundFile& file, const Lattice& lattice, const Grid& grid);

    /// Whether any cell needs this point.
    bool needs(int column, int row) const {
        return columns_.begin(column) != columns_.end(column) && rows_.begin(row) != rows_.end(row);
    }
    /// `number` is the file's own; to be called once for each point that has one.
    void add(int column, int row, double number);
    /// The place of a point, "(x, y)" in the file's coordinates and in the domain's, for messages.
    std::string place(int column, int row) const;
    /// The heights of the ground. Throws InputError where a cell lacks points and must not.
    Field<double> heights();

  private:
    void extend();

    GroundFile file_;
    Lattice lattice_;
    Grid grid_;
    AxisShares columns_, rows_;
    double sign_ = 1;
    Field<double> sums_, weights_;
};

}  // namespace waterlight
