// The panels of the picture, and of what everything takes and how wrong it is.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/view/panels.hpp"

namespace waterlight {

namespace {

// In the order of Overlay.
constexpr std::array overlay_names{"none", "elevation", "irradiance", "error"};
constexpr std::array overlay_units{"", "m", "W/m\xc2\xb2", "W/m\xc2\xb2"};
constexpr std::array sample_counts{1, 2, 4, 8};
constexpr std::array sample_names{"1", "2", "4", "8"};
constexpr std::array reduction_names{"quick", "whole", "1/2", "1/3", "1/4"};

// The field's own ends; about 0 where it has both signs.
OverlayRange range_of(const Field<float>& field, bool is_signed) {
    if (field.empty()) return {};
    const auto [low, high] = std::minmax_element(field.values().begin(), field.values().end());
    const double most = std::max({std::abs(double(*low)), std::abs(double(*high)), 1e-9});
    return is_signed ? OverlayRange{-most, most} : OverlayRange{0, most};
}

OverlayRange fitted(const Snapshot& snapshot, Overlay overlay) {
    switch (overlay) {
        case Overlay::elevation:
            return range_of(snapshot.surface.elevation, true);
        case Overlay::irradiance:
            return range_of(snapshot.floor.irradiance, false);
        case Overlay::error:
            return range_of(snapshot.floor_error, true);
        case Overlay::none:
            break;
    }
    return {};
}

std::string percent(double share) { return std::isnan(share) ? "-" : fmt::format("{:.2g} %", 100 * share); }

void row(const char* stage, double ms, const std::string& error = "") {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(stage);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(ms > 0 ? fmt::format("{:8.2f}", ms).c_str() : "       -");
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(error.c_str());
}

}  // namespace

void Panels::draw_picture(const Snapshot& snapshot) {
    Look& look = state_.look;
    draw_overlay(snapshot);
    const auto* found = std::find(sample_counts.begin(), sample_counts.end(), look.samples);
    auto samples = static_cast<int>(found - sample_counts.begin());
    if (ImGui::Combo("samples a pixel", &samples, sample_names.data(), sample_names.size()))
        look.samples = sample_counts[static_cast<std::size_t>(samples)];
    ImGui::Combo("size", &state_.reduction, reduction_names.data(), reduction_names.size());
    bool is_auto = !look.exposure_w_m2_sr;
    if (ImGui::Checkbox("exposure of white in sun and sky", &is_auto))
        look.exposure_w_m2_sr = is_auto ? std::nullopt : std::optional<double>(300);
    if (is_auto) return;
    auto exposure = static_cast<float>(*look.exposure_w_m2_sr);
    if (ImGui::SliderFloat("white (W/(m\xc2\xb2 sr))", &exposure, 1, 3000, "%.0f", ImGuiSliderFlags_Logarithmic))
        look.exposure_w_m2_sr = exposure;
}

void Panels::draw_overlay(const Snapshot& snapshot) {
    Look& look = state_.look;
    auto overlay = static_cast<int>(look.overlay);
    bool is_new = ImGui::Combo("overlay", &overlay, overlay_names.data(), overlay_names.size());
    look.overlay = static_cast<Overlay>(overlay);
    if (look.overlay == Overlay::none) return;
    if (look.overlay == Overlay::error && !snapshot.has.floor_error)
        ImGui::TextDisabled("tick \"estimate errors\" for this");
    std::array ends{static_cast<float>(look.range.low), static_cast<float>(look.range.high)};
    const char* unit = overlay_units[static_cast<std::size_t>(overlay)];
    if (ImGui::DragFloat2(fmt::format("from, to ({})", unit).c_str(), ends.data(), 0.01F * (ends[1] - ends[0])) &&
        ends[0] < ends[1])
        look.range = {ends[0], ends[1]};
    is_new = ImGui::Button("fit the colours") || is_new;
    if (is_new) look.range = fitted(snapshot, look.overlay);
}

void Panels::draw_costs(const Snapshot& snapshot, const SessionStatus& status, const FrameTimes& times) {
    const StageCosts& costs = snapshot.costs;
    if (ImGui::BeginTable("costs", 3, ImGuiTableFlags_BordersInnerH)) {
        ImGui::TableSetupColumn("stage");
        ImGui::TableSetupColumn("ms a frame");
        ImGui::TableSetupColumn("error");
        ImGui::TableHeadersRow();
        row("waves", costs.waves_ms, percent(snapshot.estimates.waves_rmse));
        row("floor", costs.floor_ms, percent(snapshot.estimates.floor_rmse));
        row("walls", costs.walls_ms);
        row("beams", costs.beams_ms);
        if (costs.estimate_ms > 0) estimate_ms_ = costs.estimate_ms;
        row("estimate", snapshot.scenario->accuracy.estimate ? estimate_ms_ : 0);
        row("picture", times.draw_ms);
        row("window", times.present_ms);
        ImGui::EndTable();
    }
    estimates_.follow(snapshot.scenario->accuracy.estimate, status);
    if (ImGui::Checkbox("estimate errors", &estimates_.value)) {
        choose(fmt::format("accuracy.estimate={}", estimates_.value));
        estimates_.sent = chosen_;
    }
    ImGui::SameLine();
    ImGui::TextDisabled("%.0f pictures/s, %d x %d", times.shown_hz, times.picture.x, times.picture.y);
    if (!times.passes.empty() && ImGui::TreeNode("passes of the picture")) {
        for (const StageTime& pass : times.passes)
            ImGui::Text("%-16s %7.2f ms", pass.stage.c_str(), 1e3 * pass.seconds);
        ImGui::TreePop();
    }
}

}  // namespace waterlight
