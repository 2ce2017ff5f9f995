// One picture on its way: what its passes share.
#pragma once

#include <memory>
#include <vector>

#include "caustics/beam_buffers.hpp"
#include "render/scene_block.hpp"
#include "render/variant.hpp"

namespace waterlight {

/// The buffers of bindings 0 to 6 of every pass (render/shaders/scene.glsl), and beam_light.
struct SceneBuffers {
    Storage block, surface, light, medium, ground, copies, palette;
    Storage beams;  ///< of BeamImage
};

struct Frame {
    const Scene& scene;
    const Look& look;
    const Camera& camera;
    Variant variant;
    PassParameters view;  ///< the camera's part
    SurfaceLevels& surface;
    SceneBuffers& buffers;
    gpu::Commands& commands;
    gpu::Target& radiance;  ///< linear, in units of the exposure, with depths
    gpu::Target& picture;   ///< 8-bit
    std::uint64_t number;   ///< of pictures, from 1
    glm::dvec3 eye() const { return camera.position_m; }
};

}  // namespace waterlight
