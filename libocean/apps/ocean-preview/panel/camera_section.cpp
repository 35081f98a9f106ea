// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
void draw_camera_section(const LiveScene& scene, CameraControl& camera, PanelState& state) {
    static constexpr const char* kModes[] = {"fly", "walk", "orbit", "float"};
    ImGui::PushItemWidth(panel_length(kWidgetWidth));
    int mode = static_cast<int>(camera.mode);
    if (ImGui::Combo("Camera (C)", &mode, kModes, camera_modes(scene.kind()))) {
        camera.mode = static_cast<CameraMode>(mode);
        state.requests.touched = true;
    }
    slider(state, "Field of view", camera.camera().field_of_view, 5.0f, 120.0f, "%.0f deg");
    slider(state, "Height of the eye", camera.camera().eye[2], 0.3f, 5000.0f, "%.1f m",
           ImGuiSliderFlags_Logarithmic);
    ImGui::PopItemWidth();
    if (ImGui::Button("Back to the start")) state.requests.reset_camera = true;
    ImGui::TextDisabled("W A S D, Q E: move   Shift: fast\ndrag: turn   wheel: zoom");
}

}  // namespace ocean::app
