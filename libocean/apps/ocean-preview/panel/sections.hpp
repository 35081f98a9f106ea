// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of the panel, from top to bottom, a file each. Each is drawn inside the panel's
// window.
#pragma once

#include "live_sea.hpp"
#include "panel/panel_state.hpp"
#include "window/camera_control.hpp"

namespace ocean::app {

/// The clock and the recording.
void draw_transport(LiveSea& sea, PanelState& state);
/// Wave height, foam, take and frame times; buttons that save, undo and reload.
void draw_readings(const LiveSea& sea, const preview::ShownSea& shown, const PanelState& state);
void draw_file_buttons(LiveSea& sea, PanelState& state);
/// Buttons that open a file, save the sea under a chosen name, and list the recent files.
void draw_open_buttons(PanelState& state);
/// View, look, water, light.
void draw_picture_section(LiveSea& sea, PanelState& state);
void draw_camera_section(CameraControl& camera, PanelState& state);
void draw_bridge_section(BridgeRows& bridge, PanelRequests& requests);
/// Presets and backends.
void draw_choices(LiveSea& sea, PanelState& state);
/// Every parameter of the sea.
void draw_parameter_sections(LiveSea& sea, PanelState& state);

}  // namespace ocean::app
