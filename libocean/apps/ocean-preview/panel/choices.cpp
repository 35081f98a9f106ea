// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"
#include "panel/changes.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"
#include "source_text.hpp"

namespace ocean::app {
namespace {

void list_presets(const SceneRow& row, LiveScene& scene, PanelState& state) {
    for (const Preset& preset : row.presets()) {
        if (ImGui::Selectable(preset.name.c_str())) {
            state.requests.touched = true;
            try {
                open_with_undo(scene, state,
                               row.open({std::string(kPresetPrefix) + preset.name, {}}));
                state.message = preset.name + ": " + preset.description;
            } catch (const Error& error) {
                state.message = error.what();
            }
        }
        tooltip(preset.description.c_str());
    }
}

/// The presets of the shown kind of scene, and below a line each those of the other kinds.
void choose_preset(LiveScene& scene, PanelState& state) {
    ImGui::SetNextItemWidth(panel_length(kWidgetWidth));
    if (!ImGui::BeginCombo("Preset", "choose ...")) return;
    const SceneRow& shown = scene.row();
    list_presets(shown, scene, state);
    for (const SceneRow* const row : scene_rows()) {
        if (row == &shown) continue;
        ImGui::Separator();
        list_presets(*row, scene, state);
    }
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
