// A round spot on a grid, with its images beyond the sides.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "sim/boundary.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// Columns or rows from `from` to one before `to`.
struct CellRange {
    int from = 0;
    int to = 0;
};

/// The cells that a spot of radius R reaches, to where exp(-r^2/R^2) is below double rounding: mirrored at walls,
/// wrapped at periodic sides, cut off at absorbing ones.
class RoundSpot {
  public:
    RoundSpot(glm::dvec2 at_m, double radius_m, const Grid& grid, Boundary boundary);

    /// The cells that any of the images reaches; none where to <= from.
    CellRange columns() const { return hull(xs_); }
    CellRange rows() const { return hull(ys_); }

    /// Calls take(i, j, q), q = r^2/R^2, for all cells of each image in turn.
    template <class Take>
    void visit(Take take) const {
        for (const Image& y : ys_)
            for (const Image& x : xs_)
                for (int j = y.cells.from; j < y.cells.to; ++j)
                    for (int i = x.cells.from; i < x.cells.to; ++i) {
                        const double rx = grid_.x_m(i) - x.at_m, ry = grid_.y_m(j) - y.at_m;
                        take(i, j, (rx * rx + ry * ry) * per_radius2_);
                    }
    }

  private:
    /// Along one axis: its centre and the cells it reaches.
    struct Image {
        double at_m = 0;
        CellRange cells;
    };
    struct Axis {
        double start_m = 0;
        double cell_m = 1;
        int count = 1;
        Side side = Side::periodic;
    };
    static std::vector<Image> images(double at_m, double reach_m, const Axis& axis);
    static CellRange hull(const std::vector<Image>& images);

    Grid grid_;
    double per_radius2_;
    std::vector<Image> xs_, ys_;
};

}  // namespace waterlight
