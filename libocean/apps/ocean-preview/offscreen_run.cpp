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

#include "bridge_link.hpp"
#include "console.hpp"
#include "frame_budget.hpp"
#include "interrupt.hpp"
#include "land_camera.hpp"
#include "live_sea.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/line_client.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/preview/canvas.hpp"
#include "ocean/internal/text.hpp"
#include "picture_list.hpp"
#include "scene.hpp"
#include "stage_picture.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kStep{20};
constexpr std::chrono::seconds kMaxJoinTime{3};

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Joins the bridge, applies the values that its clients have set and calls `changed` once; then,
/// for so many seconds, after each further change of the sea, with the milliseconds since it
/// arrived. Values hold at once, nothing glides. Throws Error output if no bridge answers.
void run_with_bridge(const bridge::LineClientOptions& options, double seconds, LiveSea& sea,
                     Console& console, const std::function<void(double milliseconds)>& changed) {
    BridgeLink link(options, {.record = [](bool, const std::string&) {}});
    const Clock::time_point start = Clock::now();
    while (!link.joined() && Clock::now() - start < kMaxJoinTime) {
        link.wait_and_apply(sea, kStep);
    }
    const auto note_log = [&] {
        for (const std::string& line : link.extract_log()) console.note("bridge: " + line);
    };
    note_log();
    if (!link.joined()) {
        throw Error(ErrorKind::output, "no bridge answers at " + options.server.text());
    }
    sea.settle();
    changed(milliseconds_since(start));
    const Clock::time_point joined = Clock::now();
    while (std::chrono::duration<double>(Clock::now() - joined).count() < seconds) {
        const bool moved = link.wait_and_apply(sea, kStep);
        note_log();
        if (!moved) continue;
        const Clock::time_point heard = Clock::now();
        sea.settle();
        changed(milliseconds_since(heard));
    }
}

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

