// A uniform ellipse as weights of pixels, and what convolving a map with it takes.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "sim/field.hpp"

namespace waterlight {

/// An ellipse about the origin by its covariance (pixels^2) as a disc of uniform density: of semi-axes a and b along
/// the axes, xx = a^2 / 4, yy = b^2 / 4, xy = 0.
struct Spread {
    double xx = 0, xy = 0, yy = 0;
    bool operator==(const Spread&) const = default;
};

/// The uniform ellipse of a spread, shared exactly among pixels, row by row: weights add up to 1. Pixels that lie
/// within it have the same weight and make up a run of each row.
class EllipseTaps {
  public:
    struct Row {
        int dy = 0;
        int run_begin = 0, run_end = 0;  ///< pixels [begin, end) of full weight
        std::vector<int> edge_dx;        ///< the others
        std::vector<float> edge_weight;
    };

    /// Narrowed by the spread of a pixel, 1/12 along each axis, for the values of a map are means over its pixels: what
    /// it spreads them by is then the ellipse alone. Along an axis on which it is narrower than a pixel nothing is
    /// left.
    explicit EllipseTaps(Spread spread);

    /// Pixels that the ellipse reaches from the middle one along x and y.
    glm::ivec2 reach() const { return reach_; }
    float full_weight() const { return full_weight_; }
    const std::vector<Row>& rows() const { return rows_; }

  private:
    glm::ivec2 reach_{0, 0};
    float full_weight_ = 1;
    std::vector<Row> rows_;
};

/// Convolves `from` with the taps into `to`, of which pixel (i, j) lies at (i, j) + reach in `from`: from is larger by
/// twice the reach. The cost is that of the ellipse's rim. Does not depend on the number of threads.
void convolve(const EllipseTaps& taps, const Field<float>& from, Field<float>& to);

}  // namespace waterlight
