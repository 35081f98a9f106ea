// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The panel: every parameter of the table, the light, the camera, the clock.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bridge_host.hpp"
#include "bridge_link.hpp"
#include "camera_control.hpp"
#include "live_sea.hpp"
#include "ocean/preview/picture.hpp"
#include "panel_length.hpp"

namespace ocean::app {

/// What one frame cost, in milliseconds.
struct FrameTimes {
    double sea = 0.0;
    double draw = 0.0;
    double panel = 0.0;
};

/// What the sea can be computed by.
struct BackendRow {
    std::string name;
    std::string why_not;  // empty: it can
    double milliseconds;  // of the last frame that it computed; 0: none yet
};

/// What was there before a person changed it: a parameter, or the whole sea.
struct Change {
    std::string path;
    std::string before;
    std::optional<Sea> sea = {};
};

/// The bridge: one that was joined, or one of its own.
struct BridgeRows {
    enum class Asked { nothing, start, stop };

    const BridgeLink* link = nullptr;  // where there is one
    bool is_own = true;                // it is not joined somewhere else
    bool is_running = false;
    BridgeHostOptions host;
    std::vector<std::string> log;
    Asked asked = Asked::nothing;
};

/// Where the panel was when it was last drawn, in ImGui's units; for the next scale.
struct PanelPlace {
    float letters = 0.0f;  // their height; 0 before the first time
    std::array<float, 2> corner{};
    std::array<float, 2> size{};
    // Of the last scale: the size that it asked for, and what of it the window had room for.
    std::array<float, 2> wanted{};
    std::array<float, 2> fitted{};
};

/// What the panel changes beside the sea, and what it says.
struct PanelState {
    preview::Look look;
    std::string view = "shaded";  // one of all_view_names()
    int cascade = -1;             // the one that is shown alone; -1: all
    int cascades = 1;
    bool wireframe = false;
    bool shown = true;
    bool probing = false;
    std::string search;
    std::string message;      // the last one, an error or what was written
    std::string under_mouse;  // what the probe found
    std::string drawn_by;     // "llvmpipe ..., OpenGL 4.5"
    std::vector<BackendRow> backends;
    std::string backend;  // of them
    FrameTimes times;
    BridgeRows bridge;
    PanelPlace place;
    std::vector<Change> changes;  // the last one last

    // What a person asked for in this frame.
    bool save_sea = false;
    std::string save_picture;  // ".png" or ".exr"
    bool reload = false;
    bool record = false;  // starts or stops
    bool reset_camera = false;
    std::optional<std::string> backend_asked;
    bool touched = false;  // anything at all: the picture is another one
};

/// Starts or stops recording; taken back like any change.
void toggle_recording(LiveSea& sea, PanelState& state);
/// Takes the last change back: of a live parameter it glides back, from now on.
void undo(LiveSea& sea, PanelState& state);

/// Between ImGui::NewFrame and ImGui::Render.
void draw_panel(LiveSea& sea, const preview::ShownSea& shown, CameraControl& camera,
                PanelState& state);

}  // namespace ocean::app
