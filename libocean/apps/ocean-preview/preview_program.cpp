// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "preview_program.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include "command.hpp"
#include "command_line.hpp"
#include "console.hpp"
#include "ocean/version.hpp"
#include "offscreen_run.hpp"
#include "picture_list.hpp"
#include "preview_options.hpp"
#include "window/window.hpp"

namespace ocean::app {
namespace {

constexpr char kFooter[] =
    R"(SEA is a sea file, a terrain file, a file baked from one, or preset:NAME
of either; `ocean presets` lists them.
Keys: W A S D Q E move, Shift is fast, dragging turns, the wheel zooms; Space
pauses, R records, V changes the view, C the camera, F shows the mesh, P probes,
Tab hides the panel, Ctrl Z undoes a change, Ctrl R reads the sea file again,
F12 saves the picture, Escape closes the window; a take that is in no file is
saved then. Ctrl O opens a file, Ctrl S saves the sea under a name; a sea, a
take, a baked file or a sky can also be dropped on the window. A gamepad's
sticks move and turn, its A pauses, B changes the camera, X the view, Y returns
to the start.
H drives a hull of the sea, or a new one ahead of the camera, and ends the
drive: Up and Down change its speed, Left and Right turn it, and so does a
gamepad's left stick. Its way is its track, which is saved with the sea. Ctrl
and a click on the water place a crest on cue there, some seconds ahead.
--view of a sea: shaded, height, displacement_x, displacement_y, normal, slope,
jacobian, whitecap, foam, and with a pixel for each wave h0, spectrum (h(k, t))
and butterfly. Of a terrain: shaded, height, normal, slope, noise with a pixel
for each sample, and its transform, filter and spectrum (transform times
filter).
--probe prints x,y, the height of the mesh and of the maps at that place (m),
the square of the shown slope, the mean square slope that the light receives as
roughness, and the share of foam; only x,y where no water is drawn. Of land it
prints x,y, the height of the ground as the sum of all its waves, those of the
mesh and of the map, and the square of the shown slope.
Letters and controls of the panel follow the scale of the screen that the window
is on; --scale F (0.5 .. 8) sets another one.
-v reports the state of the window to scripts, on standard error: "the panel has
scale 2" when the scale changes, "the window is open" when it shows its first
picture and receives input, "written: FILE" for each file, and "at rest:
1280x720, mouse at 90,40, 12 keys, 3 clicks, 0 held" whenever all input is shown
and nothing moves until there is more: the clock stands, the sea has faded, foam
is complete. The numbers are the window's size, the mouse's place, the keys and
buttons pressed since the start, and those that are down. Lines of its bridge
begin with "bridge:", among them "joined" and "its values have come".
Exit codes: 0 done, 1 failed at run time (no GPU, disk), 2 wrong usage or bad
sea file, 130 interrupted.)";

void warn_of(const OpenedScene& scene, const Context& context) {
    for (const std::string& warning : row_of(*scene).warnings(*scene)) {
        context.console.warning(warning);
    }
}

void run(const PreviewWords& words, const Context& context) {
    EnvironmentFiles environments;
    const PreviewOptions options = preview_options(words, context.given, environments);
    std::vector<ListedPicture> pictures;
    if (!words.pictures.empty()) pictures = read_picture_list(words.pictures, words);
    const OpenedScene scene = open_scene(words.sea);
    require_fit(options, scene);
    for (const ListedPicture& picture : pictures) require_fit(picture.options, scene);
    const bool in_window = options.offscreen.empty() && options.record.empty() &&
                           words.pictures.empty() && options.probes.empty() && options.budget == 0;
    if (options.serve && !in_window) {
        refuse("--serve is for the window; --bridge joins a bridge");
    }
    if (options.scale && !in_window) {
        refuse("--scale is for the window; --size is of a picture");
    }
    if (options.bridge && !words.pictures.empty()) {
        refuse("--pictures shows the sea of its file: no --bridge");
    }
    if (in_window) {
        warn_of(scene, context);
        run_window(options, scene, words.sea, context);
    } else {
        run_offscreen(options, pictures, scene, words.sea.source, context);
        warn_of(scene, context);
    }
}

Command preview_command() {
    auto words = std::make_shared<PreviewWords>();
    std::vector<OptionGroup> groups = {scene_options(words->sea)};
    std::ranges::move(preview_option_groups(*words), std::back_inserter(groups));
    groups.push_back(run_options(""));
    return {.name = "ocean-preview",
            .summary = "A sea or a terrain to its horizon, in a window or as a picture.",
            .options = std::move(groups),
            .footer = kFooter,
            .run = [words](const Context& context) { run(*words, context); }};
}

}  // namespace

int run_preview(int argc, char** argv) {
    return run_program(argc, argv,
                       {.main = preview_command(),
                        .version = "ocean-preview " OCEAN_VERSION "\n" OCEAN_LIBRARY_VERSIONS});
}

}  // namespace ocean::app
