// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>
#include <algorithm>

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
