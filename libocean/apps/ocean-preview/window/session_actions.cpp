// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The actions of a session: commands of keys and gamepad, and the requests of the panel and of a
// bridge.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "console.hpp"
#include "ocean/internal/grid.hpp"
#include "panel/changes.hpp"
#include "scene_argument.hpp"
#include "window/session.hpp"
#include "workload.hpp"

namespace ocean::app {

void Session::carry_out(WindowCommand command) {
    switch (command) {
        case WindowCommand::close:
            return glfwSetWindowShouldClose(window_, GLFW_TRUE);
        case WindowCommand::pause:
        case WindowCommand::record:
        case WindowCommand::drive:
        case WindowCommand::place_crest:
            return carry_out_on_sea(command);
        case WindowCommand::toggle_panel:
            state_.shown = !state_.shown;
            return;
        case WindowCommand::toggle_wireframe:
            state_.wireframe = !state_.wireframe;
            return;
        case WindowCommand::toggle_probe:
            state_.probing = !state_.probing;
            return;
        case WindowCommand::next_view:
            return next_view();
        case WindowCommand::next_camera:
            camera_.mode = static_cast<CameraMode>((static_cast<int>(camera_.mode) + 1) %
                                                   camera_modes(scene_->ground()));
            return;
        case WindowCommand::reset_camera:
            return reset_camera();
        case WindowCommand::undo:
            guarded([&] { undo(scene_, state_); });
            return;
        case WindowCommand::reload:
            return reload();
        case WindowCommand::open:
            return files_.ask(FilePurpose::open);
        case WindowCommand::save_as:
            return files_.ask(FilePurpose::save);
        case WindowCommand::save_png:
            picture_requested_ = ".png";
            return;
        case WindowCommand::save_exr:
            picture_requested_ = ".exr";
            return;
    }
}

void Session::carry_out_on_sea(WindowCommand command) {
    LiveSea* const sea = scene_->performed();
    if (sea == nullptr) {
        state_.message =
            "a " + std::string(fitted_->kind) + " does not move: it has no clock and no recording";
    } else if (command == WindowCommand::pause) {
        sea->paused = !sea->paused;
    } else if (command == WindowCommand::drive) {
        guarded([&] { drive(*sea, sea->sea().parameters.hulls.empty()); });
    } else if (command == WindowCommand::place_crest) {
        guarded([&] { place_crest(*sea); });
    } else {
        toggle_recording(*sea, state_);
    }
}

void Session::drive(LiveSea& sea, bool new_hull) {
    if (sea.drive() != nullptr) return drive_hull(sea, state_, 0);
    if (!new_hull) return drive_hull(sea, state_, state_.hull + 1);
    constexpr double kAhead = 60.0;  // of the camera [m]
    const preview::Camera& camera = camera_.camera();
    const double heading = camera.heading * kDegree;
    drive_new_hull(
        sea, state_,
        {camera.eye[0] + kAhead * std::cos(heading), camera.eye[1] + kAhead * std::sin(heading)},
        camera.heading);
    state_.hull = sea.driven_hull();
}

void Session::place_crest(LiveSea& sea) {
    const auto place = scene_->place_under(camera_.camera(), in_window(*input_.clicked_with_ctrl),
                                           window_aspect());
    if (place) add_crest(sea, state_, *place);
}

void Session::follow_hull() {
    const LiveSea* const sea = scene_->performed();
    const HullDrive* const hull = sea != nullptr ? sea->drive() : nullptr;
    const auto before = std::exchange(hull_place_, std::nullopt);
    if (hull == nullptr) return;
    const HullDrive::Pose now = hull->pose(sea->time());
    hull_place_ = {{now.x, now.y}};
    if (!before || !state_.follows_hull) return;
    camera_.camera().eye[0] += now.x - (*before)[0];
    camera_.camera().eye[1] += now.y - (*before)[1];
}

void Session::next_view() {
    const std::vector<std::string> views = all_view_names(*fitted_);
    const auto at = std::ranges::find(views, state_.view) - views.begin();
    state_.view = views[static_cast<std::size_t>(at + 1) % views.size()];
}

void Session::run_requests() {
    const PanelRequests& requests = state_.requests;
    if (requests.touched) frames_to_draw_ = kFramesToSettle;
    if (requests.reset_camera) reset_camera();
    if (requests.record) carry_out_on_sea(WindowCommand::record);
    if (requests.drive) carry_out_on_sea(WindowCommand::drive);
    if (requests.add_hull) guarded([&] { drive(*scene_->performed(), true); });
    if (requests.reload) reload();
    if (requests.bridge == PanelRequests::Bridge::start) guarded([&] { serve(); });
    if (requests.bridge == PanelRequests::Bridge::stop) bridge_.leave();
    if (requests.backend) choose_backend(*requests.backend);
    if (requests.save_scene) save_scene();
    if (files_.run(requests)) frames_to_draw_ = kFramesToSettle;
    if (!requests.save_picture.empty()) save_picture(requests.save_picture);
    if (!picture_requested_.empty()) save_picture(std::exchange(picture_requested_, ""));
}

void Session::choose_backend(const std::string& name) {
    guarded([&] {
        scene_.choose_backend(name);
        context_.console.note("the " + std::string(fitted_->kind) + " by " +
                              std::string(scene_->backend().name));
    });
}

void Session::serve() {
    const LiveSea* const sea = scene_->performed();
    if (sea != nullptr) context_.console.note("a bridge at " + bridge_.serve(sea->sea()));
}

/// Records as the bridge requests; a recording is saved when it ends, under the name of its take.
void Session::record(bool on, const std::string& name) {
    LiveSea* const sea = scene_->performed();
    if (sea == nullptr || on == sea->recording()) return;
    toggle_recording(*sea, state_);
    if (!on) save_scene(name.substr(0, name.find('.')));
    frames_to_draw_ = kFramesToSettle;
}

void Session::save_scene(const std::string& requested) {
    write([&] { return saved_.save(*scene_->opened(), requested); });
}

void Session::save_picture(const std::string& ending) {
    write([&] { return viewport_.save(saved_.stem(), ending, *scene_, camera_.camera(), state_); });
}

/// Reads the file of the scene again; the shown scene stays if the file is missing or bad.
void Session::reload() {
    guarded([&] {
        open_with_undo(scene_, state_, open_scene(state_.source));
        saved_.set_read(*scene_->opened());
        state_.message = "opened: " + state_.source.source;
    });
    frames_to_draw_ = kFramesToSettle;
}

}  // namespace ocean::app
