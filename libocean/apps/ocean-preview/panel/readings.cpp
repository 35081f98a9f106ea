// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "ocean/internal/text.hpp"
#include "panel/changes.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"
#include "sea_scene.hpp"
#include "terrain_scene.hpp"

namespace ocean::app {

void SeaScene::draw_readings(const PanelState&) const {
    ImGui::Text("Hs %.2f m   Tp %.1f s   mss %.4f", shown_.significant_wave_height,
                shown_.peak_period, shown_.mean_square_slope);
    const double settling = live_.foam_settling();
    // A line that comes and goes would move the controls under the mouse.
    const std::string foam =
        settling > 0.0 ? format_text("foam settling: %.1f s", settling) : "foam settled";
    if (live_.sea().parameters.water.bed) {
        const std::string work = live_.coast_progress();
        ImGui::Text("%s",
                    work.empty() ? "coast: computed" : ("computing the coast: " + work).c_str());
    }
    const std::size_t changes = live_.sea().take.events.size();
    ImGui::Text("%s   %s %zu changes", foam.c_str(),
                live_.recording() ? "RECORDING," : "take:", changes);
}

void TerrainScene::draw_readings(const PanelState& state) const {
    const preview::LandStatistics& mesh = state.land_mesh;
    ImGui::Text("rms %.4g m   heights %.5g .. %.5g m", shown_.rms, shown_.heights[0],
                shown_.heights[1]);
    ImGui::Text("rms slope %.3f   tile %.5g m   cell %.4g m", shown_.rms_slope,
                shown_.image ? shown_.image->period : 0.0, shown_.cell);
    ImGui::Text("%zu k triangles   %.0f MiB   %zu patches wait", mesh.triangles / 1000,
                static_cast<double>(mesh.resident_bytes) / (1 << 20), mesh.waiting);
}

void draw_readings(const LiveScene& scene, const PanelState& state) {
    scene->draw_readings(state);
    ImGui::Text("%s %.1f ms   draw %.1f ms   panel %.1f ms", std::string(scene.row().kind).c_str(),
                state.times.scene, state.times.draw, state.times.panel);
    ImGui::TextDisabled("%s", state.drawn_by.c_str());
}

void draw_file_buttons(LiveScene& scene, PanelState& state) {
    const std::string noun(scene.row().kind);
    if (ImGui::Button(("Save " + noun).c_str())) state.requests.save_scene = true;
    ImGui::SameLine();
    if (ImGui::Button("Undo")) undo(scene, state);
    tooltip("Ctrl Z");
    ImGui::SameLine();
    if (ImGui::Button("PNG (F12)")) state.requests.save_picture = ".png";
    tooltip("Save the picture as it is shown");
    ImGui::SameLine();
    if (ImGui::Button("EXR")) state.requests.save_picture = ".exr";
    tooltip("Save its light, linear, for a compositor (Shift F12)");
    ImGui::SameLine();
    if (ImGui::Button("Reload")) state.requests.reload = true;
    tooltip(("Read the " + noun + " file again (Ctrl R)").c_str());
}

}  // namespace ocean::app
