// The panels of what the session computes.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "app/view/panels.hpp"

namespace waterlight {

namespace {

// As a scenario names them, in the order of their enumerations.
constexpr std::array model_names{"auto", "linear", "airy", "shallow-water", "prescribed"};
constexpr std::array footprint_names{"adaptive", "pixel"};
constexpr std::array backend_names{"auto", "cpu", "vulkan"};

// Whether another was chosen.
bool combo(const char* label, int& value, std::span<const char* const> names) {
    return ImGui::Combo(label, &value, names.data(), static_cast<int>(names.size()));
}

// Two whole numbers, taken when the user has done with both keys and field.
bool pair(const char* label, Draft<std::array<int, 2>>& draft) {
    ImGui::InputInt2(label, draft.value.data());
    draft.is_held = ImGui::IsItemActive();
    return ImGui::IsItemDeactivatedAfterEdit();
}

std::string as_list(const std::array<int, 2>& values) { return fmt::format("[{},{}]", values[0], values[1]); }

std::array<int, 2> as_array(glm::ivec2 v) { return {v.x, v.y}; }

// Drops a square metre and second that fall at this time; 0 where none do.
double rain_of(const Scenario& scenario, double time_s) {
    double rate = 0;
    for (const Source& source : scenario.waves.sources)
        if (const auto* rain = std::get_if<Rain>(&source))
            if (rain->start_s <= time_s && time_s < rain->end_s) rate += rain->drops_per_m2_s;
    return rate;
}

}  // namespace

void Panels::choose(std::string override_text) { chosen_ = session_.set({std::move(override_text)}); }

void Panels::draw_sun(const Snapshot& snapshot, const SessionStatus& status) {
    const Sun& sun = snapshot.scenario->light;
    elevation_.follow(static_cast<float>(sun.elevation_deg), status);
    azimuth_.follow(static_cast<float>(sun.azimuth_deg - 360 * std::floor(sun.azimuth_deg / 360)), status);
    const bool is_higher = ImGui::SliderFloat("sun's elevation", &elevation_.value, 1, 90, "%.0f\xc2\xb0");
    elevation_.is_held = ImGui::IsItemActive();
    const bool is_elsewhere = ImGui::SliderFloat("sun's azimuth", &azimuth_.value, 0, 360, "%.0f\xc2\xb0");
    azimuth_.is_held = ImGui::IsItemActive();
    if (!is_higher && !is_elsewhere) return;
    chosen_ = session_.sun(elevation_.value, azimuth_.value);
    elevation_.sent = azimuth_.sent = chosen_;
}

void Panels::draw_rain(const Snapshot& snapshot, const SessionStatus& status) {
    const double rate = rain_of(*snapshot.scenario, snapshot.time_s);
    rains_.follow(rate > 0, status);
    if (rate > 0) rain_rate_.follow(static_cast<float>(rate), status);
    if (rain_rate_.value <= 0) rain_rate_.value = 1;
    const bool is_switched = ImGui::Checkbox("rain", &rains_.value);
    ImGui::SameLine();
    const bool is_slid =
        ImGui::SliderFloat("drops/(m\xc2\xb2 s)", &rain_rate_.value, 0.02F, 50, "%.2f", ImGuiSliderFlags_Logarithmic);
    rain_rate_.is_held = ImGui::IsItemActive();
    if (!is_switched && !(is_slid && rains_.value)) return;
    chosen_ = session_.rain(rains_.value ? std::optional<double>(rain_rate_.value) : std::nullopt);
    rains_.sent = rain_rate_.sent = chosen_;
}

void Panels::draw_water(const Snapshot& snapshot, const SessionStatus& status) {
    model_.follow(static_cast<int>(snapshot.scenario->waves.model), status);
    if (combo("model", model_.value, model_names)) {
        choose(fmt::format("waves.model={}", model_names[static_cast<std::size_t>(model_.value)]));
        model_.sent = chosen_;
    }
    cells_.follow({snapshot.surface.grid.nx, snapshot.surface.grid.ny}, status);
    if (pair("cells", cells_)) {
        choose("domain.cells=" + as_list(cells_.value));
        cells_.sent = chosen_;
    }
    draw_backend(snapshot, status);
}

void Panels::draw_backend(const Snapshot& snapshot, const SessionStatus& status) {
    backend_.follow(static_cast<int>(snapshot.backend.backend), status);
    if (combo("back-end", backend_.value, backend_names)) {
        DeviceWish wish = device_;
        wish.backend = static_cast<Backend>(backend_.value);
        if (wish.backend == Backend::cpu) wish.device.clear();
        chosen_ = backend_.sent = session_.set_device(wish);
    }
    if (!snapshot.backend.device.empty()) ImGui::TextDisabled("%s", snapshot.backend.device.c_str());
}

void Panels::draw_floor(const Snapshot& snapshot, const SessionStatus& status) {
    has_floor_.follow(snapshot.has.floor, status);
    if (ImGui::Checkbox("light on the floor", &has_floor_.value))
        chosen_ = has_floor_.sent = session_.compute(LightPart::floor, has_floor_.value);
    const std::optional<FloorSection>& floor = snapshot.scenario->floor;
    if (!floor) return;
    method_.follow(static_cast<int>(floor->method), status);
    if (combo("method", method_.value, floor_method_names)) {
        choose(fmt::format("caustics.floor.method={}", floor_method_names[static_cast<std::size_t>(method_.value)]));
        method_.sent = chosen_;
    }
    pixels_.follow(as_array(floor->pixels), status);
    if (pair("floor's pixels", pixels_)) {
        choose("caustics.floor.pixels=" + as_list(pixels_.value));
        pixels_.sent = chosen_;
    }
    if (floor->method != FloorMethod::two_pass) return;
    footprint_.follow(static_cast<int>(floor->footprint), status);
    if (combo("footprint", footprint_.value, footprint_names)) {
        choose(fmt::format("caustics.floor.footprint={}", footprint_names[static_cast<std::size_t>(footprint_.value)]));
        footprint_.sent = chosen_;
    }
    draw_window(*floor, status);
}

void Panels::draw_window(const FloorSection& floor, const SessionStatus& status) {
    window_is_auto_.follow(!floor.window, status);
    if (floor.window) window_.follow({floor.window->samples, floor.window->channels}, status);
    if (window_.value[0] == 0) window_.value = {FloorWindow().samples, FloorWindow().channels};
    bool is_new = ImGui::Checkbox("window that holds all light", &window_is_auto_.value);
    if (!window_is_auto_.value) is_new = pair("samples, channels", window_) || is_new;
    if (!is_new) return;
    choose(window_is_auto_.value
               ? "caustics.floor.window=auto"
               : fmt::format("caustics.floor.window={{samples={},channels={}}}", window_.value[0], window_.value[1]));
    window_is_auto_.sent = window_.sent = chosen_;
}

void Panels::draw_beams(const Snapshot& snapshot, const SessionStatus& status) {
    has_walls_.follow(snapshot.has.walls, status);
    if (ImGui::Checkbox("on the walls", &has_walls_.value))
        chosen_ = has_walls_.sent = session_.compute(LightPart::walls, has_walls_.value);
    ImGui::SameLine();
    has_beams_.follow(snapshot.has.beams || snapshot.has.volume, status);
    if (ImGui::Checkbox("beams in the water", &has_beams_.value))
        chosen_ = has_beams_.sent = session_.compute(LightPart::beams, has_beams_.value);
    const std::optional<BeamsSection>& beams = snapshot.scenario->beams;
    if (!beams) return;
    grid_.follow(as_array(beams->grid), status);
    if (pair("beams' grid", grid_)) {
        choose("caustics.beams.grid=" + as_list(grid_.value));
        grid_.sent = chosen_;
    }
}

}  // namespace waterlight
