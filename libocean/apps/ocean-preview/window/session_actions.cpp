// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The actions of a session: commands of keys and gamepad, and the requests of the panel and of a
// bridge.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "console.hpp"
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
    } else {
        toggle_recording(*sea, state_);
    }
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
