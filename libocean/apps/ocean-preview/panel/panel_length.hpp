// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lengths of the panel, which grow with its letters, and these with the scale of the screen.
#pragma once

namespace ocean::app {

// At scale 1 [pixels]: the height of a letter, and the panel with a margin on either side.
inline constexpr float kLetterSize = 13.0f;
inline constexpr float kPanelMargin = 8.0f;
inline constexpr float kPanelWidth = 376.0f;

/// Returns the present length, in ImGui's units, of one that is given at scale 1. Within a frame of
/// ImGui.
float panel_length(float at_scale_one);

}  // namespace ocean::app
