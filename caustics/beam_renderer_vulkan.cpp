#include "caustics/beam_renderer_vulkan.hpp"

#include <optional>

#include "caustics/beam_image_vulkan.hpp"
#include "caustics/beam_volume_vulkan.hpp"

namespace waterlight {

namespace {

/// Each half is made when first used: fields need no device that draws.
class BeamRendererVulkan final : public BeamRenderer {
  public:
    explicit BeamRendererVulkan(std::shared_ptr<gpu::Context> context) : context_(std::move(context)) {}

    std::string_view backend() const override { return "vulkan"; }
    void draw(const BeamImageSettings& settings, const Beams& beams, BeamImage& image) override {
        if (!image_) image_.emplace(context_);
        image_->draw(settings, beams, image);
        times_ = image_->stage_times();
    }
    void fill(const Beams& beams, glm::ivec3 cells, BeamVolume& volume) override {
        if (!volume_) volume_.emplace(context_);
        volume_->fill(beams, cells, volume);
        times_ = volume_->stage_times();
    }
    std::vector<StageTime> stage_times() const override { return times_; }

  private:
    std::shared_ptr<gpu::Context> context_;
    std::optional<BeamImageVulkan> image_;
    std::optional<BeamVolumeVulkan> volume_;
    std::vector<StageTime> times_;
};

}  // namespace

std::unique_ptr<BeamRenderer> make_beam_renderer_vulkan(std::shared_ptr<gpu::Context> context) {
    return std::make_unique<BeamRendererVulkan>(std::move(context));
}

}  // namespace waterlight
