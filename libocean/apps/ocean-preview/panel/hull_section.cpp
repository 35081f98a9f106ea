// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows for a hull that a hand drives, and for the crest that a click on the water places.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "ocean/internal/hull_rules.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

void draw_driven(HullDrive& hull, double time, PanelState& state) {
    const HullDrive::Pose now = hull.pose(time);
    ImGui::Text("%.1f m/s   heading %.0f degrees   x %.0f  y %.0f m", now.course.speed,
                now.course.heading, now.x, now.y);
    TrackCourse course = hull.wanted();
    const TrackCourse before = course;
    slider(state, "Speed of the hull", course.speed, 0.0f, static_cast<float>(kMaxHullSpeed),
           "%.1f m/s", ImGuiSliderFlags_Logarithmic);
    tooltip("Up and Down; a gamepad's left stick");
    slider(state, "Heading", course.heading, -180.0f, 180.0f, "%.0f degrees");
    tooltip("Left and Right turn as long as they are held");
    if (!(course == before)) hull.want(course);
}

}  // namespace

void draw_hull_section(LiveSea& sea, PanelState& state) {
    if (!ImGui::CollapsingHeader("Drive a hull")) return;
    ImGui::PushItemWidth(panel_length(kWidgetWidth));
    const std::size_t hulls = sea.sea().parameters.hulls.size();
    state.hull = std::min(state.hull, std::max<std::size_t>(hulls, 1) - 1);
    if (hulls > 1) {
        int number = static_cast<int>(state.hull);
        if (ImGui::SliderInt("Hull", &number, 0, static_cast<int>(hulls) - 1)) {
            state.hull = static_cast<std::size_t>(number);
        }
    }
    HullDrive* const driven = sea.drive();
    ImGui::BeginDisabled(hulls == 0);
    if (ImGui::Button(driven != nullptr ? "Stop (H)###drive" : "Drive (H)###drive")) {
        state.requests.drive = true;
    }
    ImGui::EndDisabled();
    tooltip(
        "The hull goes by the arrow keys, a gamepad's left stick or the bridge;\n"
        "its way becomes its track, which is saved with the sea");
    ImGui::SameLine();
    ImGui::BeginDisabled(driven != nullptr);
    if (ImGui::Button("Add a hull")) state.requests.add_hull = true;
    ImGui::EndDisabled();
    tooltip("30 m long, at rest ahead of the camera");
    ImGui::SameLine();
    ImGui::Checkbox("Camera follows", &state.follows_hull);
    if (driven != nullptr) draw_driven(*driven, sea.time(), state);
    ImGui::PopItemWidth();
}

void draw_crest_section(PanelState& state) {
    if (!ImGui::CollapsingHeader("Place a crest")) return;
    ImGui::PushItemWidth(panel_length(kWidgetWidth));
    std::array<char, 32> typed{};
    state.crest.height.copy(typed.data(), typed.size() - 1);
    if (ImGui::InputText("Height of a crest", typed.data(), typed.size())) {
        state.crest.height = typed.data();
    }
    tooltip(
        "Ctrl and a click on the water place a crest there:\n"
        "metres, or a multiple of the significant height such as 1.3 Hs; a trough is below 0");
    slider(state, "Seconds ahead", state.crest.ahead, 1.0f, 60.0f, "%.1f s",
           ImGuiSliderFlags_Logarithmic);
    ImGui::PopItemWidth();
}

}  // namespace ocean::app
