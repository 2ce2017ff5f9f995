// The panels of a view: what can be chosen, what it costs, and how wrong it is.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "app/view/draft.hpp"
#include "app/view/frame_times.hpp"
#include "app/view/session.hpp"
#include "app/view/view_state.hpp"

namespace waterlight {

/// Each widget shows what the session has, but while the user works on it or what he chose is on its way; so a choice
/// that is refused falls back by itself, and the reason stands on top.
class Panels {
  public:
    /// `session` and `state` must outlive this; `scenario` names the file that the view began with.
    Panels(Session& session, ViewState& state, DeviceWish device, const std::filesystem::path& scenario);

    /// Between Interface::begin() and end().
    void draw(const Snapshot& snapshot, const SessionStatus& status, const FrameTimes& times);

  private:
    // panels.cpp
    void draw_play(const Snapshot& snapshot, const SessionStatus& status);
    void draw_messages(const SessionStatus& status) const;
    void draw_mouse();
    void draw_save();
    // panels_settings.cpp
    void draw_sun(const Snapshot& snapshot, const SessionStatus& status);
    void draw_water(const Snapshot& snapshot, const SessionStatus& status);
    void draw_rain(const Snapshot& snapshot, const SessionStatus& status);
    void draw_floor(const Snapshot& snapshot, const SessionStatus& status);
    void draw_window(const FloorSection& floor, const SessionStatus& status);
    void draw_beams(const Snapshot& snapshot, const SessionStatus& status);
    void draw_backend(const Snapshot& snapshot, const SessionStatus& status);
    void choose(std::string override_text);
    // panels_picture.cpp
    void draw_picture(const Snapshot& snapshot);
    void draw_overlay(const Snapshot& snapshot);
    void draw_costs(const Snapshot& snapshot, const SessionStatus& status, const FrameTimes& times);

    Session& session_;
    ViewState& state_;
    DeviceWish device_;
    std::array<char, 512> file_{};  // to save to
    Session::Ticket chosen_ = 0;    // the last choice: a refusal of one before is no longer shown

    double estimate_ms_ = 0;  // of the last estimate: not every frame has one

    Draft<float> speed_, elevation_, azimuth_, rain_rate_;
    Draft<bool> rains_, has_floor_, has_beams_, has_walls_, estimates_, window_is_auto_;
    Draft<int> model_, method_, footprint_, backend_;
    Draft<std::array<int, 2>> cells_, pixels_, window_, grid_;
};

}  // namespace waterlight
