// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "ocean/error.hpp"
#include "ocean/seafile.hpp"
#include "ocean/text.hpp"
#include "panel/changes.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

void choose_preset(LiveSea& sea, PanelState& state) {
    ImGui::SetNextItemWidth(panel_length(kWidgetWidth));
    if (!ImGui::BeginCombo("Preset", "choose ...")) return;
    for (const Preset& preset : presets()) {
        if (ImGui::Selectable(preset.name.c_str())) {
            state.requests.touched = true;
            try {
                open_with_undo(sea, state, parse_sea(preset.toml, preset.name, ""));
                state.message = preset.name + ": " + preset.description;
            } catch (const Error& error) {
                state.message = error.what();
            }
        }
        tooltip(preset.description.c_str());
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

void draw_choices(LiveSea& sea, PanelState& state) {
    choose_preset(sea, state);
    choose_backend(state);
}

}  // namespace ocean::app
