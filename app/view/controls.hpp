// The mouse and the keys of a view: what they do to the camera and to the session.
#pragma once

#include <optional>

#include "app/view/session.hpp"
#include "app/view/view_state.hpp"
#include "render/window.hpp"

namespace waterlight {

/// Left click drops a ripple; left drag with shift, or with the tool sphere, drags a ball through the water. Right drag
/// goes round, with shift it shifts, with control it looks round; the wheel goes nearer. Space plays and pauses, `.`
/// steps, R starts again, P and F2 take a picture, Escape closes. W, A, S, D fly, Q and E down and up.
class Controls {
  public:
    /// Both must outlive this.
    Controls(Session& session, ViewState& state);

    /// `over_panel`: the mouse is over a panel, which then has what it does; `panel_takes_keys`: so it is with keys.
    void handle(const WindowEvent& event, const Snapshot& snapshot, bool over_panel, bool panel_takes_keys);
    /// After the events of a frame: sends where the ball is by now.
    void finish();
    /// Flies by the keys that are held, for so long.
    void fly(const Window& window, const Snapshot& snapshot, double seconds);

  private:
    enum class Drag { none, orbit, pan, look, sphere };
    void press(const WindowEvent& event, const Snapshot& snapshot);
    void release();
    void move(const WindowEvent& event, const Snapshot& snapshot);
    void key(Key key);
    glm::dvec2 pixel(glm::dvec2 at) const;

    Session& session_;
    ViewState& state_;
    Drag drag_ = Drag::none;
    MouseButton dragged_by_ = MouseButton::left;
    glm::dvec2 mouse_{0, 0};
    double sphere_level_m_ = 0;              // of its centre
    std::optional<glm::dvec3> sphere_at_m_;  // not sent yet
};

}  // namespace waterlight
