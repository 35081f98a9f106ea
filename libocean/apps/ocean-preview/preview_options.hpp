// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The command line of `ocean-preview` as values.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bridge_host.hpp"
#include "command.hpp"
#include "ocean/internal/bridge/line_client.hpp"
#include "ocean/internal/preview/picture.hpp"
#include "ocean/internal/preview/sea_maps.hpp"
#include "scene_argument.hpp"

namespace ocean::app {

/// The options as they were typed.
struct PreviewWords {
    SeaArgument sea;
    std::string eye, look_at, sun, size, view = "shaded", look = "physical", backend = "auto";
    std::optional<double> heading, pitch, angle, exposure, visibility, crest_light, time,
        environment_turn, scale;
    std::optional<int> frame, budget, samples, egl_device, map, foam_map, cells, cascade;
    std::string colours = "land";
    std::optional<double> snow_line;
    std::string water, offscreen, record, frames, pictures, environment, bridge, token_file, serve,
        board_map;
    bool dummy = false;
    std::optional<double> follow;
    std::vector<std::string> probes;
    bool wireframe = false, no_detail = false;
};

// Scales of the panel.
inline constexpr float kMinScale = 0.5f;
inline constexpr float kMaxScale = 8.0f;

/// How --eye places the eye over land.
enum class EyePlace {
    not_given,
    at,         // X,Y,Z
    on_ground,  // X,Y
};

struct PreviewOptions {
    preview::Camera camera;
    EyePlace eye_place = EyePlace::not_given;
    std::optional<std::array<double, 3>> look_at;  // the camera looks there from any eye
    preview::Look look;
    std::string view = "shaded";  // or a stage of the transform
    std::array<int, 2> size = {1280, 720};
    bool has_size = false;         // --size was given
    std::optional<double> scale;   // of the panel; default: the scale of the window's screen
    std::string backend = "auto";  // of the maps
    std::optional<int> map;
    std::optional<int> foam_map;
    std::optional<int> cells;
    std::optional<double> time;
    std::optional<int> frame;
    std::optional<int> samples;  // of a pixel
    int budget = 0;              // frames to measure
    std::string offscreen;
    std::string record;       // folder of a sequence
    std::vector<int> frames;  // of the sequence
    std::vector<std::array<double, 2>> probes;
    bool wireframe = false;
    bool detail = true;                               // shows waves too short for the maps
    std::optional<int> cascade;                       // shown alone
    std::optional<bridge::LineClientOptions> bridge;  // to join
    double follow = 0.0;                              // [s]
    BridgeHostOptions host;                           // of a bridge in this process
    bool serve = false;                               // that bridge runs from the start
    std::vector<std::string> only_of_sea;             // the given options that land lacks
    std::vector<std::string> only_of_land;            // and those that a sea lacks
};

/// Returns the options of the program, which write into `words`.
std::vector<OptionGroup> preview_option_groups(PreviewWords& words);
/// Skies by the names of their files: a sky of several pictures is read once.
using EnvironmentFiles = std::map<std::string, std::shared_ptr<const preview::Environment>>;
/// Returns the values of the options, and reads the sky that they name. Throws Error.
PreviewOptions preview_options(const PreviewWords& words, EnvironmentFiles& environments);
/// Throws Error invalid_value if the options have a view, a cascade or anything else that the scene
/// does not have.
void require_fit(const PreviewOptions& options, const OpenedScene& scene);

}  // namespace ocean::app
