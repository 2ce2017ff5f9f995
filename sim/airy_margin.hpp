// The damped margins beyond absorbing sides of the airy model.
//
// Beyond each absorbing side the tank goes on by a margin, and then closes on itself: a wave that leaves to the right
// crosses the right margin and then the left one before it could come back. There the water relaxes at the rate
// sigma(s) = sigma_max sin^2(pi s / 2), s = distance outside over the margin's width.
//
// A damping that varies over a wavelength would reflect. So each row (column) is split in the waves that run towards +x
// and those that run towards -x: with e = elevation and q = rate / w, a wave towards +x has q's sine equal to e's
// cosine and q's cosine equal to minus e's sine. Each part is damped on its own and stays what it was: nothing comes
// back, by construction. What passes both margins is exp(-integral of sigma / cg), the promise that tests check.
#pragma once

#include <vector>

#include "sim/boundary.hpp"
#include "sim/fft_axis.hpp"
#include "sim/fft_plan.hpp"
#include "sim/field.hpp"
#include "sim/water.hpp"

namespace waterlight {

/// The margins of one axis. cells = 0: none.
struct AbsorbingMargin {
    int cells = 0;         ///< on each side
    double width_m = 0;    ///< of each side
    double sigma_max = 0;  ///< 1/s
    double step_s = 0;     ///< the longest step in which damping and propagation may be taken one after the other

    /// Relaxation rate (1/s) at the centre of cell i of the tank, which has n cells.
    double rate(int i, int n) const;
};

/// margin_m = 0 takes a quarter of the domain. An even number of cells is rounded up to a tank that
/// transforms well. sigma_max
/// leaves 1e-3 of the amplitude of a wave as long as the tank; shorter waves are slower and fade more.
AbsorbingMargin make_margin(Side side, int n, double spacing_m, double margin_m, const Water& water);

/// The fraction of its amplitude that a wave of wave number k (rad/m), at right angles to the side, keeps after both
/// margins: exp(-sigma_max width / cg).
double transmitted_fraction(const AbsorbingMargin& margin, double k, const Water& water);

/// Damps the slots of elevation e and quadrature q (planes of PlaneTransform) along one axis.
class DirectionalDamping {
  public:
    DirectionalDamping(const AxisBasis& axis, const AbsorbingMargin& margin);

    /// The axis is x: for step_s seconds, over `rows` rows.
    void damp_rows(double step_s, int rows, Field<float>& e, Field<float>& q) const;
    /// The axis is y: over `columns` columns.
    void damp_columns(double step_s, int columns, Field<float>& e, Field<float>& q) const;

  private:
    std::vector<float> factors(double step_s) const;

    AxisBasis axis_;
    std::vector<double> rates_;
    LineFft row_, columns_;
};

}  // namespace waterlight
