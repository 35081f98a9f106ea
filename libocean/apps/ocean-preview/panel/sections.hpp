// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of the panel, from top to bottom, a file each. Each is drawn inside the panel's
// window.
#pragma once

#include "live_scene.hpp"
#include "panel/panel_state.hpp"
#include "window/camera_control.hpp"

namespace ocean::app {

/// The clock and the recording.
void draw_transport(LiveSea& sea, PanelState& state);
/// The state of the scene and frame times; buttons that save, undo and reload.
void draw_readings(const LiveScene& scene, const PanelState& state);
void draw_file_buttons(LiveScene& scene, PanelState& state);
/// Buttons that open a file, save the scene under a chosen name, and list the recent files.
void draw_open_buttons(const LiveScene& scene, PanelState& state);
/// View, colours, water, light.
void draw_picture_section(LiveScene& scene, PanelState& state);
void draw_camera_section(LiveScene& scene, CameraControl& camera, PanelState& state);
void draw_bridge_section(BridgeRows& bridge, PanelRequests& requests);
/// The driven hull, and the crest that a click places.
void draw_hull_section(LiveSea& sea, PanelState& state);
void draw_crest_section(PanelState& state);
/// Presets and backends.
void draw_choices(LiveScene& scene, PanelState& state);

}  // namespace ocean::app
