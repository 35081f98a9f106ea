// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <algorithm>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
void draw_transport(LiveSea& sea, PanelState& state) {
    if (ImGui::Button(sea.paused ? "Play (Space)" : "Pause (Space)")) {
        sea.paused = !sea.paused;
    }
    ImGui::SameLine();
    if (ImGui::Button("To start")) {
        sea.go_to(sea.sea().parameters.time.start);
        state.requests.touched = true;
    }
    ImGui::SameLine();
    if (ImGui::Button("To end")) {
        sea.go_to(sea.take_end());
        state.requests.touched = true;
    }
    tooltip("To the last change of the take");
    ImGui::SameLine();
    if (ImGui::Button(sea.recording() ? "Stop (R)###record" : "Record (R)###record")) {
        state.requests.record = true;
    }
    tooltip(
        "Changes of gliding parameters become a take, which is saved with the sea\n"
        "and plays everywhere; later changes of the take are dropped");
    ImGui::PushItemWidth(panel_length(kWidgetWidth));
    double time = sea.time();
    if (ImGui::DragScalar("Time", ImGuiDataType_Double, &time, 0.05f, nullptr, nullptr, "%.2f s")) {
        sea.go_to(std::clamp(time, -1e9, 1e9));
        state.requests.touched = true;
    }
    bool again = sea.play_again_after.has_value();
    if (ImGui::Checkbox("Play again from the start", &again)) {
        // The whole loop, or the take and some seconds of its last glide.
        const double loop = sea.sea().parameters.time.loop_period;
        const double take = sea.take_end() - sea.sea().parameters.time.start;
        sea.play_again_after.reset();
        if (again) sea.play_again_after = loop > 0.0 ? loop : std::max(10.0, take + 3.0);
    }
    if (again && sea.play_again_after) {
        slider(state, "After", *sea.play_again_after, 1.0f, 600.0f, "%.1f s",
               ImGuiSliderFlags_Logarithmic);
    }
    slider(state, "Speed", sea.speed, 0.05f, 20.0f, "%.2f x", ImGuiSliderFlags_Logarithmic);
    ImGui::PopItemWidth();
}

}  // namespace ocean::app
