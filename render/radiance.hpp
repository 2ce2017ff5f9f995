// A picture as linear light.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace waterlight {

/// Red, green and blue of each pixel one after the other, rows from the lowest up.
struct Radiance {
    glm::ivec2 size{0, 0};
    std::vector<float> rgb;  ///< W/(m2 sr), before the tone curve
};

}  // namespace waterlight
