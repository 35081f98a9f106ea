// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Widgets that several sections of the panel share.
#pragma once

#include <imgui.h>

#include <cctype>
#include <string>
#include <string_view>

#include "panel/panel_length.hpp"
#include "panel/panel_state.hpp"

namespace ocean::app {

/// Width of a widget whose label stands right of it, at scale 1.
inline constexpr float kWidgetWidth = 150.0f;

inline void slider(PanelState& state, const char* label, double& value, float lowest, float highest,
                   const char* format, ImGuiSliderFlags flags = ImGuiSliderFlags_None) {
    auto shown = static_cast<float>(value);
    if (ImGui::SliderFloat(label, &shown, lowest, highest, format, flags)) {
        value = static_cast<double>(shown);
        state.requests.touched = true;
    }
}

inline void tooltip(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

inline std::string capitalised(std::string_view word) {
    std::string text(word);
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

}  // namespace ocean::app
