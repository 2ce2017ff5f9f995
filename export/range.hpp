// The span of values that a picture shows.
#pragma once

#include "sim/field.hpp"

namespace waterlight {

/// low < high, in the field's unit.
struct ValueRange {
    double low = 0;
    double high = 1;
    bool logarithmic = false;  ///< equal ratios take equal parts of the scale; then low > 0

    /// 0 at low, 1 at high.
    double position(double value) const;
};

/// [-a, a] with a the greatest finite magnitude, rounded up to 1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of ten; [-1, 1]
/// where all is zero.
ValueRange symmetric_range(const Field<float>& field);

/// [0, a] with a the value that only `above` (a fraction, in [0, 1)) of the finite values exceed, rounded up as in
/// symmetric_range. A few bright pixels, as caustics have, then do not darken all others. [0, 1] where none is above 0.
ValueRange positive_range(const Field<float>& field, double above);

}  // namespace waterlight
