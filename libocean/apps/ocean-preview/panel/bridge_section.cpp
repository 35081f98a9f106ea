// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>

#include <array>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace ocean::app {
namespace {

void text_row(const char* label, std::string& text, const char* help) {
    std::array<char, 512> typed{};
    text.copy(typed.data(), typed.size() - 1);
    ImGui::SetNextItemWidth(panel_length(kWidgetWidth));
    if (ImGui::InputText(label, typed.data(), typed.size())) text = typed.data();
    tooltip(help);
}

/// Rows that start and stop a bridge in this process.
void draw_own_bridge(BridgeRows& bridge, PanelRequests& requests) {
    ImGui::BeginDisabled(bridge.is_running);
    text_row("Address", bridge.host.listen, "Address for clients: HOST:PORT");
    text_row("Map of knobs", bridge.host.map, "A file; without one a1 sets the wind speed");
    ImGui::Checkbox("Dummy board", &bridge.host.dummy);
    tooltip("Simulates a board in place of a K8055 on USB: OUT board0/a1 128");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button(bridge.is_running ? "Restart" : "Start")) {
        requests.bridge = PanelRequests::Bridge::start;
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(!bridge.is_running);
    if (ImGui::Button("Stop")) requests.bridge = PanelRequests::Bridge::stop;
    ImGui::EndDisabled();
}

}  // namespace

void draw_bridge_section(BridgeRows& bridge, PanelRequests& requests) {
    if (bridge.is_own) {
        draw_own_bridge(bridge, requests);
    } else {
        ImGui::TextUnformatted(bridge.link->connected() ? "joined" : "not connected; trying again");
    }
    if (bridge.link != nullptr) {
        for (const auto& [name, mover] : bridge.link->movers()) {
            const bool here = mover == bridge.link->own_name();
            if (here && name.starts_with("app.")) continue;  // its clock, which it always sends
            ImGui::Text("%s: %s", name.c_str(), here ? "this window" : mover.c_str());
        }
    }
    ImGui::BeginChild("log", {0.0f, panel_length(120.0f)}, true);
    for (const std::string& line : bridge.log) ImGui::TextWrapped("%s", line.c_str());
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1.0f);
    ImGui::EndChild();
}

}  // namespace ocean::app
