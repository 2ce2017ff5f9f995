// The texts of the shaders (render/shaders) as a class: what a pass of the Vulkan picture reads from its buffers are
// members here, so that both pictures have one text of sky, floor, walls and scattered light.
#pragma once

#include <optional>

#include "caustics/kernels/interface.hpp"
#include "caustics/kernels/phase_table.hpp"
#include "caustics/kernels/surface_lookup.hpp"
#include "render/kernels/ambient.hpp"
#include "render/kernels/finish.hpp"
#include "render/kernels/sky.hpp"
#include "render/kernels/view_ray.hpp"
#include "render/scene_block.hpp"
#include "render/traced/shader_words.hpp"
#include "render/variant.hpp"

namespace waterlight::f32 {

#include "render/shaders/variant_words.glsl"

/// Cheap to copy; each thread has its own. What it points to is borrowed.
class SceneText {
  public:
    bool in_water = false, wall_x = false, wall_y = false, wraps_x = false, wraps_y = false, uneven = false;
    int map_colours = 0;
    bool wall_maps = false;
    int scatter = SCATTER_NONE, floor_pattern = 0, wall_pattern = 0, deck_pattern = 0, overlay = OVERLAY_NONE;
    bool uniform_sky = false, coarse = false, outside = false;
    PassParameters p{};
    SceneParameters s{};
    const vec4* surface_cells = nullptr;
    const float* light = nullptr;
    const float* medium = nullptr;
    const float* ground = nullptr;
    const vec4* palette = nullptr;
    const float* beams = nullptr;  ///< the picture of beams, or null

    vec4 surface_cell(int k) const { return surface_cells[k]; }
    float light_value(int k) const { return light[k]; }
    float medium_value(int k) const { return medium[k]; }
    float ground_value(int k) const { return ground[k]; }
    float beam_value(int k) const { return beams[k]; }

    struct PerPixel {
        vec3 right{0, 0, 0}, up{0, 0, 0};
        PerPixel() = default;
        PerPixel(vec3 a, vec3 b) : right(a), up(b) {}
    };

    // What is needed comes first:
    // clang-format off
#include "render/shaders/sight.glsl"
#include "render/shaders/ground_cells.glsl"
#include "render/shaders/sky.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"
#include "render/shaders/surface_cells.glsl"
#include "render/shaders/dry.glsl"
#include "render/shaders/sun_in_water.glsl"
#include "render/shaders/beam_light.glsl"
    // clang-format on
};

#undef SCATTER_NONE
#undef SCATTER_FLAT
#undef SCATTER_VOLUME
#undef OVERLAY_NONE
#undef OVERLAY_ELEVATION
#undef OVERLAY_FLOOR
#undef OVERLAY_ERROR
#undef KIND_FLOOR
#undef KIND_WALLS
#undef KIND_DECK

}  // namespace waterlight::f32

namespace waterlight {

/// What the text reads of a scene.
class SceneData {
  public:
    SceneData(const Scene& scene, const Look& look, const Camera& camera);
    /// Takes light in the water from this volume, which must outlive it, where things in it are lit.
    void light_things_by(const BeamVolume& volume) { things_ = &volume; }
    /// Valid as long as this.
    f32::SceneText text() const;
    /// The same with the volume of light_things_by(); none where there is none.
    std::optional<f32::SceneText> things_text() const;
    const SurfaceLevels& surface() const { return surface_; }

  private:
    Variant variant_;
    glm::ivec2 size_;
    SurfaceLevels surface_;
    LightMaps maps_;
    std::vector<float> medium_, ground_;
    SceneParameters scene_{};
    const BeamVolume* things_ = nullptr;
    const BeamImage* beams_ = nullptr;
    PassParameters view_{};
};

}  // namespace waterlight
