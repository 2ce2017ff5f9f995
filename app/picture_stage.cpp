#include "app/picture_stage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/floor_colours.hpp"
#include "app/ground_heights.hpp"
#include "app/scene_image.hpp"
#include "caustics/beam_ground.hpp"
#include "gpu/error.hpp"
#include "render/traced/traced_picture.hpp"
#include "scenarios/combinations.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/resolve_light.hpp"
#include "scenarios/resolve_picture.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

std::shared_ptr<gpu::Context> context_for(const BackendDecision& backend, const DeviceWish& wish) {
    if (backend.context) return backend.context;
    try {
        return std::make_shared<gpu::Context>(
            gpu::ContextSettings{.device = wish.device, .validation = wish.validation});
    } catch (const gpu::Error& error) {
        throw gpu::Error(fmt::format("output.image: pictures of the scene are drawn by Vulkan: {}", error.what()));
    }
}

/// Whether finite values lie beyond the ends of the range.
Clipped clipped(std::span<const float> values, OverlayRange range) {
    Clipped beyond;
    for (const float v : values) {
        beyond.below |= v < range.low;
        beyond.above |= v > range.high;
    }
    return beyond;
}

Clipped clipped(const FrameView& frame, const Look& look) {
    switch (look.overlay) {
        case Overlay::elevation:
            return clipped(frame.surface.elevation.values(), look.range);
        case Overlay::irradiance:
            return clipped(frame.floor->irradiance.values(), look.range);
        case Overlay::error:
            return clipped(frame.floor_error->values(), look.range);
        case Overlay::none:
            break;
    }
    return {};
}

}  // namespace

PictureStage::PictureStage(const Scenario& scenario, const BuiltModel& model, const BackendDecision& backend,
                           const DeviceWish& wish)
    : scenario_(scenario),
      look_(look_of(scenario)),
      ground_m_(has_ground(scenario) ? ground_heights(scenario, model) : Field<float>()),
      context_(traces_pictures(scenario) ? nullptr : context_for(backend, wish)) {
    if (context_) renderer_ = std::make_unique<SceneRenderer>(context_);
    if (!ground_m_.empty()) require_above_ground();
}

void PictureStage::require_above_ground() const {
    const glm::dvec3 camera = scenario_.camera->camera.position_m;
    const glm::dvec2 size = scenario_.domain.size_m;
    if (camera.x < 0 || camera.x > size.x || camera.y < 0 || camera.y > size.y) return;
    const BeamGround ground(grid_of(scenario_), resolve_boundary(scenario_), ground_m_.clone());
    const double height = ground.height_m(glm::dvec2(camera));
    if (camera.z <= height)
        scenario_.origin.reject("camera.position_m", fmt::format("a height of {} m", camera.z),
                                fmt::format("above the ground there, at {} m", height));
}

Scene PictureStage::scene_of(const FrameView& frame) {
    Scene scene;
    scene.surface = &frame.surface;
    scene.depth_m = scenario_.domain.depth_m;
    if (!ground_m_.empty()) scene.ground_m = &ground_m_;
    if (scenario_.floor) scene.floor_plan = floor_settings(scenario_).plan;
    if (frame.floor) scene.floor = &frame.floor->irradiance;
    if (!frame.bands.empty() && look_.overlay == Overlay::none) {
        fill_colours(frame.bands, colours_);
        for (std::size_t c = 0; c < 3; ++c) scene.floor_rgb[c] = &colours_[c];
    }
    scene.walls = frame.walls;
    if (scenario_.walls) scene.wall_settings = wall_settings(scenario_);
    // What the camera above the water sees of scattered light; and what one in the water does.
    if (looks_from_air(scenario_))
        scene.volume = frame.volume;
    else
        scene.beams = frame.picture;
    scene.error = frame.floor_error;
    scene.sun = scenario_.light;
    scene.optics = scenario_.optics;
    return scene;
}

void PictureStage::draw(const FrameView& frame) {
    if (!renderer_) return trace(frame);
    renderer_->draw(scene_of(frame), look_, scenario_.camera->camera);
    picture_.image = scene_image(*renderer_);
    picture_.clipped = clipped(frame, look_);
}

void PictureStage::trace(const FrameView& frame) {
    TracedScene traced{scene_of(frame), scenario_.object_set, scenario_.lamp};
    if (scenario_.lamp) traced.scene.sun.irradiance_w_m2 = 0;
    TraceOptions options;
    options.samples = look_.samples * look_.samples;
    picture_.image = developed(trace_picture(traced, look_, scenario_.camera->camera, options));
    picture_.clipped = {};
}

std::string PictureStage::device() const {
    return context_ ? context_->device().name : processor_name() + ", which traces them";
}

std::vector<std::string> PictureStage::validation_messages() const {
    return context_ ? context_->validation_messages() : std::vector<std::string>();
}

}  // namespace waterlight
