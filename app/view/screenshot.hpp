// The last picture of a scene, without panels, as a file.
#pragma once

#include <filesystem>

#include "render/scene_renderer.hpp"

namespace waterlight {

/// Writes a .png. Throws WorldError where it cannot be written.
void write_screenshot(SceneRenderer& renderer, const std::filesystem::path& file);

/// waterlight_001.png or the next that is not there, in this folder.
std::filesystem::path next_screenshot(const std::filesystem::path& folder);

}  // namespace waterlight
