#include "app/view/panels.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "sim/error.hpp"

namespace waterlight {

namespace {

const ImVec4 warning_colour{1.0F, 0.55F, 0.35F, 1.0F};

void text(const std::string& line) { ImGui::TextUnformatted(line.c_str()); }

void wrapped(const std::string& line, const ImVec4& colour) {
    if (line.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextWrapped("%s", line.c_str());
    ImGui::PopStyleColor();
}

// A length that the mouse pulls by a hundredth of the scale for each pixel.
void drag(const char* label, double& value_m, double low_m, double scale_m) {
    auto shown = static_cast<float>(value_m);
    if (ImGui::DragFloat(label, &shown, static_cast<float>(0.01 * scale_m), 0, 0, "%.3f"))
        value_m = std::max(static_cast<double>(shown), low_m);
}

}  // namespace

Panels::Panels(Session& session, ViewState& state, DeviceWish device, const std::filesystem::path& scenario)
    : session_(session), state_(state), device_(std::move(device)) {
    const std::string file = scenario.stem().string() + "_changed.toml";
    std::copy_n(file.begin(), std::min(file.size(), file_.size() - 1), file_.begin());
}

void Panels::draw(const Snapshot& snapshot, const SessionStatus& status, const FrameTimes& times) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float letter = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({letter, letter}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({26 * letter, std::min(52 * letter, screen.y - 2 * letter)}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("waterlight")) {
        ImGui::PushItemWidth(-10 * letter);
        draw_play(snapshot, status);
        draw_messages(status);
        if (!snapshot.scenario->objects.empty()) ImGui::TextDisabled("objects: their light and shadow alone");
        if (ImGui::CollapsingHeader("Time and error", ImGuiTreeNodeFlags_DefaultOpen))
            draw_costs(snapshot, status, times);
        if (ImGui::CollapsingHeader("Mouse")) draw_mouse();
        if (ImGui::CollapsingHeader("Sun and rain", ImGuiTreeNodeFlags_DefaultOpen)) {
            draw_sun(snapshot, status);
            draw_rain(snapshot, status);
        }
        if (ImGui::CollapsingHeader("Waves", ImGuiTreeNodeFlags_DefaultOpen)) draw_water(snapshot, status);
        if (ImGui::CollapsingHeader("Light", ImGuiTreeNodeFlags_DefaultOpen)) {
            draw_floor(snapshot, status);
            draw_beams(snapshot, status);
        }
        if (ImGui::CollapsingHeader("Picture")) draw_picture(snapshot);
        if (ImGui::CollapsingHeader("Save")) draw_save();
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

void Panels::draw_play(const Snapshot& snapshot, const SessionStatus& status) {
    if (ImGui::Button(status.plays ? "Pause" : "Play")) status.plays ? session_.pause() : session_.play();
    ImGui::SameLine();
    if (ImGui::Button("Step")) session_.step();
    ImGui::SameLine();
    if (ImGui::Button("Reset")) chosen_ = session_.reset();
    ImGui::SameLine();
    text(fmt::format("t = {:.2f} s", snapshot.time_s));
    speed_.follow(static_cast<float>(status.speed), status);
    if (ImGui::SliderFloat("speed", &speed_.value, 0.01F, 10, "%.2f", ImGuiSliderFlags_Logarithmic))
        speed_.sent = session_.speed(speed_.value);
    speed_.is_held = ImGui::IsItemActive();
    const bool is_late = status.plays && status.rate > 0 && status.rate < 0.9 * status.speed;
    const std::string rate = fmt::format("{:.2f} s of water a second", status.rate);
    is_late ? ImGui::TextColored(warning_colour, "%s", rate.c_str()) : ImGui::TextDisabled("%s", rate.c_str());
}

void Panels::draw_messages(const SessionStatus& status) const {
    if (status.is_building) text("building what was chosen ...");
    wrapped(status.failure, warning_colour);
    if (status.refused >= std::max<Session::Ticket>(chosen_, 1)) wrapped(status.refusal, warning_colour);
    wrapped(status.note, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    wrapped(state_.said, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
}

void Panels::draw_mouse() {
    int tool = static_cast<int>(state_.tool);
    ImGui::RadioButton("left click drops", &tool, static_cast<int>(Tool::drop));
    ImGui::SameLine();
    ImGui::RadioButton("drags a ball", &tool, static_cast<int>(Tool::sphere));
    state_.tool = static_cast<Tool>(tool);
    constexpr double least_m = 0.001;
    drag("drop's radius (m)", state_.drop_radius_m, least_m, state_.drop_radius_m);
    drag("drop's height (m)", state_.drop_height_m, -state_.drop_radius_m, state_.drop_radius_m);
    drag("ball's radius (m)", state_.sphere_radius_m, least_m, state_.sphere_radius_m);
    ImGui::TextDisabled(
        "shift + drag: ball; right drag: round;\nmiddle: shift; control + right: look;\nwheel: nearer; "
        "W A S D Q E: fly;\nspace, ., R: play, step, reset;\nP or F2: picture; escape: close");
}

void Panels::draw_save() {
    ImGui::InputText("file", file_.data(), file_.size());
    if (ImGui::Button("Save as scenario")) {
        try {
            session_.save(file_.data());
            state_.said = fmt::format("saved {}", file_.data());
        } catch (const WorldError& error) {
            state_.said = error.what();
        }
    }
    ImGui::SameLine();
    if (ImGui::Button("Screenshot")) state_.wants_screenshot = true;
}

}  // namespace waterlight
