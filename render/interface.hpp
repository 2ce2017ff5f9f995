// Dear ImGui in a window: panels over a picture.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "gpu/interface_drawing.hpp"
#include "render/window.hpp"

namespace waterlight {

/// Between begin() and end() the functions of <imgui.h> draw panels. One at a time.
class Interface {
  public:
    /// From now on it hears what the window hears. Must not outlive it.
    explicit Interface(const Window& window);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// The letters that drawings refer to; lives as long as this.
    gpu::InterfaceAtlas atlas() const;

    /// `events` are those since the last call.
    void begin(std::span<const WindowEvent> events);
    /// What the panels look like. Valid until the next call.
    const gpu::InterfaceDrawing& end();

    /// Whether a panel lies under this pixel or holds the mouse.
    bool covers(glm::dvec2 at) const;
    /// Whether the user writes into a panel.
    bool takes_keys() const;

  private:
    std::vector<std::uint8_t> letters_;
    glm::ivec2 letters_size_{0, 0};
    gpu::InterfaceDrawing drawing_;
};

}  // namespace waterlight
