// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "ocean/internal/text.hpp"
#include "panel/changes.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

void draw_sea_readings(const LiveSea& sea, const preview::DrawnSea& shown) {
    ImGui::Text("Hs %.2f m   Tp %.1f s   mss %.4f", shown.significant_wave_height,
                shown.peak_period, shown.mean_square_slope);
    const double settling = sea.foam_settling();
    // A line that comes and goes would move the controls under the mouse.
    const std::string foam =
        settling > 0.0 ? format_text("foam settling: %.1f s", settling) : "foam settled";
    if (sea.sea().parameters.water.bed) {
        const std::string work = sea.coast_progress();
        ImGui::Text("%s",
                    work.empty() ? "coast: computed" : ("computing the coast: " + work).c_str());
    }
    const std::size_t changes = sea.sea().take.events.size();
    ImGui::Text("%s   %s %zu changes", foam.c_str(),
                sea.recording() ? "RECORDING," : "take:", changes);
}

void draw_land_readings(const preview::DrawnLand& shown, const preview::LandStatistics& mesh) {
    ImGui::Text("rms %.4g m   heights %.5g .. %.5g m", shown.rms, shown.heights[0],
                shown.heights[1]);
    ImGui::Text("rms slope %.3f   tile %.5g m   cell %.4g m", shown.rms_slope,
                shown.image ? shown.image->period : 0.0, shown.cell);
    ImGui::Text("%zu k triangles   %.0f MiB   %zu patches wait", mesh.triangles / 1000,
                static_cast<double>(mesh.resident_bytes) / (1 << 20), mesh.waiting);
}

}  // namespace

void draw_readings(const LiveScene& scene, const PanelState& state) {
    const auto* const land = std::get_if<preview::DrawnLand>(&scene.shown());
    if (land != nullptr) {
        draw_land_readings(*land, state.land_mesh);
    } else if (scene.sea() != nullptr) {
        draw_sea_readings(*scene.sea(), std::get<preview::DrawnSea>(scene.shown()));
    }
    ImGui::Text("%s %.1f ms   draw %.1f ms   panel %.1f ms", noun_of(scene.kind()),
                state.times.scene, state.times.draw, state.times.panel);
    ImGui::TextDisabled("%s", state.drawn_by.c_str());
}

void draw_file_buttons(LiveScene& scene, PanelState& state) {
    const bool is_sea = scene.sea() != nullptr;
    if (ImGui::Button(is_sea ? "Save sea" : "Save terrain")) state.requests.save_scene = true;
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
    tooltip(is_sea ? "Read the sea file again (Ctrl R)" : "Read the terrain file again (Ctrl R)");
}

}  // namespace ocean::app
