// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "terrain_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "command.hpp"
#include "land_camera.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/preview/probe.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"
#include "preview_options.hpp"
#include "subject_argument.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kTerrainStages[] = {"noise", "transform", "filter", "spectrum"};

/// Returns the first point of the ground that a line of sight through a place of the picture meets,
/// within a hundred tiles; nothing if it meets none.
std::optional<WorldPoint> pick_ground(const preview::DrawnLand& land, const preview::Camera& camera,
                                      const std::array<double, 2>& place, double aspect) {
    constexpr double kFarthest = 200e3;  // [m]
    constexpr int kHalvings = 30;
    const std::array<double, 3> sight = camera.line_of_sight(place[0], place[1], aspect);
    const auto clearance = [&](double distance) {
        const double x = camera.eye[0] + distance * sight[0];
        const double y = camera.eye[1] + distance * sight[1];
        return camera.eye[2] + distance * sight[2] - land.surface_at(x, y);
    };
    const double texel = preview::texel_of(land);
    double before = 0.0;
    for (double distance = 0.1 * texel; distance < kFarthest;) {
        const double free = clearance(distance);
        if (free <= 0.0) {
            double behind = distance;
            for (int i = 0; i < kHalvings; ++i) {
                const double middle = 0.5 * (before + behind);
                (clearance(middle) > 0.0 ? before : behind) = middle;
            }
            return WorldPoint{camera.eye[0] + behind * sight[0], camera.eye[1] + behind * sight[1]};
        }
        if (sight[2] >= 0.0 && camera.eye[2] + distance * sight[2] > land.heights[1]) break;
        before = distance;
        distance += std::max({0.25 * texel, 0.3 * free, 1e-3 * distance});
    }
    return std::nullopt;
}

}  // namespace

const SceneRow kTerrainScene = {
    .kind = kTerrainKind,
    .is_named = [](const std::string& source) { return kind_of_source(source) == kTerrainKind; },
    .open = [](const SubjectArgument& argument) -> OpenedScene {
        return make_subject(open_terrain(argument));
    },
    .show = [](const Subject& subject, const SceneOptions& options) -> std::unique_ptr<Scene> {
        return std::make_unique<TerrainScene>(*find_terrain(subject), options);
    },
    .views = [] { return preview::view_names(preview::SceneKind::land); },
    .stages = kTerrainStages,
    .presets = terrain_presets};

TerrainScene::TerrainScene(const TerrainModel& model, const SceneOptions& options)
    : options_(options),
      backend_(fitting_backend(model)),
      terrain_(std::make_unique<Terrain>(model, terrain_options(backend_))) {
    if (options_.pace == Pace::window) show();  // throws before the scene takes another's place
}

const Backend& TerrainScene::fitting_backend(const TerrainModel& model) const {
    const auto& [chosen, info, fell_back] = options_.backend;
    return options_.backend.fitting(app::why_not(chosen, model, info));
}

void TerrainScene::show(const std::array<double, 3>&) {
    const int resolution = land_map_for(options_.preview, terrain_->model(), options_.backend.info,
                                        options_.pace != Pace::stills);
    shown_ = maps_.show(*terrain_, resolution);
}

void TerrainScene::set(const std::string& name, const std::string& value) {
    TerrainModel changed = terrain_->model();
    set_parameter(changed, name, value);
    resolve_files(changed, "");
    change(std::move(changed));
}

void TerrainScene::open(const OpenedScene& opened) {
    change(*find_terrain(*opened));
}

OpenedScene TerrainScene::opened() const {
    return make_subject(terrain_->model());
}

void TerrainScene::change(TerrainModel model) {
    validate(model);
    const Backend& backend = fitting_backend(model);
    if (!(backend == backend_)) {
        terrain_ = std::make_unique<Terrain>(*terrain_, terrain_options(backend));
        backend_ = backend;
    }
    terrain_->set_model(std::move(model));
}

CameraGround TerrainScene::ground() {
    const Domain& domain = shown_.function->domain();
    return {.height = [land = shown_](double x, double y) { return land.surface_at(x, y); },
            // A part of the eye's height, or of the finest cell of the mesh where that is wide.
            .clearance = std::min(0.3, 0.2 * preview::texel_of(shown_)),
            .is_solid = true,
            .rise = kEyeHeight + 0.25 * shown_.rms,
            .middle = middle_of(domain),
            .outlook = domain.wraps ? std::nullopt : std::optional(domain),
            .water_level = shown_.water_level};
}

std::vector<std::string> TerrainScene::warnings() {
    const std::shared_ptr<const LandFunction> now = terrain_->function();
    const bool moves = std::exchange(seen_, now) != now;
    if (now == warned_) return warnings_;
    warnings_.clear();
    if (moves) return warnings_;  // statistics take longer than a frame of a drag
    warnings_ = terrain_->state().warnings;
    warned_ = now;
    return warnings_;
}

std::string TerrainScene::why_not(const Backend& backend) const {
    return app::why_not(backend, terrain_->model(), options_.backend.info);
}

StagePicture TerrainScene::stage(const std::string& view, int) {
    constexpr int kMaxResolution = 2048;  // a few seconds
    const int resolution = terrain_->model().resolution;
    if (options_.pace == Pace::window && resolution > kMaxResolution) {
        refuse("view " + view + ": a window shows stages of at most " +
               std::to_string(kMaxResolution) + " samples a side; resolution is " +
               std::to_string(resolution) + "; --offscreen shows any");
    }
    if (!stages_of_ || !(terrain_->modes().revision == stages_of_)) {
        stages_ = terrain_stages(*terrain_);
        stages_of_ = terrain_->modes().revision;
        stage_view_.clear();
    }
    if (std::exchange(stage_view_, view) != view) stage_ = make_stage_picture(stages_, view);
    return stage_;
}

std::string TerrainScene::probe_line(preview::Renderer& renderer, const PreviewOptions& options,
                                     const std::array<double, 2>& place) {
    const WorldPoint point{place[0], place[1]};
    QuerySample sample{};
    terrain_->query({&point, 1}, {&sample, 1}, {.exact = true});
    preview::Camera camera = options.camera;
    place_on_ground(options, ground(), camera);
    const auto found = preview::probe(renderer, shown_, camera, place);
    if (!found) return probe_text(place, {sample.height});
    return probe_text(place,
                      {sample.height, found->mesh_height, found->map_height, found->shown_slope});
}

std::string TerrainScene::under_mouse(preview::Renderer&, const preview::Camera& camera,
                                      const std::array<double, 2>& place, double aspect, int) {
    const auto point = pick_ground(shown_, camera, place, aspect);
    if (!point) return "";
    QuerySample sample{};
    // The sum of all waves of a larger grid takes longer than a frame.
    constexpr int kMaxExact = 1024;
    terrain_->query({&*point, 1}, {&sample, 1},
                    {.exact = terrain_->model().resolution <= kMaxExact});
    const double slope = std::acos(std::clamp(sample.normal[2], -1.0, 1.0)) * 360.0 / kTwoPi;
    return format_text("x %.2f  y %.2f  height %.2f m\nslope %.1f deg  normal %.2f %.2f %.2f",
                       point->x, point->y, sample.height, slope, sample.normal[0], sample.normal[1],
                       sample.normal[2]);
}

}  // namespace ocean::app
