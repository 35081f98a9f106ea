// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The command line of `ocean-preview` as values.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bridge_host.hpp"
#include "command.hpp"
#include "ocean/internal/bridge/line_client.hpp"
#include "ocean/internal/preview/picture.hpp"
#include "ocean/internal/preview/sea_maps.hpp"
#include "scene_argument.hpp"

namespace ocean::app {

/// The options whose values are used as they were typed.
struct PlainOptions {
    std::string view = "shaded";   // or a stage of the transform
    std::string backend = "auto";  // of the maps
    std::string offscreen;
    std::string record;  // folder of a sequence
    std::optional<double> time;
    std::optional<double> scale;                 // of the panel; default: that of the screen
    std::optional<int> map, foam_map, cells;     // samples of maps, cells of the mesh
    std::optional<int> frame, samples, cascade;  // samples of a pixel; the cascade shown alone
    bool wireframe = false;
};

/// The options as they were typed.
struct PreviewWords : PlainOptions {
    SubjectArgument sea;
    std::string eye, look_at, sun, size, look = "physical", colours = "land", water, frames,
                                         pictures, environment, bridge, token_file, serve,
                                         board_map;
    std::optional<double> heading, pitch, angle, exposure, visibility, crest_light, snow_line,
        environment_turn, follow;
    std::optional<int> budget, egl_device;
    std::vector<std::string> probes;
    bool dummy = false, no_detail = false;
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

/// A given option that only one kind of subject has.
struct SpecialOption {
    std::string_view kind;
    std::string text;
};

struct PreviewOptions : PlainOptions {
    preview::Camera camera;
    EyePlace eye_place = EyePlace::not_given;
    bool has_heading = false;                      // --heading was given
    std::optional<std::array<double, 3>> look_at;  // the camera looks there from any eye
    preview::Look look;
    std::array<int, 2> size = {1280, 720};
    bool has_size = false;    // --size was given
    int budget = 0;           // frames to measure
    std::vector<int> frames;  // of a sequence
    std::vector<std::array<double, 2>> probes;
    bool detail = true;                               // shows waves too short for the maps
    std::optional<bridge::LineClientOptions> bridge;  // to join
    double follow = 0.0;                              // [s]
    BridgeHostOptions host;                           // of a bridge in this process
    bool serve = false;                               // that bridge runs from the start
    std::vector<SpecialOption> special;
};

/// Returns the options of the program beside its argument, which write into `words`.
std::vector<OptionGroup> preview_option_groups(PreviewWords& words);
/// Skies by the names of their files: a sky of several pictures is read once.
using EnvironmentFiles = std::map<std::string, std::shared_ptr<const preview::Environment>>;
/// Returns the values of the options, and reads the sky that they name. `given`: those that
/// require_fit refuses where the subject lacks them. Throws Error.
PreviewOptions preview_options(const PreviewWords& words, std::span<const GivenOption> given,
                               EnvironmentFiles& environments);
/// Throws Error invalid_value if the options have a view, a cascade or anything else that the scene
/// does not have.
void require_fit(const PreviewOptions& options, const OpenedScene& scene);

}  // namespace ocean::app
