// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lengths of the panel: they follow the size of its letters, which follows the screen.
#pragma once

namespace ocean::app {

// At scale 1, in pixels: the height of a letter, and the panel with a margin on either side.
inline constexpr float kLetterSize = 13.0f;
inline constexpr float kPanelMargin = 8.0f;
inline constexpr float kPanelWidth = 376.0f;

/// Returns a length that the panel has at scale 1 as it is now, in ImGui's units: letters and
/// lengths grow together. Within a frame of ImGui.
float panel_length(float at_scale_one);

}  // namespace ocean::app
