// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "preview_options.hpp"

#include <algorithm>

#include "ocean/bake/frames.hpp"
#include "ocean/error.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/io/panorama.hpp"
#include "ocean/text.hpp"
#include "ocean/water_types.hpp"
#include "picture_file.hpp"
#include "stage_picture.hpp"

namespace ocean::app {
namespace {

constexpr double kFarthest = 1e9;  // m

/// "1,2.5,3" for an option.
template <std::size_t kCount>
std::array<double, kCount> numbers(const std::string& text, const std::string& option,
                                   std::array<std::array<double, 2>, kCount> ranges) {
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() != kCount) {
        throw Error(ErrorKind::invalid_value, option + ": '" + text + "' is not " +
                                                  std::to_string(kCount) +
                                                  " numbers with commas between them");
    }
    std::array<double, kCount> values{};
    for (std::size_t i = 0; i < kCount; ++i) {
        values[i] = parse_number(parts[i], option, ranges[i][0], ranges[i][1]);
    }
    return values;
}

std::array<double, 3> place(const std::string& text, const std::string& option) {
    return numbers<3>(text, option,
                      {{{-kFarthest, kFarthest}, {-kFarthest, kFarthest}, {-1000.0, 1e6}}});
}

double within(double value, const std::string& option, double lowest, double highest) {
    if (value >= lowest && value <= highest) return value;
    throw Error(ErrorKind::invalid_value, option + " is " + shortest_text(value) +
                                              "; allowed: " + shortest_text(lowest) + " .. " +
                                              shortest_text(highest));
}

std::array<int, 2> picture_size(const std::string& text) {
    const std::vector<std::string> parts = split(text, 'x');
    if (parts.size() != 2) {
        throw Error(ErrorKind::invalid_value,
                    "--size: '" + text + "' is not a width and a height, such as 1280x720");
    }
    return {parse_whole_number(parts[0], "--size", 16, 16384),
            parse_whole_number(parts[1], "--size", 16, 16384)};
}

int power_of_two(int value, const std::string& option) {
    if (value >= 32 && value <= 4096 && (value & (value - 1)) == 0) return value;
    throw Error(ErrorKind::invalid_value,
                option + " is " + std::to_string(value) + "; allowed: 32, 64, 128 .. 4096");
}

std::vector<std::string> water_names() {
    std::vector<std::string> names;
    for (const WaterType& type : water_types()) names.emplace_back(type.name);
    return names;
}

void place_camera(const PreviewWords& words, preview::Camera& camera) {
    if (!words.eye.empty()) camera.eye = place(words.eye, "--eye");
    if (!words.look_at.empty()) {
        if (words.heading || words.pitch) {
            throw Error(ErrorKind::invalid_value,
                        "--look-at and --heading or --pitch both turn it");
        }
        camera.look_at(place(words.look_at, "--look-at"));
    }
    if (words.heading) camera.heading = within(*words.heading, "--heading", -3600.0, 3600.0);
    if (words.pitch) camera.pitch = within(*words.pitch, "--pitch", -90.0, 90.0);
    if (words.angle) camera.field_of_view = within(*words.angle, "--angle", 1.0, 150.0);
}

void join_bridge(const PreviewWords& words, PreviewOptions& options) {
    std::string token;
    if (!words.token_file.empty()) token = bridge::read_token(words.token_file);
    options.serve = !words.serve.empty();
    options.host = {.token = token, .map = words.board_map, .dummy = words.dummy};
    if (options.serve) options.host.listen = words.serve;
    if (options.serve && !words.bridge.empty()) {
        throw Error(ErrorKind::invalid_value, "--serve is a bridge, and --bridge joins another");
    }
    if (words.bridge.empty()) {
        if (!words.follow) return;
        throw Error(ErrorKind::invalid_value, "--follow is for --bridge");
    }
    options.bridge.emplace();
    options.bridge->server = bridge::parse_endpoint(words.bridge, "--bridge");
    options.bridge->token = token;
    if (!words.follow) return;
    if (words.probes.empty()) throw Error(ErrorKind::invalid_value, "--follow is for --probe");
    options.follow = within(*words.follow, "--follow", 0.0, 1e6);
}

void place_environment(const PreviewWords& words, EnvironmentFiles& environments,
                       preview::Look& look) {
    if (words.environment.empty()) {
        if (!words.environment_turn) return;
        throw Error(ErrorKind::invalid_value, "--environment-turn is for --environment");
    }
    if (!words.sun.empty()) {
        throw Error(ErrorKind::invalid_value, "--environment has a sun of its own: no --sun");
    }
    auto& environment = environments[words.environment];
    if (!environment) {
        const io::Panorama sphere = io::read_exr_panorama(words.environment);
        environment = std::make_shared<const preview::Environment>(
            preview::make_environment(sphere.width, sphere.height, sphere.rgb));
    }
    look.environment = environment;
    look.environment_turn =
        within(words.environment_turn.value_or(0.0), "--environment-turn", -3600.0, 3600.0);
}

}  // namespace

