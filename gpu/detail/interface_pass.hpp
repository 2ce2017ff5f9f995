// Draws an interface into an image of a window.
#pragma once

#include <optional>

#include "gpu/detail/vulkan.hpp"
#include "gpu/interface_drawing.hpp"

namespace waterlight::gpu {

class InterfacePass {
  public:
    InterfacePass(std::shared_ptr<Context> context, const InterfaceAtlas& atlas);

    /// Takes the drawing over; not while a list runs that draws the one before.
    void load(const InterfaceDrawing& drawing);
    /// Draws what was loaded into the rendering that `list` has begun, of an image of so many pixels.
    void draw(const vk::raii::CommandBuffer& list, vk::Format format, vk::Extent2D size);

  private:
    void reserve(std::optional<Buffer>& buffer, std::size_t bytes);

    std::shared_ptr<Context> context_;
    Commands commands_;
    Buffer atlas_;
    std::array<std::int32_t, 2> atlas_size_;
    std::optional<Buffer> corners_, indices_;
    std::vector<InterfaceBatch> batches_;
    Binding binding_;
    vk::Format format_ = vk::Format::eUndefined;  // that the pipeline draws into
    vk::raii::Pipeline pipeline_{nullptr};
};

}  // namespace waterlight::gpu
