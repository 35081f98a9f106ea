// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "panel/panel.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

/// Draws warnings of the scene and the last message at the foot of the window, and the values of
/// the place under the mouse beside it.
void draw_message(LiveScene& scene, const PanelState& state) {
    if (!state.under_mouse.empty()) ImGui::SetTooltip("%s", state.under_mouse.c_str());
    std::string text;
    if (state.shown) {
        for (const std::string& warning : scene->warnings()) text += warning + "\n";
    }
    if (state.shown && !state.left_out.empty()) text += state.left_out + "\n";
    text += state.message;
    if (text.empty()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float margin = panel_length(kPanelMargin);
    ImGui::SetNextWindowPos({size.x - margin, size.y - margin}, ImGuiCond_Always, {1.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.7f);
    ImGui::Begin("message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(std::max(panel_length(200.0f), 0.6f * size.x));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

/// Places the panel at its first frame beside the picture. After a change of scale it keeps the
/// place that the user gave it, and grows with its letters as far as the window has room.
void place_panel(PanelPlace& place) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float margin = panel_length(kPanelMargin);
    const float least = panel_length(200.0f);
    const auto within = [&](float length, float whole) {
        return std::min(length, std::max(least, whole - 2.0f * margin));
    };
    const float letters = ImGui::GetFontSize();
    if (letters == place.letters) return;
    const bool is_first = place.letters == 0.0f;
    const float times = is_first ? 1.0f : letters / place.letters;
    if (is_first) {
        place.corner = {margin, margin};
        place.wanted = {panel_length(kPanelWidth) - 2.0f * margin, window.y};
    } else {
        // A part that had no room before may have it now, unless the user chose the size.
        if (place.size != place.fitted) place.wanted = place.size;
        for (float& length : place.wanted) length *= times;
    }
    place.letters = letters;
    place.fitted = {within(place.wanted[0], window.x), within(place.wanted[1], window.y)};
    const auto inside = [&](int axis, float whole) {
        return std::clamp(times * place.corner[static_cast<std::size_t>(axis)], 0.0f,
                          std::max(0.0f, whole - place.fitted[static_cast<std::size_t>(axis)]));
    };
    ImGui::SetNextWindowPos({inside(0, window.x), inside(1, window.y)});
    ImGui::SetNextWindowSize({place.fitted[0], place.fitted[1]});
}

void draw_search(PanelState& state) {
    char search[64] = {};
    std::strncpy(search, state.search.c_str(), sizeof search - 1);
    ImGui::SetNextItemWidth(panel_length(kWidgetWidth));
    if (ImGui::InputText("Search (/)", search, sizeof search)) state.search = search;
}

void draw_sections(LiveScene& scene, CameraControl& camera, PanelState& state) {
    LiveSea* const sea = scene->performed();
    if (sea != nullptr) draw_transport(*sea, state);
    draw_readings(scene, state);
    draw_file_buttons(scene, state);
    draw_open_buttons(scene, state);
    if (ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen)) {
        draw_picture_section(scene, state);
    }
    if (ImGui::CollapsingHeader("Camera")) draw_camera_section(scene, camera, state);
    if (sea != nullptr && ImGui::CollapsingHeader("Bridge")) {
        draw_bridge_section(state.bridge, state.requests);
    }
    ImGui::Separator();
    draw_search(state);
    draw_choices(scene, state);
    scene->draw_parameters(scene, state);
}

}  // namespace

void draw_panel(LiveScene& scene, CameraControl& camera, PanelState& state) {
    draw_message(scene, state);
    if (!state.shown) return;
    place_panel(state.place);
    const std::string title = capitalised(scene.row().kind) + " (Tab hides)###panel";
    const bool is_open = ImGui::Begin(title.c_str());
    state.place.corner = {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y};
    if (is_open) {
        state.place.size = {ImGui::GetWindowSize().x, ImGui::GetWindowSize().y};
        draw_sections(scene, camera, state);
    }
    ImGui::End();
}

}  // namespace ocean::app
