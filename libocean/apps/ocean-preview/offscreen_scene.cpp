// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "offscreen_scene.hpp"

#include <algorithm>
#include <optional>

#include "console.hpp"
#include "land_camera.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/preview/probe.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "ocean/terrain.hpp"

namespace ocean::app {
namespace {

/// Returns "X,Y" and, if anything was drawn there, the numbers.
std::string line_of(const std::array<double, 2>& place, std::initializer_list<double> numbers) {
    std::string line = shortest_text(place[0]) + "," + shortest_text(place[1]);
    for (const double number : numbers) line += "," + shortest_text(static_cast<float>(number));
    return line + "\n";
}

/// Samples along a side of a coast's windows in pictures that take their time.
constexpr int kStillCoast = 384;

class OffscreenSea : public OffscreenScene {
  public:
    OffscreenSea(const Sea& sea, const PreviewOptions& options, const Backend& backend,
                 const gl::ContextInfo& info, const Context& context)
        : sea_(sea, {.threads = context.options.threads,
                     .backend = backend,
                     .foam_progress = foam_progress_on(context.console)}),
          maps_(settled(computing_for(backend, options, sea, info).maps)) {}

    double time_of(const PreviewOptions& options) const override {
        if (options.frame) return time_of_frame(*options.frame);
        return options.time.value_or(sea_.sea().parameters.time.start);
    }
    double time_of_frame(int frame) const override { return sea_.sea().time_of(frame); }

    const preview::DrawnScene& shown_at(const PreviewOptions& options, double time) override {
        const auto& bed = sea_.parameters().water.bed;
        const std::array<double, 3> eye = bed ? eye_on_coast(options, *bed) : eye_;
        if (!shown_ || sea_of(*shown_).time != time || eye != eye_) {
            shown_.reset();
            shown_ = maps_.show(sea_, time, eye);
            eye_ = eye;
        }
        return *shown_;
    }

    StagePicture stage(const PreviewOptions& options, double time) override {
        const auto cascade = static_cast<std::size_t>(std::max(0, options.cascade.value_or(0)));
        return make_stage_picture(stages_, sea_, time, cascade, options.view);
    }

    std::string probe_line(preview::Renderer& renderer, const PreviewOptions& options,
                           const std::array<double, 2>& place, double time) override {
        return sea_probe_line(renderer, sea_of(shown_at(options, time)), options, place);
    }

    preview::Camera camera_of(const PreviewOptions& options, std::string& warning) override {
        preview::Camera camera = options.camera;
        if (const auto coast = shown_ ? sea_of(*shown_).coast : nullptr) {
            warning = place_on_coast(options, *coast, camera);
        }
        return camera;
    }

  private:
    static const preview::DrawnSea& sea_of(const preview::DrawnScene& shown) {
        return std::get<preview::DrawnSea>(shown);
    }
    static preview::SeaMapsOptions settled(preview::SeaMapsOptions maps) {
        maps.foam_start = FoamStart::settled;
        maps.live = false;
        maps.coast.foam_start = FoamStart::settled;
        maps.coast.samples = kStillCoast;
        return maps;
    }

    Ocean sea_;
    preview::SeaMaps maps_;
    gl::StageMaker stages_;
    std::optional<preview::DrawnScene> shown_;  // what maps_ holds
    std::array<double, 3> eye_{};               // of the coast that it has
};

class OffscreenLand : public OffscreenScene {
  public:
    OffscreenLand(const TerrainModel& terrain, const PreviewOptions& options,
                  const Backend& backend, const gl::ContextInfo& info, const Context& context)
        : land_(terrain, {.threads = context.options.threads, .backend = backend}),
          resolution_(land_map_for(options, terrain, info, false)) {
        if (const std::string reason = why_not(backend, terrain, info); !reason.empty()) {
            throw Error(ErrorKind::invalid_value,
                        "backend " + std::string(backend.name) + ": " + reason);
        }
    }

    double time_of(const PreviewOptions&) const override { return 0.0; }
    double time_of_frame(int) const override { return 0.0; }

    const preview::DrawnScene& shown_at(const PreviewOptions&, double) override {
        if (!shown_) shown_ = maps_.show(land_, resolution_);
        return *shown_;
    }

    StagePicture stage(const PreviewOptions& options, double) override {
        if (!stages_) stages_ = terrain_stages(land_);
        return make_stage_picture(*stages_, options.view);
    }

    std::string probe_line(preview::Renderer& renderer, const PreviewOptions& options,
                           const std::array<double, 2>& place, double time) override {
        const WorldPoint point{place[0], place[1]};
        QuerySample sample{};
        land_.query({&point, 1}, {&sample, 1}, {.exact = true});
        const auto& shown = std::get<preview::DrawnLand>(shown_at(options, time));
        std::string warning;
        const auto found = preview::probe(renderer, shown, camera_of(options, warning), place);
        if (!found) return line_of(place, {sample.height});
        return line_of(place,
                       {sample.height, found->mesh_height, found->map_height, found->shown_slope});
    }

    preview::Camera camera_of(const PreviewOptions& options, std::string& warning) override {
        preview::Camera camera = options.camera;
        warning =
            place_on_land(options, std::get<preview::DrawnLand>(shown_at(options, 0.0)), camera);
        return camera;
    }

  private:
    Terrain land_;
    int resolution_;
    preview::LandMaps maps_;
    std::optional<preview::DrawnScene> shown_;
    std::optional<TerrainStages> stages_;
};

}  // namespace

std::string sea_probe_line(preview::Renderer& renderer, const preview::DrawnSea& shown,
                           const PreviewOptions& options, const std::array<double, 2>& place) {
    const auto found =
        preview::probe(renderer, shown, options.camera, place, options.cascade.value_or(-1));
    if (!found) return line_of(place, {});
    return line_of(place, {found->mesh_height, found->map_height, found->shown_slope,
                           found->handed_on_slope, found->cover});
}

std::unique_ptr<OffscreenScene> make_offscreen_scene(const OpenedScene& scene,
                                                     const PreviewOptions& options,
                                                     const Backend& backend,
                                                     const gl::ContextInfo& info,
                                                     const Context& context) {
    if (const auto* const terrain = std::get_if<TerrainModel>(&scene)) {
        return std::make_unique<OffscreenLand>(*terrain, options, backend, info, context);
    }
    return std::make_unique<OffscreenSea>(std::get<Sea>(scene), options, backend, info, context);
}

}  // namespace ocean::app