std::vector<OptionGroup> preview_option_groups(PreviewWords& words) {
    return {
        sea_options(words.sea),
        {"When",
         {{"--time", &words.time, "T", "Seconds; default: the start of the sea"},
          {"--frame",
           &words.frame,
           "N",
           "A frame of the sea instead of a time",
           kOptional,
           {},
           "--time"}}},
        {"Camera",
         {{"--eye", &words.eye, "X,Y,Z",
           "Where it is, metres; Z above still water (default 0,0,8)"},
          {"--look-at", &words.look_at, "X,Y,Z", "A point in the middle of the picture"},
          {"--heading", &words.heading, "DEG",
           "Counter-clockwise from +x, the way that it looks (default 0)"},
          {"--pitch", &words.pitch, "DEG", "Above the horizontal (default -4)"},
          {"--angle", &words.angle, "DEG", "Horizontal field of view (default 60)"}}},
        {"Light",
         {{"--sun", &words.sun, "ALTITUDE,BEARING",
           "Degrees above the horizon, and counter-clockwise from +x (default 35,70)"},
          {"--environment", &words.environment, "FILE.exr",
           "A sky over longitude and latitude instead, z up: its top row is the zenith, its middle "
           "looks along +x, what is right of it lies clockwise seen from above; the sun in it is "
           "found"},
          {"--environment-turn", &words.environment_turn, "DEG",
           "Turns it counter-clockwise, seen from above"},
          {"--exposure", &words.exposure, "E", "Times the light (default 1)"},
          {"--visibility", &words.visibility, "M",
           "Metres after which haze leaves 2 % of contrasts, clear air 40000, 0: no haze (default "
           "60000)"},
          {"--crest-light", &words.crest_light, "F",
           "Times the sun's light through crests that are before it (default 1)"},
          {"--water", &words.water, "TYPE", "Optical type of the water (default jerlov_ii)",
           kOptional, OneOf{water_names()}}}},
        {"Picture",
         {{"--offscreen", &words.offscreen, "FILE",
           "Write one picture; needs no display: FILE.png as a screen shows it, FILE.exr its "
           "light, "
           "linear and times the exposure"},
          {"--record", &words.record, "FOLDER",
           "Write a picture for each of --frames: FOLDER/sea.0001.png; needs no display", kOptional,
           NotEmpty{}, "--offscreen"},
          {"--frames", &words.frames, "LIST", "1-250x2, in comma lists; of --record"},
          {"--pictures", &words.pictures, "LIST.txt",
           "Write a picture for each line of a file, all from one start: FILE, and the options of "
           "when, camera, light and picture in which it differs from what is given here, such as "
           "north.png --heading 90",
           kOptional, NotEmpty{}, "--offscreen"},
          {"--size", &words.size, "WxH",
           "Pixels (default 1280x720; of a window times its screen's scale, as far as the screen "
           "goes)"},
          {"--samples", &words.samples, "N",
           "Of a pixel, 1 .. 64 or what the driver has (default 4; 1 in a window without a GPU)",
           kOptional, Within{1, 64}},
          {"--view", &words.view, "VIEW",
           "What is shown; of h0, spectrum (h(k, t)) and butterfly a pixel for each wave",
           kOptional, OneOf{all_view_names()}},
          {"--look", &words.look, "LOOK",
           "physical (default), or seed: ten by ten periods in plain light and fog, as teaching "
           "programs draw it",
           kOptional, OneOf{preview::look_names()}},
          {"--wireframe", &words.wireframe, "", "The mesh alone"},
          {"--cascade", &words.cascade, "N", "The waves of one cascade alone, from 0"},
          {"--probe", &words.probes, "X,Y",
           "Print the height that is drawn at a place of the world, metres, and that of the "
           "maps there; may be given more than once"}}},
        {"Window",
         {{"--scale", &words.scale, "F",
           "Letters and controls F times as large, 0.5 .. 8 (default: what the screen asks for "
           "that the window is on)"}}},
        {"Bridge",
         {{"--bridge", &words.bridge, "HOST:PORT",
           "Join an ocean-bridge: its knobs and clients move the sea, and hear what moves here"},
          {"--serve", &words.serve, "HOST:PORT",
           "Be a bridge: boards and clients come to this window; the panel starts and stops it too",
           kOptional, NotEmpty{}},
          {"--board-map", &words.board_map, "FILE", "Which knob of its boards turns what",
           kOptional, NotEmpty{}},
          {"--dummy", &words.dummy, "", "Its board is one that is not there"},
          {"--token-file", &words.token_file, "FILE", "What the bridge asks for"},
          {"--follow", &words.follow, "S",
           "For S seconds print the probes again whenever the bridge has moved the sea, behind "
           "the milliseconds since that was heard"}}},
        {"Computing",
         {{"--backend", &words.backend, "NAME",
           "What computes the sea: auto (default) is gl on a real GPU of OpenGL 4.3, else cpu; "
           "radix2, dft and thesis are there to compare with",
           kOptional, OneOf{{"auto", "gl", "cpu", "radix2", "dft", "thesis"}}},
          {"--map", &words.map, "N", "Samples of a cascade's map along a side"},
          {"--foam-map", &words.foam_map, "N", "Samples of the map of foam"},
          {"--cells", &words.cells, "N", "Of a level of the mesh, 16 .. 512 in steps of 8"},
          {"--no-detail", &words.no_detail, "",
           "Leave the waves too short for the maps to the roughness"},
          {"--budget", &words.budget, "N",
           "Draw N frames, some more before them, and print what each stage of one takes, ms",
           kOptional, Within{1, 100000}},
          {"--egl-device", &words.egl_device, "N", "Of the devices that EGL lists, from 0"}}},
    };
}

