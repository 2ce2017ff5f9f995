// The command `view`: a window on a running scenario.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/floor_stage.hpp"

namespace waterlight {

struct ViewOptions {
    std::filesystem::path scenario;
    std::vector<std::string> overrides;
    DeviceWish device;  ///< its name is of the device that draws, too
    glm::ivec2 size{1280, 720};
    std::optional<int> frames;         ///< closes after so many pictures, and says how quickly they came
    std::filesystem::path screenshot;  ///< where screenshots go, the last picture too; empty: files of their own
    std::function<int()> stop_signal;  ///< as of RunOptions
};

/// Shows the scenario until the user closes the window. Throws InputError where the scenario is wrong, WorldError where
/// there is no display or the validation layer has something to say, gpu::Error where the device cannot draw or is
/// lost.
void view_scenario(const ViewOptions& options);

}  // namespace waterlight
