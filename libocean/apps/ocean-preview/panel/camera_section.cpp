// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <array>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
void draw_camera_section(LiveScene& scene, CameraControl& camera, PanelState& state) {
    static constexpr const char* kModes[] = {"fly", "walk", "orbit", "float"};
    ImGui::PushItemWidth(panel_length(kWidgetWidth));
    int mode = static_cast<int>(camera.mode);
    const CameraGround ground = scene->ground();
    if (ImGui::Combo("Camera (C)", &mode, kModes, camera_modes(ground))) {
        camera.mode = static_cast<CameraMode>(mode);
        state.requests.touched = true;
    }
    slider(state, "Field of view", camera.camera().field_of_view, 5.0f, 120.0f, "%.0f deg");
    std::array<double, 3>& eye = camera.camera().eye;
    // Over the ground, or over still water.
    const double level = ground.is_solid ? ground.height(eye[0], eye[1]) : 0.0;
    const double before = eye[2] - level;
    double height = before;
    slider(state, "Height of the eye", height, 0.3f, 5000.0f, "%.1f m",
           ImGuiSliderFlags_Logarithmic);
    if (height != before) eye[2] = level + height;
    ImGui::PopItemWidth();
    if (ImGui::Button("Back to the start")) state.requests.reset_camera = true;
    ImGui::TextDisabled("W A S D, Q E: move   Shift: fast\ndrag: turn   wheel: zoom");
}

}  // namespace ocean::app
