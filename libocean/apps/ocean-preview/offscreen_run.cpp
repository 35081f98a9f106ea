// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "offscreen_run.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "bridge_run.hpp"
#include "console.hpp"
#include "frame_budget.hpp"
#include "interrupt.hpp"
#include "land_camera.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/preview/canvas.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "offscreen_scene.hpp"
#include "picture_file.hpp"
#include "stage_layout.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

/// A context, and the backend that computes the sea.
struct Device {
    std::unique_ptr<gl::HeadlessContext> context;
    Backend backend;
};

Device open_device(const std::string& name) {
    std::optional<Backend> backend = preview_backend(name);
    std::unique_ptr<gl::HeadlessContext> drawing;
    if (!backend || !computes_by_shaders(*backend)) {
        drawing = std::make_unique<gl::HeadlessContext>(gl::HeadlessOptions{.compute = false});
        if (!backend) backend = best_backend(drawing->info());
        if (!computes_by_shaders(*backend)) return {std::move(drawing), *backend};
    }
    drawing.reset();
    return {std::make_unique<gl::HeadlessContext>(), *backend};
}

preview::DrawOptions draw_options(const PreviewOptions& options, preview::SceneKind kind) {
    preview::DrawOptions draw;
    draw.width = options.size[0];
    draw.height = options.size[1];
    draw.view = preview::view_of(options.view, kind);
    draw.wireframe = options.wireframe;
    draw.cascade = options.cascade.value_or(-1);
    return draw;
}

/// Pictures of one scene in the current context.
class OffscreenRun {
  public:
    OffscreenRun(const PreviewOptions& options, const OpenedScene& scene, const Context& context,
                 const Device& device)
        : options_(options),
          context_(context),
          kind_(kind_of(scene)),
          scene_(make_offscreen_scene(scene, options, device.backend, device.context->info(),
                                      context)),
          renderer_(renderer_for(options, device.context->info(), false)) {}

    void print_probes() {
        for (const auto& place : options_.probes) {
            context_.console.data(
                scene_->probe_line(renderer_, options_, place, scene_->time_of(options_)));
            warn_of_left_out();
        }
    }

    void draw(const PreviewOptions& options, const std::string& path) {
        draw(options, scene_->time_of(options), path);
    }

    void record(const std::string& stem) {
        const OutputPattern pattern(options_.record + "/" + stem + ".####.png");
        io::make_folder(options_.record);
        begin(options_.frames.size());
        for (const int frame : options_.frames) {
            draw_step(frame, options_, scene_->time_of_frame(frame), pattern.file(frame));
        }
        context_.console.finish();
    }

    void draw_list(const std::vector<ListedPicture>& pictures) {
        begin(pictures.size());
        int number = 0;
        for (const auto& [path, options] : pictures) {
            draw_step(++number, options, scene_->time_of(options), path);
        }
        context_.console.finish();
    }

  private:
    void begin(std::size_t pictures) {
        context_.console.begin(static_cast<int>(pictures), std::to_string(pictures) + " pictures",
                               {});
    }
    void draw_step(int number, const PreviewOptions& options, double time,
                   const std::string& path) {
        const auto start = std::chrono::steady_clock::now();
        draw(options, time, path);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        context_.console.step(number, seconds.count(), {path});
    }
    void draw(const PreviewOptions& options, double time, const std::string& path) {
        if (is_stage_picture(options.view)) {
            const auto [width, height] = options.size;
            const StagePicture stage = laid_out(scene_->stage(options, time), width, height);
            const InterruptWatch::Hold whole = context_.interrupts.hold();
            return io::write_png(path, stage.width, stage.height, stage.rgb);
        }
        const preview::DrawnScene& shown = scene_->shown_at(options, time);
        std::string warning;
        const preview::Camera camera = scene_->camera_of(options, warning);
        if (!warning.empty()) context_.console.warning(warning);
        const InterruptWatch::Hold whole = context_.interrupts.hold();
        write_picture(path, renderer_, shown, camera, options.look, draw_options(options, kind_),
                      options.samples.value_or(kSamples));
        warn_of_left_out();
    }
    /// Warns once of the parts of the last picture that the driver has too few texture units for.
    void warn_of_left_out() {
        const std::string words = preview::text(renderer_.left_out());
        if (words.empty() || std::exchange(warned_, true)) return;
        context_.console.warning(words);
    }

