// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "offscreen_run.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "bridge_run.hpp"
#include "console.hpp"
#include "frame_budget.hpp"
#include "interrupt.hpp"
#include "ocean/bake/frames.hpp"
#include "ocean/gl/context.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/io/png.hpp"
#include "ocean/ocean.hpp"
#include "ocean/preview/canvas.hpp"
#include "ocean/preview/probe.hpp"
#include "ocean/text.hpp"
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

double time_of(const PreviewOptions& options, const Sea& sea) {
    if (options.frame) return sea.time_of(*options.frame);
    return options.time.value_or(sea.parameters.time.start);
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

std::string probe_line(preview::Renderer& renderer, const preview::ShownSea& shown,
                       const PreviewOptions& options, const std::array<double, 2>& place) {
    const auto found =
        preview::probe(renderer, shown, options.camera, place, options.cascade.value_or(-1));
    std::string line = shortest_text(place[0]) + "," + shortest_text(place[1]);
    if (found) {
        for (const double value : {found->mesh_height, found->map_height, found->shown_slope,
                                   found->handed_on_slope, found->cover}) {
            line += "," + shortest_text(static_cast<float>(value));
        }
    }
    return line + "\n";
}

/// Pictures of one sea in the current context.
class OffscreenRun {
  public:
    OffscreenRun(const PreviewOptions& options, const Sea& sea, const Context& context,
                 const Device& device)
        : options_(options),
          context_(context),
          sea_(sea, {.threads = context.options.threads,
                     .backend = device.backend,
                     .foam_progress = foam_progress_on(context.console)}),
          maps_(settled(computing_for(device.backend, options, sea, device.context->info()).maps)),
          renderer_(renderer_for(options, device.context->info())) {}

    void print_probes(double time) {
        if (options_.probes.empty()) return;
        const preview::ShownSea& shown = shown_at(time);
        for (const auto& place : options_.probes) {
            context_.console.data(probe_line(renderer_, shown, options_, place));
            warn_of_left_out();
        }
    }

    void draw(const PreviewOptions& options, double time, const std::string& path) {
        if (is_stage_picture(options.view)) {
            const auto cascade = static_cast<std::size_t>(std::max(0, options.cascade.value_or(0)));
            const auto [width, height] = options.size;
            const StagePicture stage = laid_out(
                make_stage_picture(stages_, sea_, time, cascade, options.view), width, height);
            const InterruptWatch::Hold whole = context_.interrupts.hold();
            return io::write_png(path, stage.width, stage.height, stage.rgb);
        }
        const preview::ShownSea& shown = shown_at(time);
        const InterruptWatch::Hold whole = context_.interrupts.hold();
        write_picture(path, renderer_, shown, options.camera, options.look, draw_options(options),
                      options.samples.value_or(kSamples));
        warn_of_left_out();
    }

    void record(const std::string& stem) {
        const OutputPattern pattern(options_.record + "/" + stem + ".####.png");
        io::make_folder(options_.record);
        begin(options_.frames.size());
        for (const int frame : options_.frames) {
            draw_step(frame, options_, sea_.sea().time_of(frame), pattern.file(frame));
        }
        context_.console.finish();
    }

    void draw_list(const std::vector<ListedPicture>& pictures) {
        begin(pictures.size());
        int number = 0;
        for (const auto& [path, options] : pictures) {
            draw_step(++number, options, time_of(options, sea_.sea()), path);
        }
        context_.console.finish();
    }

  private:
    /// Probes and pictures of one moment share its maps.
    const preview::ShownSea& shown_at(double time) {
        if (!shown_ || shown_->time != time) {
            shown_.reset();
            shown_ = maps_.show(sea_, time);
        }
        return *shown_;
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
    /// Warns once of the parts of the last picture that the driver has too few texture units for.
    void warn_of_left_out() {
        const std::string words = preview::text(renderer_.left_out());
        if (words.empty() || std::exchange(warned_, true)) return;
        context_.console.warning(words);
    }
    static preview::SeaMapsOptions settled(preview::SeaMapsOptions maps) {
        maps.foam_start = FoamStart::settled;
        maps.live = false;
        return maps;
    }

    const PreviewOptions& options_;
    const Context& context_;
    Ocean sea_;
    preview::SeaMaps maps_;
    preview::Renderer renderer_;
    gl::StageMaker stages_;
    std::optional<preview::ShownSea> shown_;  // what maps_ holds
    bool warned_ = false;
};

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
    preview::Renderer renderer(renderer_for(options, info));
    bool first = true;
    const auto show = [&](double milliseconds) {
        const preview::ShownSea shown = live.show();
        for (const auto& place : options.probes) {
            const std::string when =
                options.follow > 0.0 ? format_text("%.1f,", milliseconds) : std::string();
            context.console.data(when + probe_line(renderer, shown, options, place));
        }
        if (!std::exchange(first, false) || options.offscreen.empty()) return;
        const InterruptWatch::Hold whole = context.interrupts.hold();
        write_picture(options.offscreen, renderer, shown, options.camera, options.look,
                      draw_options(options), options.samples.value_or(kSamples));
        context.console.data(options.offscreen + "\n");
    };
    run_with_bridge(*options.bridge, options.follow, live, context.console, show);
}

/// Draws frames like a window, at the sea's own rate, into a canvas of the picture's size, and
/// prints the time of their stages.
void print_budget(const PreviewOptions& options, const Sea& sea, const Context& context,
                  const Device& device, double start) {
    constexpr int kBefore = 10;  // frames that compile shaders and allocate memory
    FrameBudget warm, budget;
    FrameBudget* measured = &warm;
    const gl::AfterStage after_stage = [&](std::string_view stage) {
        measured->after_stage()(stage);
    };
    const Computing computing = computing_for(device.backend, options, sea, device.context->info());
    Ocean live(sea, {.threads = context.options.threads,
                     .backend = computing.backend,
                     .foam_start = FoamStart::empty});
    preview::SeaMaps maps(computing.maps, after_stage);
    preview::RendererOptions renderer_options = renderer_for(options, device.context->info());
    renderer_options.after_stage = after_stage;
    preview::Renderer renderer(renderer_options);
    const preview::DrawOptions draw = draw_options(options);
    const preview::Canvas canvas(draw.width, draw.height, GL_RGBA8,
                                 live_samples(options, device.context->info()));
    for (int frame = 0; frame < kBefore + options.budget; ++frame) {
        measured = frame < kBefore ? &warm : &budget;
        measured->begin();
        const preview::ShownSea shown = maps.show(live, start + frame / sea.parameters.time.fps);
        after_stage("state");
        canvas.bind();
        renderer.draw(shown, options.camera, options.look, draw);
        measured->end_frame();
    }
    context.console.data(budget.table());
}

}  // namespace

