// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include "ocean/water_types.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"
#include "stage_picture.hpp"

namespace ocean::app {
void draw_picture_section(LiveSea& sea, PanelState& state) {
    ImGui::PushItemWidth(panel_length(kWidgetWidth));
    if (ImGui::BeginCombo("View (V)", state.view.c_str())) {
        for (const std::string& view : all_view_names()) {
            if (ImGui::Selectable(view.c_str(), view == state.view)) {
                state.view = view;
                state.requests.touched = true;
            }
        }
        ImGui::EndCombo();
    }
    const std::string all = state.cascade < 0 ? "all" : std::to_string(state.cascade);
    if (ImGui::BeginCombo("Cascade", all.c_str())) {
        for (int cascade = -1; cascade < state.cascades; ++cascade) {
            const std::string name = cascade < 0 ? "all" : std::to_string(cascade);
            if (ImGui::Selectable(name.c_str(), cascade == state.cascade)) {
                state.cascade = cascade;
                state.requests.touched = true;
            }
        }
        ImGui::EndCombo();
    }
    preview::Look& look = state.look;
    const std::vector<std::string> looks = preview::look_names();
    if (ImGui::BeginCombo("Look", looks[static_cast<std::size_t>(look.kind)].c_str())) {
        for (const std::string& name : looks) {
            if (ImGui::Selectable(name.c_str())) {
                look.kind = preview::look_of(name);
                state.requests.touched = true;
            }
        }
        ImGui::EndCombo();
    }
    if (ImGui::BeginCombo("Water", look.water_type.c_str())) {
        for (const WaterType& type : water_types()) {
            const std::string name(type.name);
            if (ImGui::Selectable(name.c_str(), name == look.water_type)) {
                look.water_type = name;
                state.requests.touched = true;
            }
            tooltip(std::string(type.help).c_str());
        }
        ImGui::EndCombo();
    }
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
    ImGui::PopItemWidth();
    ImGui::PushItemWidth(panel_length(62.0f));  // two in a row
    slider(state, "Foam shown", look.foam_amount, 0.0f, 4.0f, "%.2f");
    ImGui::SameLine();
    slider(state, "Crest light", look.crest_light, 0.0f, 4.0f, "%.2f");
    ImGui::PopItemWidth();
    if (ImGui::Checkbox("Wireframe (F)", &state.wireframe)) state.requests.touched = true;
    ImGui::SameLine();
    if (ImGui::Checkbox("Probe (P)", &state.probing)) state.requests.touched = true;
    ImGui::SameLine();
    if (ImGui::Checkbox("Near detail", &sea.near_detail)) state.requests.touched = true;
    tooltip("Show the waves too short for the maps");
}

}  // namespace ocean::app