    const PreviewOptions& options_;
    const Context& context_;
    preview::SceneKind kind_;
    std::unique_ptr<OffscreenScene> scene_;
    preview::Renderer renderer_;
    bool warned_ = false;
};

double time_of(const PreviewOptions& options, const Sea& sea) {
    if (options.frame) return sea.time_of(*options.frame);
    return options.time.value_or(sea.parameters.time.start);
}

/// Draws the sea with the values that a bridge has, and follows its changes.
void draw_with_bridge(const PreviewOptions& options, const Sea& sea, const Context& context,
                      const Device& device, double time) {
    const gl::ContextInfo& info = device.context->info();
    // A probe that follows a knob does not wait for foam to settle.
    const FoamStart foam = options.follow > 0.0 ? FoamStart::empty : FoamStart::settled;
    const auto computing = [&](const Sea& of) {
        Computing computing = computing_for(device.backend, options, of, info);
        computing.maps.foam_start = foam;
        computing.maps.live = options.follow > 0.0;
        return computing;
    };
    LiveSea live(sea,
                 {.threads = context.options.threads, .computing = computing, .foam_start = foam});
    live.near_detail = options.detail;
    live.go_to(time);
    preview::Renderer renderer(renderer_for(options, info, options.follow > 0.0));
    bool first = true;
    const auto show = [&](double milliseconds) {
        const preview::DrawnSea shown = live.show(options.camera.eye);
        for (const auto& place : options.probes) {
            const std::string when =
                options.follow > 0.0 ? format_text("%.1f,", milliseconds) : std::string();
            context.console.data(when + sea_probe_line(renderer, shown, options, place));
        }
        if (!std::exchange(first, false) || options.offscreen.empty()) return;
        const InterruptWatch::Hold whole = context.interrupts.hold();
        write_picture(options.offscreen, renderer, shown, options.camera, options.look,
                      draw_options(options, preview::SceneKind::sea),
                      options.samples.value_or(kSamples));
        context.console.data(options.offscreen + "\n");
    };
    run_with_bridge(*options.bridge, options.follow, live, context.console, show);
}

/// A function that makes the scene of a frame, counted from 0.
using ShowFrame = std::function<preview::DrawnScene(int frame)>;

/// Returns the frames of a running sea, at its own rate from a time on [s].
ShowFrame frames_of(const Sea& sea, const Computing& computing, const Context& context,
                    const PreviewOptions& options, const gl::AfterStage& after_stage) {
    const auto live = std::make_shared<Ocean>(sea, OceanOptions{.threads = context.options.threads,
                                                                .backend = computing.backend,
                                                                .foam_start = FoamStart::empty});
    const auto maps = std::make_shared<preview::SeaMaps>(computing.maps, after_stage);
    std::array<double, 3> eye = options.camera.eye;
    if (const auto& bed = sea.parameters.water.bed) eye = eye_on_coast(options, *bed);
    return [live, maps, eye, start = time_of(options, sea), fps = sea.parameters.time.fps](
               int frame) { return maps->show(*live, start + frame / fps, eye); };
}

/// Returns the frames of a land, which stands still.
ShowFrame frames_of(const TerrainModel& terrain, const PreviewOptions& options,
                    const Device& device, const Context& context) {
    const auto land = std::make_shared<Terrain>(
        terrain, TerrainOptions{.threads = context.options.threads, .backend = device.backend});
    const auto maps = std::make_shared<preview::LandMaps>();
    const int resolution = land_map_for(options, terrain, device.context->info(), true);
    return [land, maps, resolution](int) { return maps->show(*land, resolution); };
}

/// Moves the eye ahead by a frame of a flight.
void fly(preview::Camera& camera) {
    constexpr double kStep = 1.25;  // [m], 30 m/s at 24 frames a second
    const std::array<double, 3> ahead = camera.line_of_sight(0.5, 0.5, 1.0);
    const double level = std::max(std::hypot(ahead[0], ahead[1]), 1e-6);
    for (std::size_t axis = 0; axis < 2; ++axis) camera.eye[axis] += kStep * ahead[axis] / level;
}

