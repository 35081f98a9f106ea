// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "live_scene.hpp"

#include <algorithm>
#include <utility>

#include "land_camera.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

constexpr double kBoat = 2.5;  // [m] along each side

CameraGround ground_of(LiveSea& sea) {
    const auto height = [&sea](double x, double y) {
        const WorldPoint place{x, y};
        QuerySample sample{};
        sea.ocean().query(sea.time(), {&place, 1}, {&sample, 1}, {.foam = false});
        return sample.height;
    };
    const auto boat = [&sea](double x, double y, double heading) {
        const FloatBody body{x, y, heading, kBoat, kBoat};
        FloatPose pose{};
        sea.ocean().float_poses(sea.time(), {&body, 1}, {&pose, 1});
        return pose.position[2];
    };
    return {.height = height, .boat = boat};
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
            .clearance = lowest_eye(*coast),
            .is_solid = true};
}

CameraGround ground_of(const preview::DrawnLand& land) {
    return {.height = [land](double x, double y) { return land.surface_at(x, y); },
            .boat = {},
            .clearance = lowest_eye(land),
            .is_solid = true};
}

}  // namespace

LiveScene::LiveScene(const OpenedScene& scene, LiveSceneOptions options)
    : options_(std::move(options)),
      backend_(preview_backend(options_.preview.backend).value_or(best_backend(options_.info))) {
    open(scene);
}

preview::SceneKind LiveScene::kind() const {
    return sea_ ? preview::SceneKind::sea : preview::SceneKind::land;
}

void LiveScene::show(const std::array<double, 3>& eye) {
    if (sea_) {
        shown_ = sea_->show(eye);
    } else {
        shown_ = land_->show();
    }
}

void LiveScene::advance(double seconds) {
    if (sea_) sea_->advance(seconds);
}

bool LiveScene::is_still() const {
    return !sea_ || (sea_->paused && !sea_->fading() && !sea_->coast_in_work());
}

preview::Pending LiveScene::pending() const {
    return sea_ ? sea_->pending() : preview::Pending::nothing;
}

CameraGround LiveScene::ground() {
    const auto* const shown = std::get_if<preview::DrawnSea>(&shown_);
    if (shown != nullptr && shown->coast) return ground_of(shown->coast);
    if (sea_) return ground_of(*sea_);
    return ground_of(std::get<preview::DrawnLand>(shown_));
}

void LiveScene::set(const std::string& name, const std::string& value) {
    if (sea_) {
        sea_->set(name, value);
    } else {
        land_->set(name, value);
    }
}

void LiveScene::open(const OpenedScene& scene) {
    if (const auto* const sea = std::get_if<Sea>(&scene)) {
        if (sea_) return sea_->open(*sea);
        sea_ = make_sea(*sea);
        sea_->paused = paused_;
        land_.reset();
        shown_ = preview::DrawnSea{};
    } else {
        const TerrainModel& terrain = std::get<TerrainModel>(scene);
        if (land_) return land_->open(terrain);
        auto made = make_land(terrain);
        shown_ = made->show();  // the textures of the sea go with it
        land_ = std::move(made);
        if (sea_) paused_ = sea_->paused;
        sea_.reset();
    }
}

OpenedScene LiveScene::opened() const {
    if (sea_) return sea_->sea();
    return land_->model();
}

const Backend& LiveScene::backend() const {
    return sea_ ? sea_->computing().backend : land_->computing().backend;
}

std::string LiveScene::why_not(const Backend& backend) const {
    return sea_ ? app::why_not(backend, sea_->sea(), options_.info)
                : app::why_not(backend, land_->model(), options_.info);
}

void LiveScene::choose_backend(const std::string& name) {
    backend_ = preview_backend(name).value_or(backend_);
    if (sea_) {
        sea_->compute_anew();
    } else {
        land_->compute_anew();
    }
}

/// Returns the chosen backend, or the best other one if that cannot compute the model, for example
/// because a grid has grown too large for it.
template <typename Model>
const Backend& LiveScene::fitting_backend(const Model& model) {
    if (const std::string reason = app::why_not(backend_, model, options_.info); !reason.empty()) {
        if (options_.fell_back) options_.fell_back(std::string(backend_.name) + " " + reason);
        backend_ = best_backend(options_.info);
    }
    return backend_;
}

std::unique_ptr<LiveSea> LiveScene::make_sea(const Sea& sea) {
    auto made = std::make_unique<LiveSea>(
        sea, LiveSeaOptions{.threads = options_.threads, .computing = [this](const Sea& of) {
                                return computing_for(fitting_backend(of), options_.preview, of,
                                                     options_.info);
                            }});
    if (options_.on_sea) options_.on_sea(*made);
    return made;
}

std::unique_ptr<LiveLand> LiveScene::make_land(const TerrainModel& terrain) {
    return std::make_unique<LiveLand>(terrain, options_.threads, [this](const TerrainModel& of) {
        constexpr bool kLive = true;
        return LandComputing{fitting_backend(of),
                             land_map_for(options_.preview, of, options_.info, kLive)};
    });
}

std::string text_of(const OpenedScene& scene) {
    if (const auto* const sea = std::get_if<Sea>(&scene)) return write_sea(*sea);
    return write_terrain(std::get<TerrainModel>(scene));
}

}  // namespace ocean::app
