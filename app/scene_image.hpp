// A picture of a scene as files have it.
#pragma once

#include "export/png.hpp"
#include "render/scene_renderer.hpp"

namespace waterlight {

/// The last picture of the renderer, the top row first, without its alpha.
ColourImage scene_image(SceneRenderer& renderer);

}  // namespace waterlight
