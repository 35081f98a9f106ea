// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Widgets that several sections of the panel share.
#pragma once

#include <imgui.h>

#include <cctype>
#include <string>
#include <string_view>

#include "panel/panel_state.hpp"

namespace ocean::app {

// At scale 1 [pixels]: the height of a letter, and the panel with a margin on either side.
inline constexpr float kLetterSize = 13.0f;
inline constexpr float kPanelMargin = 8.0f;
inline constexpr float kPanelWidth = 376.0f;

/// Returns the present length, in ImGui's units, of one that is given at scale 1. Within a frame of
/// ImGui.
float panel_length(float at_scale_one);

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
