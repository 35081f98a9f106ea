// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Changes of the scene that a person makes, and undoes.
#pragma once

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

/// Undoes the last change: a live parameter glides back, from now on.
void undo(LiveScene& scene, PanelState& state);

}  // namespace ocean::app
