// The functions in which a field is expanded along one axis: Fourier's where it repeats, cosines between walls.
#pragma once

#include <vector>

namespace waterlight {

/// n real functions, orthogonal on n cells of spacing_m; each is called a slot.
/// fourier: slot m is cos(k_m (x - origin)), slot n - m is sin(k_m (x - origin)), k_m = 2 pi m / length, m <= n / 2;
/// the origin is the centre of cell 0. cosine: slot m is cos(k_m (x - origin)), k_m = pi m / length; the origin is the
/// wall before cell 0. Fields sampled at the cell centres are then the sums that transforms compute.
struct AxisBasis {
    enum class Kind { fourier, cosine };

    Kind kind = Kind::fourier;
    int n = 1;             ///< cells, >= 1
    double spacing_m = 1;  ///< > 0
    double corner_m = 0;   ///< outer side of cell 0

    double length_m() const { return n * spacing_m; }
    double origin_m() const { return kind == Kind::fourier ? corner_m + 0.5 * spacing_m : corner_m; }
    double wave_step() const;                                               ///< rad/m between neighbouring wave numbers
    int distinct() const { return kind == Kind::fourier ? n / 2 + 1 : n; }  ///< number of different wave numbers
    /// Index of the slot's wave number, in [0, distinct()).
    int wave_of(int slot) const { return kind == Kind::fourier && slot > n / 2 ? n - slot : slot; }
    /// The slot that shares its wave number with slot `wave`, or `wave` itself where it is alone.
    int partner_of(int wave) const;
    double wave_number(int wave) const { return wave * wave_step(); }  ///< rad/m
    double value(int slot, double x_m) const;
    /// Mean of the slot's square over the cells: 1 for the constant and for Fourier's highest cosine, else 1/2.
    double mean_square(int slot) const;
};

/// Copies row[wave] to all slots of that wave number, for wave in [0, distinct()); row holds n values.
template <class Real>
void spread_to_slots(const AxisBasis& axis, Real* row) {
    for (int slot = axis.distinct(); slot < axis.n; ++slot) row[slot] = row[axis.n - slot];
}

/// Whether n > 0 has no prime factor above 5: a length that transforms well.
bool is_fast_length(int n);

}  // namespace waterlight
