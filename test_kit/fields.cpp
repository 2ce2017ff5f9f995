#include "test_kit/fields.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace waterlight {

Field<double> on(const Grid& grid, const FieldFormula& formula) {
    Field<double> field(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) field(i, j) = formula(grid.x_m(i), grid.y_m(j));
    return field;
}

Field<double> widened(const Field<float>& field) {
    Field<double> wide(field.nx(), field.ny());
    std::copy_n(field.data(), field.size(), wide.data());
    return wide;
}

FieldNorms difference(const Field<float>& field, const Field<double>& expected) {
    std::vector<double> values;
    if (field.nx() == expected.nx() && field.ny() == expected.ny())
        for (std::size_t n = 0; n < field.size(); ++n) values.push_back(field.data()[n] - expected.data()[n]);
    return norms_of(std::span<const double>(values));
}

FieldNorms difference(const Field<float>& field, const Field<float>& expected) {
    return difference(field, widened(expected));
}

double l2_error(const Field<float>& field, const Grid& grid, const FieldFormula& exact) {
    return difference(field, on(grid, exact)).l2;
}

FarthestCell farthest(const Field<float>& field, const Field<double>& expected) {
    FarthestCell most{0, 0, 0, 0, -1};
    for (int j = 0; j < field.ny(); ++j)
        for (int i = 0; i < field.nx(); ++i) {
            double distance = std::abs(field(i, j) - expected(i, j));
            if (std::isnan(distance)) distance = std::numeric_limits<double>::infinity();
            if (distance > most.distance) most = {i, j, field(i, j), expected(i, j), distance};
        }
    return most;
}

}  // namespace waterlight
