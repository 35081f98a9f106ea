// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "panel/changes.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

/// Draws presets of one kind of scene; parse() makes a scene of one.
template <typename Parse>
void list_presets(std::span<const Preset> presets, const Parse& parse, LiveScene& scene,
                  PanelState& state) {
    for (const Preset& preset : presets) {
        if (ImGui::Selectable(preset.name.c_str())) {
            state.requests.touched = true;
            try {
                open_with_undo(scene, state, parse(preset));
                state.message = preset.name + ": " + preset.description;
            } catch (const Error& error) {
                state.message = error.what();
            }
        }
        tooltip(preset.description.c_str());
    }
}

/// The presets of the shown kind of scene, and below a line those of the other kind.
void choose_preset(LiveScene& scene, PanelState& state) {
    ImGui::SetNextItemWidth(panel_length(kWidgetWidth));
    if (!ImGui::BeginCombo("Preset", "choose ...")) return;
    const auto seas = [&] {
        list_presets(
            presets(), [](const Preset& p) { return parse_sea(p.toml, p.name, ""); }, scene, state);
    };
    const auto terrains = [&] {
        list_presets(
            terrain_presets(), [](const Preset& p) { return parse_terrain(p.toml, p.name, ""); },
            scene, state);
    };
    const bool sea_first = scene.sea() != nullptr;
    sea_first ? seas() : terrains();
    ImGui::Separator();
    sea_first ? terrains() : seas();
    ImGui::EndCombo();
}

/// The list of backends, with the time of a frame of each that has computed one.
void choose_backend(PanelState& state) {
    ImGui::SetNextItemWidth(panel_length(kWidgetWidth));
    if (!ImGui::BeginCombo("Computed by", state.backend.c_str())) return;
    for (const BackendRow& row : state.backends) {
        std::string words = row.name;
        if (row.milliseconds > 0.0) words += format_text("   %.1f ms", row.milliseconds);
        if (!row.why_not.empty()) words += "   " + row.why_not;
        const ImGuiSelectableFlags flags =
            row.why_not.empty() ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
        if (ImGui::Selectable(words.c_str(), row.name == state.backend, flags)) {
            state.requests.backend = row.name;
        }
    }
    ImGui::EndCombo();
}

}  // namespace

void draw_choices(LiveScene& scene, PanelState& state) {
    choose_preset(scene, state);
    choose_backend(state);
}

}  // namespace ocean::app
