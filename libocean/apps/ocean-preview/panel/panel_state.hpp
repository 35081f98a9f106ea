// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The values that the panel shows and changes beside the scene, and the requests of one frame.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bridge_host.hpp"
#include "bridge_link.hpp"
#include "ocean/internal/preview/picture.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "scene.hpp"
#include "window/file_dialog.hpp"

namespace ocean::app {

/// The cost of one frame [ms].
struct FrameTimes {
    double scene = 0.0;
    double draw = 0.0;
    double panel = 0.0;
};

/// A backend that the scene can be computed by.
struct BackendRow {
    std::string name;
    std::string why_not;  // why it cannot compute this scene; "": it can
    double milliseconds;  // of the last frame that it computed; 0: none yet
};

/// The state before a change: of a parameter, or of the whole scene.
struct Change {
    std::string path;
    std::string before;
    OpenedScene scene = {};
    std::optional<SubjectArgument> source = {};  // of that scene, if another file was opened
    std::optional<double> time =
        {};  // of the clock of a scene that one without a clock replaced [s]
};

/// The bridge: one that the window has joined, or one of its own.
struct BridgeRows {
    const BridgeLink* link = nullptr;  // null while the window is connected to none
    bool is_own = true;                // this process runs the bridge
    bool is_running = false;
    BridgeHostOptions host;
    std::vector<std::string> log;
};

/// The place of the panel when it was last drawn, in ImGui's units; for the next scale.
struct PanelPlace {
    float letters = 0.0f;  // their height; 0 before the first time
    std::array<float, 2> corner{};
    std::array<float, 2> size{};
    // At the last scale: the size that it called for, and the part that the window had room for.
    std::array<float, 2> wanted{};
    std::array<float, 2> fitted{};
};

/// The files that the window can open.
struct FileRows {
    struct Recent {
        std::string path;
        bool is_missing;
    };

    bool has_dialog = false;     // the desktop has a program that asks for a file
    std::vector<Recent> recent;  // the newest first, as they were when the list was requested
    // Where no dialog asks for a path, a field of the panel does.
    std::optional<FilePurpose> ask;  // the field that appears in the next frame
    std::string typed;
};

/// A crest that a click on the water places.
struct CrestRow {
    std::string height = "1.3 Hs";  // as in a sea file
    double ahead = 5.0;             // [s]
};

/// The actions that a person requested in one frame.
struct PanelRequests {
    enum class Bridge { nothing, start, stop };

    bool touched = false;  // anything at all: the picture has changed
    bool save_scene = false;
    std::optional<FilePurpose> ask;
    std::string open, save_as;  // paths
    bool list_recent = false;
    std::string save_picture;  // ".png", ".exr" or ""
    bool reload = false;
    bool record = false;  // starts or stops
    bool drive = false;   // starts or stops
    bool add_hull = false;
    bool reset_camera = false;
    std::optional<std::string> backend;
    Bridge bridge = Bridge::nothing;
};

struct PanelState {
    preview::Look look;
    std::string view = "shaded";  // one of all_view_names(row)
    int cascade = -1;             // the only one shown; -1: all
    int cascades = 1;
    bool wireframe = false;
    bool shown = true;
    bool probing = false;
    std::size_t hull = 0;      // the one that H drives
    bool follows_hull = true;  // the camera goes along with the driven hull
    CrestRow crest;
    std::string search;
    std::string message;      // the last one: an error, or the name of a written file
    std::string under_mouse;  // values that the probe found
    std::string drawn_by;     // "llvmpipe ..., OpenGL 4.5"
    std::string left_out;     // parts of the picture that the driver has too few texture units for
    preview::LandStatistics land_mesh;  // of the last picture
    std::vector<BackendRow> backends;
    std::string backend;  // one of them
    FrameTimes times;
    BridgeRows bridge;
    FileRows files;
    SubjectArgument source;  // of the shown scene, for Reload and the window's title
    PanelPlace place;
    std::vector<Change> changes;  // the newest last
    PanelRequests requests;
};

}  // namespace ocean::app
