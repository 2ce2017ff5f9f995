// Fields against what they should be.
#pragma once

#include <functional>

#include "sim/field.hpp"
#include "sim/field_norms.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// Of a place (m).
using FieldFormula = std::function<double(double x_m, double y_m)>;

/// The formula at the centres of the grid's cells.
Field<double> on(const Grid& grid, const FieldFormula& formula);

/// Norms of field - expected, which have one size; NaN where they do not.
FieldNorms difference(const Field<float>& field, const Field<double>& expected);
FieldNorms difference(const Field<float>& field, const Field<float>& expected);

/// Root of the mean square of the difference from the formula at the cells' centres.
double l2_error(const Field<float>& field, const Grid& grid, const FieldFormula& exact);

/// Where two fields of one size differ most; values that are not numbers differ most of all.
struct FarthestCell {
    int i = 0, j = 0;
    double value = 0, expected = 0, distance = 0;
};
FarthestCell farthest(const Field<float>& field, const Field<double>& expected);

/// In double precision.
Field<double> widened(const Field<float>& field);

}  // namespace waterlight
