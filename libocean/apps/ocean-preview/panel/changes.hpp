// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Changes of the scene that a person makes, and undoes.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "live_scene.hpp"
#include "panel/panel_state.hpp"

namespace ocean::app {

/// Sets a parameter; a message says why if the scene refuses. Returns whether it was set.
bool try_to_set(LiveScene& scene, PanelState& state, const std::string& path,
                const std::string& value);

/// Opens another scene, which undo closes again. Throws Error.
void open_with_undo(LiveScene& scene, PanelState& state, const OpenedScene& opened);

/// Starts or stops recording; undo brings back a take that recording shortens.
void toggle_recording(LiveSea& sea, PanelState& state);

/// Drives a hull of that number from 1, or none (0); undo brings back its track. Throws Error.
void drive_hull(LiveSea& sea, PanelState& state, std::size_t number);
/// Adds a hull at a place [m] with a heading [degrees], and drives it; undo removes it. Throws
/// Error.
void drive_new_hull(LiveSea& sea, PanelState& state, const std::array<double, 2>& place,
                    double heading);

/// Adds a crest on cue at a place [m], some seconds ahead and as high as the panel says; undo
/// removes it. Throws Error.
void add_crest(LiveSea& sea, PanelState& state, const std::array<double, 2>& place);

/// Undoes the last change: a live parameter glides back, from now on.
void undo(LiveScene& scene, PanelState& state);

}  // namespace ocean::app
