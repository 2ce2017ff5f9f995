// What a scenario says of the pictures of its scene.
#pragma once

#include <optional>

#include "render/look.hpp"

namespace waterlight {

struct PictureSection {
    Look look;                                    ///< its range is that of look_of() (scenarios/resolve_picture.hpp)
    std::optional<double> range_low, range_high;  ///< of the overlay, in its unit; none: chosen by look_of()
};

}  // namespace waterlight