/// Returns a line about the mesh of a land.
std::string mesh_line(const preview::LandStatistics& mesh) {
    return format_text("land: %zu squares, %zu triangles, %.1f MiB of textures", mesh.patches,
                       mesh.triangles, static_cast<double>(mesh.resident_bytes) / (1 << 20));
}

/// Draws frames like a window into a canvas of the picture's size, and prints the time of their
/// stages. Over land the eye flies ahead.
void print_budget(const PreviewOptions& options, const OpenedScene& scene, const Context& context,
                  const Device& device) {
    constexpr int kBefore = 10;  // frames that compile shaders and allocate memory
    FrameBudget warm, budget;
    FrameBudget* measured = &warm;
    const gl::AfterStage after_stage = [&](std::string_view stage) {
        measured->after_stage()(stage);
    };
    const gl::ContextInfo& info = device.context->info();
    ShowFrame show;
    preview::Camera camera = options.camera;
    if (const auto* const sea = std::get_if<Sea>(&scene)) {
        show = frames_of(*sea, computing_for(device.backend, options, *sea, info), context, options,
                         after_stage);
        if (sea->parameters.water.bed) {
            const preview::DrawnScene first = show(0);
            place_on_coast(options, *std::get<preview::DrawnSea>(first).coast, camera);
        }
    } else {
        show = frames_of(std::get<TerrainModel>(scene), options, device, context);
        place_on_land(options, std::get<preview::DrawnLand>(show(0)), camera);
    }
    const bool flies = kind_of(scene) == preview::SceneKind::land;
    preview::RendererOptions renderer_options = renderer_for(options, info, true);
    renderer_options.after_stage = after_stage;
    renderer_options.live = flies;
    preview::Renderer renderer(renderer_options);
    const preview::DrawOptions draw = draw_options(options, kind_of(scene));
    const preview::Canvas canvas(draw.width, draw.height, GL_RGBA8, live_samples(options, info));
    for (int frame = 0; frame < kBefore + options.budget; ++frame) {
        measured = frame < kBefore ? &warm : &budget;
        measured->begin();
        const preview::DrawnScene shown = show(frame);
        after_stage("state");
        if (flies) fly(camera);
        canvas.bind();
        renderer.draw(shown, camera, options.look, draw);
        measured->end_frame();
    }
    context.console.data(budget.table());
    if (flies) context.console.note(mesh_line(renderer.land_statistics()));
}

}  // namespace

std::string stem_of(const std::string& source) {
    const std::size_t colon = source.rfind(':');
    const std::string name = colon == std::string::npos ? source : source.substr(colon + 1);
    const std::string stem = utf8_path(name).stem().string();
    return stem.empty() || stem == "-" ? "sea" : stem;
}

void run_offscreen(const PreviewOptions& options, const std::vector<ListedPicture>& pictures,
                   const OpenedScene& scene, const std::string& source, const Context& context) {
    if (!options.offscreen.empty()) require_picture_folder(options.offscreen);
    for (const ListedPicture& picture : pictures) require_picture_folder(picture.path);
    const Device device = open_device(options.backend);
    const gl::HeadlessContext::Current current(*device.context);
    context.console.note("drawn by " + device.context->info().text() + "; the " +
                         noun_of(kind_of(scene)) + " by " + std::string(device.backend.name));
    if (options.bridge) {
        const Sea& sea = std::get<Sea>(scene);
        return draw_with_bridge(options, sea, context, device, time_of(options, sea));
    }
    OffscreenRun run(options, scene, context, device);
    run.print_probes();
    if (!options.offscreen.empty()) {
        run.draw(options, options.offscreen);
        context.console.data(options.offscreen + "\n");
    }
    if (!options.record.empty()) run.record(stem_of(source));
    if (!pictures.empty()) run.draw_list(pictures);
    if (options.budget > 0) print_budget(options, scene, context, device);
}

}  // namespace ocean::app