std::string stem_of(const std::string& source) {
    const std::size_t colon = source.rfind(':');
    const std::string name = colon == std::string::npos ? source : source.substr(colon + 1);
    const std::string stem = utf8_path(name).stem().string();
    return stem.empty() || stem == "-" ? "sea" : stem;
}

void run_offscreen(const PreviewOptions& options, const std::vector<ListedPicture>& pictures,
                   const Sea& sea, const std::string& source, const Context& context) {
    if (!options.offscreen.empty()) require_picture_folder(options.offscreen);
    for (const ListedPicture& picture : pictures) require_picture_folder(picture.path);
    const Device device = open_device(options.backend);
    const gl::HeadlessContext::Current current(*device.context);
    context.console.note("drawn by " + device.context->info().text() + "; the sea by " +
                         std::string(device.backend.name));
    const double time = time_of(options, sea);
    if (options.bridge) return draw_with_bridge(options, sea, context, device, time);
    OffscreenRun run(options, sea, context, device);
    run.print_probes(time);
    if (!options.offscreen.empty()) {
        run.draw(options, time, options.offscreen);
        context.console.data(options.offscreen + "\n");
    }
    if (!options.record.empty()) run.record(stem_of(source));
    if (!pictures.empty()) run.draw_list(pictures);
    if (options.budget > 0) print_budget(options, sea, context, device, time);
}

}  // namespace ocean::app
