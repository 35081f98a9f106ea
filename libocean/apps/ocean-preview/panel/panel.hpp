// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The panel: every parameter of the table, the light, the camera, the clock, the bridge.
#pragma once

#include "live_scene.hpp"
#include "panel/panel_state.hpp"
#include "window/camera_control.hpp"

namespace ocean::app {

/// Draws the panel and the message at the foot of the window, between ImGui::NewFrame and
/// ImGui::Render. Throws Error.
void draw_panel(LiveScene& scene, CameraControl& camera, PanelState& state);

}  // namespace ocean::app
