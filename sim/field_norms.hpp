// Statistics of the values of a field.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace waterlight {

/// In the unit of the values, each of which counts the same; NaN where there is none or one of them is NaN.
struct FieldNorms {
    double min = 0;
    double max = 0;
    double mean = 0;
    double l1 = 0;    ///< mean of the absolute value
    double l2 = 0;    ///< root of the mean square
    double linf = 0;  ///< greatest absolute value
};

template <class T>
FieldNorms norms_of(std::span<const T> values) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN(),
                     infinity = std::numeric_limits<double>::infinity();
    double low = infinity, high = -infinity, sum = 0, sizes = 0, squares = 0;
    for (const T v : values) {
        const double x = v;
        low = std::min(low, x);
        high = std::max(high, x);
        sum += x;
        sizes += std::abs(x);
        squares += x * x;
    }
    if (values.empty() || std::isnan(sum)) return {none, none, none, none, none, none};
    const double n = static_cast<double>(values.size());
    return {low, high, sum / n, sizes / n, std::sqrt(squares / n), std::max(-low, high)};
}

}  // namespace waterlight
