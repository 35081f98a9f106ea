// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "ocean/text.hpp"
#include "panel/changes.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
void draw_readings(const LiveSea& sea, const preview::ShownSea& shown, const PanelState& state) {
    ImGui::Text("Hs %.2f m   Tp %.1f s   mss %.4f", shown.significant_wave_height,
                shown.peak_period, shown.mean_square_slope);
    const double settling = sea.foam_settling();
    // A line that comes and goes would move the controls under the mouse.
    const std::string foam =
        settling > 0.0 ? format_text("foam settling: %.1f s", settling) : "foam settled";
    const std::size_t changes = sea.sea().take.events.size();
    ImGui::Text("%s   %s %zu changes", foam.c_str(),
                sea.recording() ? "RECORDING," : "take:", changes);
    ImGui::Text("sea %.1f ms   draw %.1f ms   panel %.1f ms", state.times.sea, state.times.draw,
                state.times.panel);
    ImGui::TextDisabled("%s", state.drawn_by.c_str());
}

void draw_file_buttons(LiveSea& sea, PanelState& state) {
    if (ImGui::Button("Save sea")) state.requests.save_sea = true;
    ImGui::SameLine();
    if (ImGui::Button("Undo")) undo(sea, state);
    tooltip("Ctrl Z");
    ImGui::SameLine();
    if (ImGui::Button("PNG (F12)")) state.requests.save_picture = ".png";
    tooltip("Save the picture as it is shown");
    ImGui::SameLine();
    if (ImGui::Button("EXR")) state.requests.save_picture = ".exr";
    tooltip("Save its light, linear, for a compositor (Shift F12)");
    ImGui::SameLine();
    if (ImGui::Button("Reload")) state.requests.reload = true;
    tooltip("Read the sea file again (Ctrl R)");
}

}  // namespace ocean::app
