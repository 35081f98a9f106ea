// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The panel: every parameter of the table, the light, the camera, the clock.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera_control.hpp"
#include "live_sea.hpp"
#include "ocean/preview/picture.hpp"

namespace ocean::app {

/// What one frame cost, in milliseconds.
struct FrameTimes {
    double sea = 0.0;
    double draw = 0.0;
    double panel = 0.0;
};

/// What was there before a person changed it: a parameter, or the whole sea.
struct Change {
    std::string path;
    std::string before;
    std::optional<Sea> sea = {};
};

/// What the panel changes beside the sea, and what it says.
struct PanelState {
    preview::Look look;
    preview::View view = preview::View::shaded;
    bool wireframe = false;
    bool shown = true;
    bool probing = false;
    std::string search;
    std::string message;      // the last one, an error or what was written
    std::string under_mouse;  // what the probe found
    std::string computed_by;  // "llvmpipe; the sea by the processor"
    FrameTimes times;
    std::vector<Change> changes;  // the last one last

    // What a person asked for in this frame.
    bool save_sea = false;
    bool save_picture = false;
    bool reset_camera = false;
    bool touched = false;  // anything at all: the picture is another one
};

/// Takes the last change back: of a live parameter it glides back, from now on.
void undo(LiveSea& sea, PanelState& state);

/// Between ImGui::NewFrame and ImGui::Render.
void draw_panel(LiveSea& sea, const preview::ShownSea& shown, CameraControl& camera,
                PanelState& state);

}  // namespace ocean::app
