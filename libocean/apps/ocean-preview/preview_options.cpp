// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "preview_options.hpp"

#include <algorithm>

#include "command.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/io/panorama.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/water_types.hpp"
#include "picture_list.hpp"

namespace ocean::app {
namespace {

constexpr double kFarthest = 1e9;  // [m]

/// "1,2.5,3" for an option.
template <std::size_t kCount>
std::array<double, kCount> numbers(const std::string& text, const std::string& option,
                                   std::array<std::array<double, 2>, kCount> ranges) {
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() != kCount) {
        refuse(option + ": '" + text + "' is not " + std::to_string(kCount) +
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
    refuse(option + " is " + shortest_text(value) + "; allowed: " + shortest_text(lowest) + " .. " +
           shortest_text(highest));
}

std::array<int, 2> picture_size(const std::string& text) {
    const std::vector<std::string> parts = split(text, 'x');
    if (parts.size() != 2) {
        refuse("--size: '" + text + "' is not a width and a height, such as 1280x720");
    }
    return {parse_whole_number(parts[0], "--size", 16, 16384),
            parse_whole_number(parts[1], "--size", 16, 16384)};
}

void require_power_of_two(int value, const std::string& option) {
    if (value >= 32 && value <= 4096 && (value & (value - 1)) == 0) return;
    refuse(option + " is " + std::to_string(value) + "; allowed: 32, 64, 128 .. 4096");
}

std::vector<std::string> water_names() {
    std::vector<std::string> names;
    for (const WaterType& type : water_types()) names.emplace_back(type.name);
    return names;
}

/// Sets the eye by "X,Y,Z", or by "X,Y" on the ground of land.
void place_eye(const std::string& text, PreviewOptions& options) {
    if (std::ranges::count(text, ',') != 1) {
        options.camera.eye = place(text, "--eye");
        options.eye_place = EyePlace::at;
        return;
    }
    const auto [x, y] =
        numbers<2>(text, "--eye", {{{-kFarthest, kFarthest}, {-kFarthest, kFarthest}}});
    options.camera.eye = {x, y, 0.0};
    options.eye_place = EyePlace::on_ground;
}

void place_camera(const PreviewWords& words, PreviewOptions& options) {
    preview::Camera& camera = options.camera;
    if (!words.eye.empty()) place_eye(words.eye, options);
    if (!words.look_at.empty()) {
        if (words.heading || words.pitch) {
            refuse("--look-at and --heading or --pitch both turn the camera");
        }
        options.look_at = place(words.look_at, "--look-at");
        camera.look_at(*options.look_at);
    }
    options.has_heading = words.heading.has_value();
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
        refuse("--serve runs a bridge, and --bridge joins another one");
    }
    if (words.bridge.empty()) {
        if (!words.follow) return;
        refuse("--follow is for --bridge");
    }
    options.bridge.emplace();
    options.bridge->server = bridge::parse_endpoint(words.bridge, "--bridge");
    options.bridge->token = token;
    if (!words.follow) return;
    if (words.probes.empty()) refuse("--follow is for --probe");
    options.follow = within(*words.follow, "--follow", 0.0, 1e6);
}

void place_environment(const PreviewWords& words, EnvironmentFiles& environments,
                       preview::Look& look) {
    if (words.environment.empty()) {
        if (!words.environment_turn) return;
        refuse("--environment-turn is for --environment");
    }
    if (!words.sun.empty()) {
        refuse("--environment has a sun of its own: no --sun");
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

/// Returns the given options that only one kind of subject has.
std::vector<SpecialOption> special_options(std::span<const GivenOption> given, EyePlace eye) {
    std::vector<SpecialOption> special;
    if (eye == EyePlace::on_ground) special.push_back({kTerrainKind, "--eye X,Y"});
    for (const auto& [option, value] : given) {
        if (option->subject.empty()) continue;
        const std::string said = option->names == "--look" ? " " + value : "";
        special.push_back({option->subject, option->names + said});
    }
    return special;
}

}  // namespace

std::vector<OptionGroup> preview_option_groups(PreviewWords& words) {
    return {
        {"When",
         {only_of(kSeaKind, {"--time", &words.time, "T", "Seconds; default: the start of the sea"}),
          only_of(kSeaKind, {"--frame", &words.frame, "N", "A frame of the sea instead of a time",
                             kOptional, ValueRule(), "--time"})}},
        {"Camera",
         {{"--eye", &words.eye, "X,Y,Z",
           "Place of the camera, metres; Z above still water (default 0,0,8). X,Y alone stands on "
           "land, 1.7 m above its ground; the default there is higher"},
          {"--look-at", &words.look_at, "X,Y,Z", "A point in the middle of the picture"},
          {"--heading", &words.heading, "DEG",
           "Direction of the view, counter-clockwise from +x (default 0)"},
          {"--pitch", &words.pitch, "DEG", "Angle of the view above the horizontal (default -4)"},
          {"--angle", &words.angle, "DEG", "Horizontal field of view (default 60)"}}},
        {"Light",
         {{"--sun", &words.sun, "ALTITUDE,BEARING",
           "Degrees above the horizon, and counter-clockwise from +x (default 35,70)"},
          {"--environment", &words.environment, "FILE.exr",
           "A sky over longitude and latitude, with its sun: its top row is the zenith, its "
           "middle column lies along +x, columns right of it clockwise from above"},
          {"--environment-turn", &words.environment_turn, "DEG",
           "Turns that sky counter-clockwise, seen from above"},
          {"--exposure", &words.exposure, "E", "Factor of the light (default 1)"},
          {"--visibility", &words.visibility, "M",
           "Distance at which haze leaves 2 % of contrasts, metres; clear air 40000, 0: no haze "
           "(default 60000)"},
          only_of(kSeaKind,
                  {"--crest-light", &words.crest_light, "F",
                   "Factor of the sun's light through crests in front of it (default 1)"}),
          only_of(kSeaKind,
                  {"--water", &words.water, "TYPE", "Optical type of the water (default jerlov_ii)",
                   kOptional, OneOf{water_names()}}),
          only_of(kTerrainKind, {"--colours", &words.colours, "COLOURS",
                                 "Colours of land: land (default), by height, slope and a snow "
                                 "line, or seed, the ramp "
                                 "of two colours of teaching programs",
                                 kOptional, OneOf{preview::land_colour_names()}}),
          only_of(kTerrainKind, {"--snow-line", &words.snow_line, "M",
                                 "Height above which snow lies on level ground, metres (default: "
                                 "1.3 rms heights above "
                                 "the mean, none on land with a coast)"})}},
        {"Picture",
         {{"--offscreen", &words.offscreen, "FILE",
           "Write one picture; needs no display: FILE.png as a screen shows it, FILE.exr as "
           "linear light times the exposure"},
          only_of(kSeaKind,
                  {"--record", &words.record, "FOLDER",
                   "Write a picture for each of --frames: FOLDER/sea.0001.png; needs no display",
                   kOptional, NotEmpty{}, "--offscreen"}),
          {"--frames", &words.frames, "LIST",
           "Frames of --record, for example 1-250x2; a comma separates ranges"},
          {"--pictures", &words.pictures, "LIST.txt",
           "Write a picture for each line of a file: FILE and its options of when, camera, light "
           "and picture, such as north.png --heading 90",
           kOptional, NotEmpty{}, "--offscreen"},
          {"--size", &words.size, "WxH",
           "Pixels (default 1280x720; a window multiplies this by its screen's scale, up to the "
           "screen's size)"},
          {"--samples", &words.samples, "N",
           "Samples of a pixel, 1 .. 64, up to the driver's limit (default 4; 1 in a window "
           "without a GPU)",
           kOptional, Within{1, 64}},
          {"--view", &words.view, "VIEW",
           "The field to show (default shaded); below are those of a sea and of a terrain",
           kOptional, OneOf{all_view_names()}},
          only_of(kSeaKind, {"--look", &words.look, "LOOK",
                             "physical (default), or seed: ten by ten periods in plain light and "
                             "fog, as teaching "
                             "programs draw the sea",
                             kOptional, OneOf{preview::look_names()}}),
          {"--wireframe", &words.wireframe, "", "Draw the mesh without surfaces"},
          only_of(kSeaKind,
                  {"--cascade", &words.cascade, "N", "Show only the waves of one cascade, from 0"}),
          {"--probe", &words.probes, "X,Y",
           "Print the drawn height at a place of the world, metres, and the height of the maps "
           "there, of land first that of all its waves; may be repeated"}}},
        {"Window",
         {{"--scale", &words.scale, "F",
           "Letters and controls F times as large, 0.5 .. 8 (default: the scale of the window's "
           "screen)"}}},
        {"Bridge",
         {only_of(kSeaKind, {"--bridge", &words.bridge, "HOST:PORT",
                             "Join an ocean-bridge: its knobs and clients change the sea, and "
                             "receive changes made "
                             "here"}),
          only_of(kSeaKind, {"--serve", &words.serve, "HOST:PORT",
                             "Run a bridge in this window: boards and clients connect to it; the "
                             "panel starts and "
                             "stops it too",
                             kOptional, NotEmpty{}}),
          {"--board-map", &words.board_map, "FILE",
           "Control map of its boards: which knob sets which parameter", kOptional, NotEmpty{}},
          {"--dummy", &words.dummy, "", "Simulate its board"},
          {"--token-file", &words.token_file, "FILE", "File with the bridge's token"},
          {"--follow", &words.follow, "S",
           "For S seconds print the probes again after each change by the bridge, behind the "
           "milliseconds since the change arrived"}}},
        {"Computing",
         {{"--backend", &words.backend, "NAME",
           "Backend that computes the sea: auto (default) is gl on a GPU with OpenGL 4.3, else "
           "cpu; radix2, dft and thesis are for comparison",
           kOptional, OneOf{{"auto", "gl", "cpu", "radix2", "dft", "thesis"}}},
          {"--map", &words.map, "N", "Samples of a cascade's map along a side"},
          only_of(kSeaKind,
                  {"--foam-map", &words.foam_map, "N", "Samples of the foam's map along a side"}),
          only_of(kSeaKind, {"--cells", &words.cells, "N",
                             "Cells of a level of the mesh of a sea, 16 .. 512 in steps of 8"}),
          only_of(kSeaKind, {"--no-detail", &words.no_detail, "",
                             "Show the waves too short for the maps as roughness only"}),
          {"--budget", &words.budget, "N",
           "Draw N frames after a few to warm up, and print the time of each stage, ms", kOptional,
           Within{1, 100000}},
          {"--egl-device", &words.egl_device, "N", "Device to draw on, of EGL's list, from 0"}}},
    };
}

PreviewOptions preview_options(const PreviewWords& words, std::span<const GivenOption> given,
                               EnvironmentFiles& environments) {
    PreviewOptions options;
    static_cast<PlainOptions&>(options) = words;
    place_camera(words, options);
    options.special = special_options(given, options.eye_place);
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
    look.land_colours = preview::land_colours_of(words.colours);
    if (words.snow_line) {
        look.snow_line = within(*words.snow_line, "--snow-line", -1e6, 1e6);
    }
    options.has_size = !words.size.empty();
    if (options.has_size) options.size = picture_size(words.size);
    if (words.scale) within(*words.scale, "--scale", kMinScale, kMaxScale);
    if (words.map) require_power_of_two(*words.map, "--map");
    if (words.foam_map) require_power_of_two(*words.foam_map, "--foam-map");
    if (words.cells && (*words.cells % 8 != 0 || *words.cells < 16 || *words.cells > 512)) {
        refuse("--cells is " + std::to_string(*words.cells) + "; allowed: 16, 24, 32 .. 512");
    }
    if (words.egl_device) gl::use_egl_device(*words.egl_device);
    join_bridge(words, options);
    options.budget = words.budget.value_or(0);
    if (!words.offscreen.empty()) {
        require_picture_name(words.offscreen, "--offscreen");
        if (is_stage_picture(words.view) && OutputPattern(words.offscreen).extension() != ".png") {
            refuse("--view " + words.view +
                   " can only be written as .png; `ocean bake --stage` writes its "
                   "numbers");
        }
    }
    if (words.record.empty() != words.frames.empty()) {
        refuse("--record FOLDER and --frames LIST go together");
    }
    if (!words.frames.empty()) options.frames = parse_frames(words.frames);
    options.detail = !words.no_detail;
    for (const std::string& probe : words.probes) {
        options.probes.push_back(
            numbers<2>(probe, "--probe", {{{-kFarthest, kFarthest}, {-kFarthest, kFarthest}}}));
    }
    return options;
}

void require_fit(const PreviewOptions& options, const OpenedScene& scene) {
    const SceneRow& row = row_of(*scene);
    const std::string noun(row.kind);
    for (const auto& [kind, text] : options.special) {
        if (kind == row.kind || kind == row.includes(*scene)) continue;
        refuse(text + " is for a " + std::string(kind) + "; this is a " + noun);
    }
    const std::vector<std::string> views = all_view_names(row);
    if (std::ranges::find(views, options.view) == views.end()) {
        refuse("--view: a " + noun + " has no view '" + options.view +
               "'; allowed: " + joined(views, ", "));
    }
    row.require_fit(*scene, options);
}

}  // namespace ocean::app