PreviewOptions preview_options(const PreviewWords& words, EnvironmentFiles& environments) {
    PreviewOptions options;
    place_camera(words, options.camera);
    preview::Look& look = options.look;
    look.kind = preview::look_of(words.look);
    if (!words.sun.empty()) {
        const auto sun = numbers<2>(words.sun, "--sun", {{{-18.0, 90.0}, {-3600.0, 3600.0}}});
        look.sun_altitude = sun[0];
        look.sun_bearing = sun[1];
    }
    place_environment(words, environments, look);
    if (words.exposure) look.exposure = within(*words.exposure, "--exposure", 0.0, 1000.0);
    if (words.visibility) look.visibility = within(*words.visibility, "--visibility", 0.0, 1e9);
    if (words.crest_light) {
        look.crest_light = within(*words.crest_light, "--crest-light", 0.0, 10.0);
    }
    if (!words.water.empty()) look.water_type = words.water;
    options.view = words.view;
    options.has_size = !words.size.empty();
    if (options.has_size) options.size = picture_size(words.size);
    if (words.scale) options.scale = within(*words.scale, "--scale", kMinScale, kMaxScale);
    options.backend = words.backend;
    if (words.map) options.map = power_of_two(*words.map, "--map");
    if (words.foam_map) options.foam_map = power_of_two(*words.foam_map, "--foam-map");
    if (words.cells) {
        if (*words.cells % 8 != 0 || *words.cells < 16 || *words.cells > 512) {
            throw Error(ErrorKind::invalid_value, "--cells is " + std::to_string(*words.cells) +
                                                      "; allowed: 16, 24, 32 .. 512");
        }
        options.cells = *words.cells;
    }
    if (words.egl_device) gl::use_egl_device(*words.egl_device);
    join_bridge(words, options);
    options.samples = words.samples;
    options.budget = words.budget.value_or(0);
    options.time = words.time;
    options.frame = words.frame;
    if (!words.offscreen.empty()) {
        require_picture_name(words.offscreen, "--offscreen");
        if (is_stage_picture(words.view) && OutputPattern(words.offscreen).extension() != ".png") {
            throw Error(ErrorKind::invalid_value, "--view " + words.view +
                                                      ": is written as .png; its numbers are by "
                                                      "`ocean bake --stage`");
        }
    }
    options.offscreen = words.offscreen;
    if (words.record.empty() != words.frames.empty()) {
        throw Error(ErrorKind::invalid_value, "--record FOLDER and --frames LIST go together");
    }
    options.record = words.record;
    if (!words.frames.empty()) options.frames = parse_frames(words.frames);
    options.wireframe = words.wireframe;
    options.detail = !words.no_detail;
    options.cascade = words.cascade;
    for (const std::string& probe : words.probes) {
        options.probes.push_back(
            numbers<2>(probe, "--probe", {{{-kFarthest, kFarthest}, {-kFarthest, kFarthest}}}));
    }
    return options;
}

void require_fit(const PreviewOptions& options, const Sea& sea) {
    const int cascades = sea.parameters.grid.cascades;
    if (!options.cascade || (*options.cascade >= 0 && *options.cascade < cascades)) return;
    throw Error(
        ErrorKind::invalid_value,
        "--cascade is " + std::to_string(*options.cascade) + "; the sea has " +
            (cascades == 1 ? "one, 0"
                           : std::to_string(cascades) + ", 0 .. " + std::to_string(cascades - 1)));
}

}  // namespace ocean::app
