#include "export/range.hpp"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

namespace waterlight {

namespace {

double round_up(double value) {
    if (!(value > 0)) return 1;
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        if (value <= step * decade * (1 + 1e-6)) return step * decade;
    }
    return 10 * decade;
}

}  // namespace

double ValueRange::position(double value) const {
    return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

ValueRange symmetric_range(const Field<float>& field) {
    double greatest = 0;
    for (const float value : field.values()) {
        if (std::isfinite(value)) greatest = std::max<double>(greatest, std::abs(value));
    }
    const double high = round_up(greatest);
    return {-high, high};
}

ValueRange positive_range(const Field<float>& field, double above) {
    assert(above >= 0 && above < 1);
    std::vector<float> values;
    values.reserve(field.size());
    for (const float value : field.values()) {
        if (std::isfinite(value)) values.push_back(value);
    }
    if (values.empty()) return {0, 1};
    const auto last = static_cast<double>(values.size() - 1);
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::floor(last * (1 - above)));
    std::nth_element(values.begin(), nth, values.end());
    return {0, round_up(*nth)};
}

}  // namespace waterlight
