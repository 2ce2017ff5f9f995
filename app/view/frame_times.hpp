// How long the parts of a view take that are not the session's.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "caustics/beam_renderer.hpp"

namespace waterlight {

struct FrameTimes {
    double shown_hz = 0;            ///< pictures a second in the window, over the last second
    double draw_ms = 0;             ///< of the scene, the last time it was drawn
    double present_ms = 0;          ///< until the window had the picture and the panels
    glm::ivec2 picture{0, 0};       ///< pixels of the scene's picture
    std::vector<StageTime> passes;  ///< of the picture
};

}  // namespace waterlight