preview::DrawOptions draw_options(const PreviewOptions& options) {
    preview::DrawOptions draw;
    draw.width = options.size[0];
    draw.height = options.size[1];
    draw.view = preview::view_of(options.view);
    draw.wireframe = options.wireframe;
    draw.cascade = options.cascade.value_or(-1);
    return draw;
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

/// Pictures of one scene in the current context.
class OffscreenRun {
  public:
    OffscreenRun(const PreviewOptions& options, const OpenedScene& opened, const Context& context,
                 const Device& device)
        : options_(options),
          context_(context),
          opened_(opened),
          backend_{device.backend, device.context->info()},
          // A probe that follows a knob does not wait for foam to settle.
          scene_(make_scene(options.follow > 0.0 ? Pace::frames : Pace::stills)),
          renderer_(renderer_for(options, backend_.info, options.follow > 0.0)) {}

    /// Prints the probes, and draws the picture of --offscreen.
    void show_place() {
        print_probes(time_of(options_));
        draw_picture(time_of(options_));
    }

    /// Draws the scene with the values that a bridge has, and follows its changes.
    void follow_bridge() {
        LiveSea& sea = *scene_->performed();
        sea.go_to(time_of(options_));
        bool first = true;
        const auto changed = [&](double milliseconds) {
            shown_.reset();
            print_probes(sea.time(),
                         options_.follow > 0.0 ? format_text("%.1f,", milliseconds) : "");
            if (std::exchange(first, false)) draw_picture(sea.time());
        };
        run_with_bridge(*options_.bridge, options_.follow, sea, context_.console, changed);
    }

    void record(const std::string& stem) {
        const OutputPattern pattern(options_.record + "/" + stem + ".####.png");
        io::make_folder(options_.record);
        begin(options_.frames.size());
        for (const int frame : options_.frames) {
            draw_step(frame, options_, opened_->timeline().time_of(frame), pattern.file(frame));
        }
        context_.console.finish();
    }

    void draw_list(const std::vector<ListedPicture>& pictures) {
        begin(pictures.size());
        int number = 0;
        for (const auto& [path, options] : pictures) {
            draw_step(++number, options, time_of(options), path);
        }
        context_.console.finish();
    }

    /// Draws frames like a window into a canvas of the picture's size, and prints the time of their
    /// stages. Over a scene that stands still the eye flies ahead.
    void print_budget() {
        constexpr int kBefore = 10;  // frames that compile shaders and allocate memory
        FrameBudget warm, budget;
        FrameBudget* measured = &warm;
        const gl::AfterStage after_stage = [&](std::string_view stage) {
            measured->after_stage()(stage);
        };
        const auto scene = make_scene(Pace::frames, after_stage);
        const Timeline timeline = opened_->timeline();
        const auto eye = scene->first_eye(options_).value_or(options_.camera.eye);
        scene->go_to(time_of(options_));
        scene->show(eye);
        preview::Camera camera = options_.camera;
        place_on_ground(options_, scene->ground(), camera);
        preview::RendererOptions renderer_options = renderer_for(options_, backend_.info, true);
        renderer_options.after_stage = after_stage;
        renderer_options.live = !timeline.moves;
        preview::Renderer renderer(renderer_options);
        const preview::DrawOptions draw = draw_options(options_);
        const preview::Canvas canvas(draw.width, draw.height, GL_RGBA8,
                                     live_samples(options_, backend_.info));
        for (int frame = 0; frame < kBefore + options_.budget; ++frame) {
            measured = frame < kBefore ? &warm : &budget;
            measured->begin();
            scene->go_to(time_of(options_) + frame / timeline.frame_rate);
            scene->show(eye);
            after_stage("state");
            if (!timeline.moves) fly(camera);
            canvas.bind();
            scene->draw(renderer, camera, options_.look, draw);
            measured->end_frame();
        }
        context_.console.data(budget.table());
        if (!timeline.moves) context_.console.note(mesh_line(renderer.land_statistics()));
    }

  private:
    std::unique_ptr<Scene> make_scene(Pace pace, const gl::AfterStage& after_stage = {}) {
        return row_of(*opened_).show(*opened_, {.preview = options_,
                                                .backend = backend_,
                                                .threads = context_.options.threads,
                                                .pace = pace,
                                                .foam_progress = foam_progress_on(context_.console),
                                                .after_stage = after_stage});
    }
    double time_of(const PreviewOptions& options) const {
        const Timeline timeline = opened_->timeline();
        if (options.frame) return timeline.time_of(*options.frame);
        return options.time.value_or(timeline.start);
    }
    void print_probes(double time, const std::string& before = "") {
        for (const auto& place : options_.probes) {
            show(options_, time);
            context_.console.data(before + scene_->probe_line(renderer_, options_, place));
            warn_of_left_out();
        }
    }
    void draw_picture(double time) {
        if (options_.offscreen.empty()) return;
        draw(options_, time, options_.offscreen);
        context_.console.data(options_.offscreen + "\n");
    }
    /// Computes the scene of a picture; pictures of one time and of one first eye share it.
    void show(const PreviewOptions& options, double time) {
        const auto eye = scene_->first_eye(options).value_or(std::array<double, 3>{});
        const auto shown = std::pair(time, eye);
        scene_->go_to(time);
        if (shown_ == shown) return;
        scene_->show(eye);
        shown_ = shown;
    }
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
            scene_->go_to(time);
            const StagePicture stage =
                laid_out(scene_->stage(options.view, options.cascade.value_or(0)), width, height);
            const InterruptWatch::Hold whole = context_.interrupts.hold();
            return io::write_png(path, stage.width, stage.height, stage.rgb);
        }
        show(options, time);
        preview::Camera camera = options.camera;
        const std::string warning = place_on_ground(options, scene_->ground(), camera);
        if (!warning.empty()) context_.console.warning(warning);
        const InterruptWatch::Hold whole = context_.interrupts.hold();
        write_picture(path, renderer_, *scene_, camera, options.look, draw_options(options),
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
    const OpenedScene& opened_;
    ChosenBackend backend_;
    std::unique_ptr<Scene> scene_;
    preview::Renderer renderer_;
    std::optional<std::pair<double, std::array<double, 3>>> shown_;  // time and eye of the scene
    bool warned_ = false;
};

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
                         std::string(scene->kind()) + " by " + std::string(device.backend.name));
    OffscreenRun run(options, scene, context, device);
    if (options.bridge) return run.follow_bridge();
    run.show_place();
    if (!options.record.empty()) run.record(stem_of(source));
    if (!pictures.empty()) run.draw_list(pictures);
    if (options.budget > 0) run.print_budget();
}

}  // namespace ocean::app
