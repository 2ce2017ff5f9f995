// All sides of a domain alike.
#pragma once

#include "sim/boundary.hpp"

namespace waterlight::test {

inline constexpr Boundary periodic{Side::periodic, Side::periodic}, walls{Side::wall, Side::wall},
    open_sides{Side::absorbing, Side::absorbing};

}  // namespace waterlight::test
