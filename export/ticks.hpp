// Round numbers along a scale.
#pragma once

#include <string>
#include <vector>

#include "export/range.hpp"

namespace waterlight {

struct Tick {
    double value = 0;
    std::string label;  ///< all labels of one even scale carry the same number of decimals
};

/// The multiples of 1, 2 or 5 times a power of ten within the range, at most `most` >= 2 of them. On a logarithmic
/// scale the powers of ten, or of a power of ten, with their double and fivefold where there is room.
std::vector<Tick> round_ticks(ValueRange range, int most);

/// The largest 1, 2 or 5 times a power of ten that is not above `value` > 0, and its label without a unit.
Tick round_down(double value);

}  // namespace waterlight
