// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ocean/internal/water_types.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"
#include "scene_argument.hpp"
#include "sea_scene.hpp"
#include "terrain_scene.hpp"

namespace ocean::app {
namespace {

/// Draws a list of words with their tips, if any; `chosen` is set to the word that a person
/// chooses. Returns true then.
bool choose_word(const char* label, const std::vector<std::string>& words, std::string& chosen,
                 PanelState& state, const std::vector<std::string>& tips = {}) {
    bool changed = false;
    if (!ImGui::BeginCombo(label, chosen.c_str())) return false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (ImGui::Selectable(words[i].c_str(), words[i] == chosen)) {
            chosen = words[i];
            state.requests.touched = changed = true;
        }
        if (!tips.empty()) tooltip(tips[i].c_str());
    }
    ImGui::EndCombo();
    return changed;
}

}  // namespace

void SeaScene::draw_look(PanelState& state) {
    preview::Look& look = state.look;
    std::vector<std::string> cascades = {"all"};
    for (int n = 0; n < state.cascades; ++n) cascades.push_back(std::to_string(n));
    std::string cascade = cascades[static_cast<std::size_t>(state.cascade + 1)];
    if (choose_word("Cascade", cascades, cascade, state)) {
        state.cascade = cascade == "all" ? -1 : std::stoi(cascade);
    }
    const std::vector<std::string> looks = preview::look_names();
    std::string name = looks[static_cast<std::size_t>(look.kind)];
    if (choose_word("Look", looks, name, state)) look.kind = preview::look_of(name);
    std::vector<std::string> waters, tips;
    for (const WaterType& type : water_types()) {
        waters.emplace_back(type.name);
        tips.emplace_back(type.help);
    }
    choose_word("Water", waters, look.water_type, state, tips);
}

void TerrainScene::draw_look(PanelState& state) {
    const preview::DrawnLand& land = shown_;
    preview::Look& look = state.look;
    const std::vector<std::string> names = preview::land_colour_names();
    std::string name = names[static_cast<std::size_t>(look.land_colours)];
    if (choose_word("Colours", names, name, state)) {
        look.land_colours = preview::land_colours_of(name);
    }
    bool own = look.snow_line.has_value();
    if (ImGui::Checkbox("Snow line", &own)) {
        const double line = preview::cover_lines(land, std::nullopt).snow;
        look.snow_line =
            own ? std::optional(std::min<double>(line, land.heights[1])) : std::nullopt;
        state.requests.touched = true;
    }
    tooltip("Unset: 1.3 rms heights above the mean, none on land with a coast");
    if (!look.snow_line) return;
    slider(state, "Snow from", *look.snow_line, static_cast<float>(land.mean - 3.0 * land.rms),
           static_cast<float>(land.mean + 5.0 * land.rms), "%.0f m");
}

namespace {

void draw_light(PanelState& state) {
    preview::Look& look = state.look;
    if (look.environment) {
        slider(state, "Sky turned", look.environment_turn, -180.0f, 180.0f, "%.1f deg");
        if (ImGui::Button("Computed sky")) {
            look.environment.reset();
            state.requests.touched = true;
        }
        tooltip("Show the computed sky and its sun again");
    } else {
        slider(state, "Sun's altitude", look.sun_altitude, -12.0f, 90.0f, "%.1f deg");
        slider(state, "Sun's bearing", look.sun_bearing, -180.0f, 180.0f, "%.0f deg");
    }
    slider(state, "Exposure", look.exposure, 0.05f, 20.0f, "%.2f", ImGuiSliderFlags_Logarithmic);
    slider(state, "Visibility", look.visibility, 500.0f, 200000.0f, "%.0f m",
           ImGuiSliderFlags_Logarithmic);
}

void draw_foam_and_crests(PanelState& state) {
    ImGui::PushItemWidth(panel_length(62.0f));  // two in a row
    slider(state, "Foam shown", state.look.foam_amount, 0.0f, 4.0f, "%.2f");
    ImGui::SameLine();
    slider(state, "Crest light", state.look.crest_light, 0.0f, 4.0f, "%.2f");
    ImGui::PopItemWidth();
}

}  // namespace

void draw_picture_section(LiveScene& scene, PanelState& state) {
    LiveSea* const sea = scene->performed();
    ImGui::PushItemWidth(panel_length(kWidgetWidth));
    choose_word("View (V)", all_view_names(scene.row()), state.view, state);
    scene->draw_look(state);
    draw_light(state);
    ImGui::PopItemWidth();
    if (sea != nullptr) draw_foam_and_crests(state);
    if (ImGui::Checkbox("Wireframe (F)", &state.wireframe)) state.requests.touched = true;
    ImGui::SameLine();
    if (ImGui::Checkbox("Probe (P)", &state.probing)) state.requests.touched = true;
    if (sea == nullptr) return;
    ImGui::SameLine();
    if (ImGui::Checkbox("Near detail", &sea->near_detail)) state.requests.touched = true;
    tooltip("Show the waves too short for the maps");
}

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
