// What the user of a view has chosen that is not the session's: where he looks from, how it looks, what the mouse does.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "caustics/camera.hpp"
#include "render/look.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

enum class Tool { drop, sphere };

struct ViewState {
    Camera camera;  ///< its size is the window's
    Look look;
    Tool tool = Tool::drop;
    double drop_radius_m = 0.1;
    double drop_height_m = 0.04;  ///< negative digs
    double sphere_radius_m = 0.3;
    int reduction = 0;  ///< of the picture's sides; 0: such that pictures come quickly
    std::string said;   ///< what was done last, one line
    bool wants_screenshot = false;
    bool closes = false;
};

/// The scenario's own camera and look, or a camera from which the whole water is seen from above; drops and a sphere
/// that fit the water and its cells. Throws InputError where the range of an overlay is not known.
ViewState initial_state(const Scenario& scenario, glm::ivec2 window_size);

}  // namespace waterlight
