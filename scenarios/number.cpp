#include "scenarios/number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace waterlight {

std::string rounded(double value, int digits) {
    const double size = std::abs(value);
    if (!(size >= 1e-9 && size < 1e4)) return fmt::format("{:.{}g}", value, digits);
    const int last = digits - 1 - static_cast<int>(std::floor(std::log10(size)));  // decimal, or tens if negative
    const double unit = std::pow(10.0, std::abs(last));
    if (last <= 0) return fmt::format("{:.0f}", std::round(value / unit) * unit);
    std::string text = fmt::format("{:.{}f}", value, last);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string percent(double share) { return rounded(100 * share, 2) + " %"; }

}  // namespace waterlight
