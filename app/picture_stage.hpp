// The part of a run that draws the scene: output.image = true. On a Vulkan device; with objects or a lamp, traced on
// the CPU.
#pragma once

#include <array>
#include <memory>

#include "app/floor_stage.hpp"
#include "app/outputs.hpp"
#include "render/scene_renderer.hpp"

namespace waterlight {

/// The Vulkan device is the back-end's where that is one. The scenario has a camera and outlives the stage.
class PictureStage {
  public:
    /// `model` gives the ground where it has one. Throws InputError where the camera is in the ground or an overlay's
    /// range is not known, gpu::Error where no device can draw.
    PictureStage(const Scenario& scenario, const BuiltModel& model, const BackendDecision& backend,
                 const DeviceWish& wish);

    /// Depends on this frame alone. Throws gpu::Error where the device fails.
    void draw(const FrameView& frame);
    /// The last one.
    const ScenePicture& picture() const { return picture_; }
    /// The name of what draws.
    std::string device() const;
    /// Of the Vulkan device; empty where none draws.
    std::vector<std::string> validation_messages() const;

  private:
    Scene scene_of(const FrameView& frame);
    void require_above_ground() const;
    void trace(const FrameView& frame);

    const Scenario& scenario_;
    Look look_;
    Field<float> ground_m_;  ///< empty: the flat floor
    std::array<Field<float>, 3> colours_;
    std::shared_ptr<gpu::Context> context_;    ///< none where pictures are traced
    std::unique_ptr<SceneRenderer> renderer_;  ///< as the context
    ScenePicture picture_;
};

}  // namespace waterlight
