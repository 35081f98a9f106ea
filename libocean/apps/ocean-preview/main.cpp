// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean-preview`: from a sea file to its picture.
#include <algorithm>
#include <memory>

#include "command_line.hpp"
#include "console.hpp"
#include "ocean/cascades.hpp"
#include "ocean/error.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/io/png.hpp"
#include "ocean/ocean.hpp"
#include "ocean/preview/canvas.hpp"
#include "ocean/preview/probe.hpp"
#include "ocean/preview/renderer.hpp"
#include "ocean/text.hpp"
#include "ocean/version.hpp"
#include "preview_options.hpp"

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
    const gl::ContextInfo& info = drawing->info();
    const bool fit = !info.software && (info.major > 4 || (info.major == 4 && info.minor >= 3));
    if (computer == Computer::processor || !fit) return {std::move(drawing), false};
    drawing.reset();
    return {std::make_unique<gl::HeadlessContext>(), true};
}

/// Samples of the largest maps, and cells of the mesh, that a processor that plays a GPU draws in
/// time.
constexpr int kSoftwareMap = 256;
constexpr int kSoftwareFoamMap = 512;
constexpr int kSoftwareCells = 64;

void draw_offscreen(const PreviewOptions& options, const Sea& opened, const Context& context) {
    const Device device = open_device(options.computer);
    const gl::HeadlessContext::Current current(*device.context);
    const bool software = device.context->info().software;
    context.console.note("drawn by " + device.context->info().text() + "; computed by " +
                         (device.computes ? "the same" : "the processor"));
    Ocean sea(opened, {.threads = context.options.threads});
    const double time = options.frame  ? opened.time_of(*options.frame)
                        : options.time ? *options.time
                                       : opened.parameters.time.start;
    const Grid& grid = opened.parameters.grid;
    preview::SeaMapsOptions map_options{.compute = device.computes,
                                        .cascade_resolution = options.map.value_or(0),
                                        .foam_resolution = options.foam_map.value_or(0),
                                        .foam_start = FoamStart::settled};
    preview::RendererOptions render_options;
    if (software) {
        if (!options.map) map_options.cascade_resolution = std::min(grid.resolution, kSoftwareMap);
        if (!options.foam_map) {
            map_options.foam_resolution = std::min(default_map_resolution(grid), kSoftwareFoamMap);
        }
        render_options.cells = kSoftwareCells;
    }
    if (options.cells) render_options.cells = *options.cells;
    preview::SeaMaps maps(map_options);
    preview::Renderer renderer(render_options);
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
            .summary = "The sea to its horizon, as a picture.",
            .options = std::move(groups),
            .footer = kFooter,
            .run = [words](const Context& context) {
                const PreviewOptions options = preview_options(*words);
                if (options.offscreen.empty() && options.probes.empty()) {
                    throw Error(ErrorKind::invalid_value, "--offscreen or --probe is required");
                }
                draw_offscreen(options, open_sea(words->sea), context);
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
