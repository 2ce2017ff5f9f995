// A window of the desktop, its keys and its mouse.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "gpu/context.hpp"
#include "gpu/presenter.hpp"

struct GLFWwindow;

namespace waterlight {

enum class Key { other, space, period, escape, f2, a, d, e, p, q, r, s, w };
enum class MouseButton { left, right, middle, other };

/// What the user did, in order. Places are pixels of the window, from its upper left corner.
struct WindowEvent {
    enum class Type { key, press, release, move, scroll };
    Type type = Type::move;
    glm::dvec2 at{0, 0};  ///< of the mouse
    Key key = Key::other;
    int key_code = -1;  ///< GLFW's number of any key
    MouseButton button = MouseButton::left;
    bool shift = false, control = false;  ///< held down
    double scroll = 0;                    ///< notches, away from the user > 0
};

/// One at a time, on the program's first thread.
class Window {
  public:
    /// Opens a window of so many pixels, each >= 1. Throws WorldError where there is no display or it shows no Vulkan.
    Window(const std::string& title, glm::ivec2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Pixels; zero while it is minimised or hidden.
    glm::ivec2 size() const;
    /// How many pixels large what is one pixel on a common screen.
    double scale() const;
    /// Pictures a second that the screen shows.
    double refresh_hz() const;
    /// The user wants it closed.
    bool closing() const;
    bool is_held(Key key) const;

    /// What happened since the last call; waits for it up to `wait_s`, >= 0.
    std::vector<WindowEvent> events(double wait_s = 0);

    /// For a gpu::Context that shows pictures here, and its gpu::Presenter, which must not outlive the window.
    gpu::WindowSystem system() const;
    gpu::MakeSurface surface() const;
    GLFWwindow* handle() const;

    struct Impl;

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight
