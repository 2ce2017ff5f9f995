#include "render/interface.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <backends/imgui_impl_glfw.h>

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

constexpr float letter_pixels = 13;  // the size that the built-in letters are drawn for

void choose_style(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.ScaleAllSizes(scale);
    style.WindowRounding = 4 * scale;
    style.Colors[ImGuiCol_WindowBg].w = 0.85F;
    style.AntiAliasedLinesUseTex = false;  // letters are taken texel by pixel, and lines of the atlas are smaller
}

gpu::InterfaceBatch batch_of(const ImDrawCmd& command, const ImDrawData& data, std::size_t first_index) {
    const auto pixel = [&](float x, float origin, float scale) {
        return static_cast<std::int32_t>(std::lround((x - origin) * scale));
    };
    const auto [origin, scale] = std::pair(data.DisplayPos, data.FramebufferScale);
    const ImVec4 clip = command.ClipRect;
    return {.clip_from = {pixel(clip.x, origin.x, scale.x), pixel(clip.y, origin.y, scale.y)},
            .clip_to = {pixel(clip.z, origin.x, scale.x), pixel(clip.w, origin.y, scale.y)},
            .first_index = static_cast<std::uint32_t>(first_index + command.IdxOffset),
            .indices = command.ElemCount};
}

void append(gpu::InterfaceDrawing& drawing, const ImDrawList& list, const ImDrawData& data) {
    const auto first_corner = static_cast<std::uint32_t>(drawing.corners.size());
    const std::size_t first_index = drawing.indices.size();
    const auto [origin, scale] = std::pair(data.DisplayPos, data.FramebufferScale);
    for (const ImDrawVert& v : list.VtxBuffer)
        drawing.corners.push_back(
            {(v.pos.x - origin.x) * scale.x, (v.pos.y - origin.y) * scale.y, v.uv.x, v.uv.y, v.col});
    for (const ImDrawIdx index : list.IdxBuffer) drawing.indices.push_back(first_corner + index);
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.UserCallback || command.ElemCount == 0) continue;
        drawing.batches.push_back(batch_of(command, data, first_index));
    }
}

}  // namespace

Interface::Interface(const Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // panels are where they were made, and no file is left behind
    io.BackendRendererName = "waterlight";
    const auto scale = static_cast<float>(window.scale());
    choose_style(scale);
    ImFontConfig font;
    font.SizePixels = std::floor(letter_pixels * scale);
    io.Fonts->AddFontDefault(&font);
    unsigned char* texels = nullptr;
    io.Fonts->GetTexDataAsAlpha8(&texels, &letters_size_.x, &letters_size_.y);
    letters_.assign(texels, texels + static_cast<std::ptrdiff_t>(letters_size_.x) * letters_size_.y);
    ImGui_ImplGlfw_InitForOther(window.handle(), true);
}

Interface::~Interface() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

gpu::InterfaceAtlas Interface::atlas() const {
    return {static_cast<std::uint32_t>(letters_size_.x), static_cast<std::uint32_t>(letters_size_.y), letters_};
}

// The library looks at what is held down now: a key that was pressed and let go between two frames is held for this
// one.
void Interface::begin(std::span<const WindowEvent> events) {
    ImGui_ImplGlfw_NewFrame();
    bool* const keys = ImGui::GetIO().KeysDown;
    std::vector<int> brief;
    for (const WindowEvent& event : events) {
        if (event.type != WindowEvent::Type::key || event.key_code < 0 || keys[event.key_code]) continue;
        keys[event.key_code] = true;
        brief.push_back(event.key_code);
    }
    ImGui::NewFrame();
    for (const int code : brief) keys[code] = false;
}

const gpu::InterfaceDrawing& Interface::end() {
    ImGui::Render();
    drawing_.corners.clear();
    drawing_.indices.clear();
    drawing_.batches.clear();
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i) append(drawing_, *data.CmdLists[i], data);
    return drawing_;
}

// The library's own answer is of the mouse's place in the last picture; a click may come before the next.
bool Interface::covers(glm::dvec2 at) const {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.ActiveId != 0) return true;
    const ImVec2 scale = context.IO.DisplayFramebufferScale;
    const ImVec2 place(static_cast<float>(at.x) / scale.x, static_cast<float>(at.y) / scale.y);
    return std::any_of(context.Windows.begin(), context.Windows.end(), [&](const ImGuiWindow* window) {
        const bool shown = window->Active && !window->Hidden && !(window->Flags & ImGuiWindowFlags_NoInputs);
        return shown && window->Rect().Contains(place);
    });
}

bool Interface::takes_keys() const { return ImGui::GetIO().WantTextInput; }

}  // namespace waterlight
