// Pictures in a window: a chain of images that the window system shows one after the other.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

#include "gpu/context.hpp"
#include "gpu/interface_drawing.hpp"
#include "gpu/raster.hpp"

struct VkSurfaceKHR_T;

namespace waterlight::gpu {

/// Makes the place of a window that pictures are shown in. Called again where the window system loses it.
using MakeSurface = std::function<VkSurfaceKHR_T*(VkInstance_T*)>;

class Presenter {
  public:
    /// `context` was opened for the window system of the surface. The letters of `atlas` are copied. Throws Error where
    /// the device cannot show pictures in this window.
    Presenter(std::shared_ptr<Context> context, MakeSurface make_surface, const InterfaceAtlas& atlas);
    ~Presenter();
    Presenter(Presenter&&) noexcept;
    Presenter& operator=(Presenter&&) noexcept;

    /// Shows a picture of 8-bit sRGB, scaled to the window, and the interface over it; waits until the device is done
    /// with both. `size` is the window's, pixels. Returns whether it was shown: not where the window has no area or
    /// changes size at this moment, and the next call shows it again. Throws Error where the device is lost.
    bool present(const Target& picture, const InterfaceDrawing& drawing, std::array<std::uint32_t, 2> size);

    struct Impl;

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight::gpu
