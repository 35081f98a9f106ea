// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "sea_scene.hpp"

#include <algorithm>
#include <utility>

#include "land_camera.hpp"
#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/preview/probe.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/sea_state.hpp"
#include "preview_options.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

constexpr double kBoat = 2.5;  // [m] along each side
/// Samples along a side of a coast's windows in pictures that take their time.
constexpr int kStillCoast = 384;

LiveSeaOptions live_options(const SceneOptions& options) {
    const bool is_still = options.pace == Pace::stills;
    const auto computing = [options, is_still](const Sea& of) {
        const gl::ContextInfo& info = options.backend.info;
        const Backend& backend = options.backend.fitting(why_not(options.backend.chosen, of, info));
        Computing computing = computing_for(backend, options.preview, of, info);
        if (is_still) {
            computing.maps.live = false;
            computing.maps.foam_start = computing.maps.coast.foam_start = FoamStart::settled;
            computing.maps.coast.samples = kStillCoast;
        }
        return computing;
    };
    return {.threads = options.threads,
            .computing = computing,
            .foam_start = is_still ? FoamStart::settled : FoamStart::empty,
            .foam_progress = options.foam_progress,
            .after_stage = options.after_stage,
            .waits_for_coast = options.pace != Pace::window};
}

/// By the shown windows: a query of the coast would take longer than its picture.
CameraGround ground_of(const std::shared_ptr<const preview::DrawnCoast>& coast) {
    const auto boat = [coast](double x, double y, double) {
        double sum = 0.0;
        for (const double east : {-0.5, 0.0, 0.5}) {
            for (const double north : {-0.5, 0.0, 0.5}) {
                sum += coast->surface_at(x + kBoat * east, y + kBoat * north);
            }
        }
        return sum / 9.0;
    };
    return {.height = [coast](double x, double y) { return coast->surface_at(x, y); },
            .boat = boat,
            .is_solid = true,
            .middle = middle_of(coast->bed->domain)};
}

constexpr std::string_view kSeaStages[] = {"h0", "spectrum", "butterfly"};

void require_cascade(const Subject& subject, const PreviewOptions& options) {
    const int cascades = sea_of(subject).parameters.grid.cascades;
    const int cascade = options.cascade.value_or(0);
    if (cascade >= 0 && cascade < cascades) return;
    throw Error(
        ErrorKind::invalid_value,
        "--cascade is " + std::to_string(cascade) + "; the sea has " +
            (cascades == 1 ? "one, 0"
                           : std::to_string(cascades) + ", 0 .. " + std::to_string(cascades - 1)));
}

}  // namespace

const SceneRow kSeaScene = {
    .kind = kSeaKind,
    .is_named = [](const std::string&) { return true; },
    .open = [](const SubjectArgument& argument) -> OpenedScene {
        return make_subject(open_sea(argument));
    },
    .show = [](const Subject& subject, const SceneOptions& options) -> std::unique_ptr<Scene> {
        return std::make_unique<SeaScene>(sea_of(subject), options);
    },
    .views = [] { return preview::view_names(preview::SceneKind::sea); },
    .stages = kSeaStages,
    .presets = presets,
    .includes =
        [](const Subject& subject) {  // a coast has land
            return sea_of(subject).parameters.water.bed ? kTerrainKind : "";
        },
    .require_fit = require_cascade,
    .warnings =
        [](const Subject& subject) {
            const Sea& sea = sea_of(subject);
            return full_development_warnings(sea.at(sea.parameters.time.start));
        }};

SeaScene::SeaScene(const Sea& sea, const SceneOptions& options)
    : options_(options), live_(sea, live_options(options)) {
    // Half as much again for its water.
    const bool is_slow = options.pace == Pace::window && options.backend.info.software;
    live_.near_detail = options.preview.detail && !is_slow;
}

CameraGround SeaScene::ground() {
    if (shown_.coast && shown_.coast->bed) return ground_of(shown_.coast);
    const auto height = [this](double x, double y) {
        const WorldPoint place{x, y};
        QuerySample sample{};
        live_.ocean().query(live_.time(), {&place, 1}, {&sample, 1}, {.foam = false});
        return sample.height;
    };
    const auto boat = [this](double x, double y, double heading) {
        const FloatBody body{x, y, heading, kBoat, kBoat};
        FloatPose pose{};
        live_.ocean().float_poses(live_.time(), {&body, 1}, {&pose, 1});
        return pose.position[2];
    };
    return {.height = height, .boat = boat};
}

std::vector<std::string> SeaScene::warnings() {
    return full_development_warnings(live_.now());
}

std::optional<std::array<double, 3>> SeaScene::first_eye(const PreviewOptions& options) const {
    const auto& bed = live_.sea().parameters.water.bed;
    if (!bed) return std::nullopt;
    std::array<double, 3> eye = options.camera.eye;
    if (options.eye_place == EyePlace::at) return eye;
    if (options.eye_place == EyePlace::not_given) {
        std::ranges::copy(*middle_of(bed->domain), eye.begin());
    }
    eye[2] = kEyeHeight;
    return eye;
}

std::string SeaScene::why_not(const Backend& backend) const {
    return app::why_not(backend, live_.sea(), options_.backend.info);
}

StagePicture SeaScene::stage(const std::string& view, int cascade) {
    return make_stage_picture(stages_, live_.ocean(), live_.time(),
                              static_cast<std::size_t>(std::max(0, cascade)), view);
}

int SeaScene::cascades() {
    return static_cast<int>(cascade_divisors(live_.ocean().parameters().grid).size());
}

std::string SeaScene::probe_line(preview::Renderer& renderer, const PreviewOptions& options,
                                 const std::array<double, 2>& place) {
    const auto found =
        preview::probe(renderer, shown_, options.camera, place, options.cascade.value_or(-1));
    if (!found) return probe_text(place, {});
    return probe_text(place, {found->mesh_height, found->map_height, found->shown_slope,
                              found->handed_on_slope, found->cover});
}

std::optional<SeaScene::SeenWater> SeaScene::water_under(const preview::Camera& camera,
                                                         const std::array<double, 2>& place,
                                                         double aspect) {
    if (!live_.can_query()) return std::nullopt;
    constexpr int kSteps = 3;
    SeenWater water{};
    for (int step = 0; step <= kSteps; ++step) {
        const auto met = camera.meet_level(place[0], place[1], aspect, water.sample.height);
        if (!met) return std::nullopt;
        water.place = {(*met)[0], (*met)[1]};
        if (step == kSteps) break;
        live_.ocean().query(live_.time(), {&water.place, 1}, {&water.sample, 1}, {.foam = false});
    }
    return water;
}

std::optional<std::array<double, 2>> SeaScene::place_under(const preview::Camera& camera,
                                                           const std::array<double, 2>& place,
                                                           double aspect) {
    const auto water = water_under(camera, place, aspect);
    if (!water) return std::nullopt;
    return {{water->place.x, water->place.y}};
}

std::string SeaScene::under_mouse(preview::Renderer& renderer, const preview::Camera& camera,
                                  const std::array<double, 2>& place, double aspect, int cascade) {
    const auto found = water_under(camera, place, aspect);
    if (!found) return "";
    const auto& [point, sample] = *found;
    const auto drawn = preview::probe(renderer, shown_, camera, {point.x, point.y}, cascade);
    return format_text("x %.2f  y %.2f  height %.2f m\nnormal %.2f %.2f %.2f\nfoam %.2f", point.x,
                       point.y, sample.height, sample.normal[0], sample.normal[1], sample.normal[2],
                       drawn ? drawn->cover : 0.0);
}

}  // namespace ocean::app
