// Numbers as they are told to people.
#pragma once

#include <string>

namespace waterlight {

/// Rounded to so many digits that count, >= 1, without an exponent from 1e-9 to 1e4: "0.021", "100", "1200", "1.2e+06".
std::string rounded(double value, int digits);
/// A share in per cent, to two digits: "2.1 %", "210 %".
std::string percent(double share);

}  // namespace waterlight
