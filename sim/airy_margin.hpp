// The damped margins beyond absorbing sides of the airy model.
//
// Beyond each absorbing side the tank goes on by a margin, and then closes on itself: a wave that leaves to the right
// crosses the right margin and then the left one before it could come back. There the water relaxes at the rate
// sigma(s) = sigma_max sin^2(pi s / 2), s = distance outside over the margin's width.
//
// A damping that varies over a wavelength would reflect, because elevation e and its quadrature q = rate / w look the
// same in a wave and in its reflection. They differ by the sign of the wave number k along the axis. So not q is damped
// but J q, which has each wave number's phase turned by sign(k) pi/2: then J q = e in waves towards one side and J q =
// -e in those towards the other, the sums e + J q and e - J q relax each on its own, and nothing is reflected. That
// turn jumps at k = 0, which would carry the damping far into the domain (as 1 / distance) for waves that run along the
// side. So the angle is (pi/2) tanh(k turn_m): full for waves shorter than a fraction of the domain, and smooth.
//
// What passes both margins is exp(-integral of sigma / cg).
#pragma once

#include <vector>

#include "sim/boundary.hpp"
#include "sim/fft_axis.hpp"
#include "sim/fft_lines.hpp"
#include "sim/fft_plan.hpp"
#include "sim/field.hpp"
#include "sim/water.hpp"

namespace waterlight {

/// The margins of one axis. cells = 0: none.
struct AbsorbingMargin {
    int cells = 0;         ///< on each side
    double width_m = 0;    ///< of each side
    double sigma_max = 0;  ///< 1/s
    double turn_m = 0;     ///< 1 / turn_m: the wave number about which the phase of q begins to be turned
    double step_s = 0;     ///< the longest step in which damping and propagation may be taken one after the other

    /// Relaxation rate (1/s) at the centre of cell i of the tank, which has n cells.
    double rate(int i, int n) const;
};

/// margin_m = 0 takes a quarter of the domain. An even number of cells is rounded up to a tank that
/// transforms well. sigma_max
/// leaves 1e-3 of the amplitude of a wave as long as the tank; shorter waves are slower and fade more. Measured
/// reflection of steady waves, with the default margin: below 1e-4 of the amplitude for waves of 1/16 of the domain's
/// length, 6e-4 at 1/8, 1.5 % at 1/4, 10 % at 1/2. A drop differs from one in open water by 0.2 % of its height.
AbsorbingMargin make_margin(Side side, int n, double spacing_m, double margin_m, const Water& water);

/// The fraction of its amplitude that a wave of wave number k (rad/m), at right angles to the side, keeps after both
/// margins: exp(-sigma_max width / cg).
double transmitted_fraction(const AbsorbingMargin& margin, double k, const Water& water);

/// Damps the slots of elevation e and quadrature q (planes of PlaneTransform) along one axis, which must be of
/// Fourier's kind.
class DirectionalDamping {
  public:
    DirectionalDamping(const AxisBasis& axis, const AbsorbingMargin& margin);

    /// The axis is x: for step_s seconds, over `rows` rows.
    void damp_rows(double step_s, int rows, Field<float>& e, Field<float>& q) const;
    /// The axis is y: over `columns` columns.
    void damp_columns(double step_s, int columns, Field<float>& e, Field<float>& q) const;

  private:
    std::vector<float> factors(double step_s) const;
    /// J (direction 1) or its inverse (-1) of one row of slots.
    void turn_row(float direction, const float* from, float* to) const;
    /// `width` columns of e and J q from column i on, as lines 2l and 2l + 1 of a tile; and back.
    void interleave(const Field<float>& e, const Field<float>& q, int i, int width, Field<float>& slots) const;
    void separate(const Field<float>& slots, int i, int width, Field<float>& e, Field<float>& q) const;

    int n_;
    LinePacking packing_;
    LineFft row_, columns_;
    std::vector<double> rates_;         ///< 1/s, of each cell
    std::vector<float> cosine_, sine_;  ///< of the angle by which q is turned, of each wave number
};

}  // namespace waterlight
