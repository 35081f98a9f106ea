// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean-preview`: from a sea file to its picture.
#include <memory>

#include "command_line.hpp"
#include "console.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/io/png.hpp"
#include "ocean/ocean.hpp"
#include "ocean/preview/canvas.hpp"
#include "ocean/preview/probe.hpp"
#include "ocean/preview/renderer.hpp"
#include "ocean/text.hpp"
#include "ocean/version.hpp"
#include "preview_options.hpp"
#include "window.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

/// A context, and whether it computes too.
struct Device {
    std::unique_ptr<gl::HeadlessContext> context;
    bool computes;
};

Device open_device(Computer computer) {
    if (computer == Computer::gpu) return {std::make_unique<gl::HeadlessContext>(), true};
    auto drawing = std::make_unique<gl::HeadlessContext>(gl::HeadlessOptions{.compute = false});
    if (computer == Computer::processor || !computes_well(drawing->info())) {
        return {std::move(drawing), false};
    }
    drawing.reset();
    return {std::make_unique<gl::HeadlessContext>(), true};
}

void draw_offscreen(const PreviewOptions& options, const Sea& opened, const Context& context) {
    const Device device = open_device(options.computer);
    const gl::HeadlessContext::Current current(*device.context);
    context.console.note("drawn by " + device.context->info().text() + "; computed by " +
                         (device.computes ? "the same" : "the processor"));
    Ocean sea(opened, {.threads = context.options.threads});
    const double time = options.frame  ? opened.time_of(*options.frame)
                        : options.time ? *options.time
                                       : opened.parameters.time.start;
    Workload work = workload_for(options, opened, device.context->info(), device.computes);
    work.maps.foam_start = FoamStart::settled;
    preview::SeaMaps maps(work.maps);
    preview::Renderer renderer(work.renderer);
    const preview::ShownSea shown = maps.show(sea, time);
    for (const auto& place : options.probes) {
        const auto found = preview::probe(renderer, shown, options.camera, place);
        std::string line = shortest_text(place[0]) + "," + shortest_text(place[1]);
        if (found) {
            for (const double value : {found->mesh_height, found->map_height, found->shown_slope,
                                       found->handed_on_slope}) {
                line += "," + shortest_text(static_cast<float>(value));
            }
        }
        context.console.data(line + "\n");
    }
    if (options.offscreen.empty()) return;
    const auto [width, height] = options.size;
    const preview::Canvas canvas(width, height, GL_RGBA8);
    preview::DrawOptions draw;
    draw.width = width;
    draw.height = height;
    draw.view = options.view;
    draw.wireframe = options.wireframe;
    renderer.draw(shown, options.camera, options.look, draw);
    io::write_png(options.offscreen, width, height, canvas.rgb());
    context.console.data(options.offscreen + "\n");
}

constexpr char kFooter[] =
    R"(SEA is a sea file, a baked EXR file or preset:NAME.
Keys: W A S D Q E move, Shift is fast, dragging turns, the wheel zooms; Space
pauses, V changes the view, C the camera, F shows the mesh, P probes, Tab hides
the panel, F12 saves the picture, Escape ends.
--probe prints x,y, the height of the mesh there and that of the maps (m), the
square of the slope that is shown and the mean square slope that the light gets
as roughness; nothing behind x,y where nothing is drawn.
Exit codes: 0 done, 1 failed at run time (no GPU, disk), 2 wrong usage or bad sea
file, 130 interrupted.)";

Command preview_command() {
    auto words = std::make_shared<PreviewWords>();
    std::vector<OptionGroup> groups = preview_option_groups(*words);
    groups.push_back(run_options(""));
    return {.name = "ocean-preview",
            .summary = "The sea to its horizon, in a window or as a picture.",
            .options = std::move(groups),
            .footer = kFooter,
            .run = [words](const Context& context) {
                const PreviewOptions options = preview_options(*words);
                const Sea sea = open_sea(words->sea);
                if (options.offscreen.empty() && options.probes.empty()) {
                    run_window(options, sea, words->sea.source, context);
                } else {
                    draw_offscreen(options, sea, context);
                }
            }};
}

}  // namespace
}  // namespace ocean::app

int main(int argc, char** argv) {
    using namespace ocean::app;
    return run_program(argc, argv,
                       {.main = preview_command(),
                        .version = "ocean-preview " OCEAN_VERSION "\n" OCEAN_LIBRARY_VERSIONS});
}
