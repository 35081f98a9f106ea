// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/session.hpp"

#include <epoxy/gl.h>
//
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "land_camera.hpp"
#include "ocean/internal/text.hpp"
#include "offscreen_run.hpp"
#include "panel/changes.hpp"
#include "panel/panel.hpp"
#include "scene_argument.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace

Session::Session(const PreviewOptions& options, const OpenedScene& scene,
                 const SubjectArgument& source, const Context& context, GLFWwindow* window,
                 WindowInput& input, Gui& gui)
    : options_(options),
      context_(context),
      window_(window),
      input_(input),
      gui_(gui),
      info_(gl::context_info()),
      viewport_(options, info_),
      scene_(scene, scene_options(options)),
      first_(&scene_.row()),
      fitted_(first_),
      saved_(stem_of(source.source), scene),
      files_(source, scene_, state_, saved_, context.console),
      titled_(source.source),
      camera_(options.camera),
      bridge_(state_.bridge,
              {.record = [this](bool on, const std::string& name) { record(on, name); },
               .drive =
                   [this](std::size_t number) { drive_hull(*scene_->performed(), state_, number); },
               .logged =
                   [this](const std::string& line) { context_.console.note("bridge: " + line); }}) {
    begin();
}

LiveSceneOptions Session::scene_options(const PreviewOptions& options) {
    return {.preview = options,
            .info = info_,
            .threads = context_.options.threads,
            .on_sea =
                [this](LiveSea& sea) {
                    sea.after_set = [this](const std::string& name, const std::string& value) {
                        bridge_.send(name, value);
                    };
                    sea.after_open = [this, &sea] { bridge_.send_values(sea); };
                },
            .fell_back = [this](const std::string& reason) { state_.message = reason; }};
}

void Session::begin() {
    state_.bridge.host = options_.host;
    state_.bridge.is_own = !options_.bridge;
    if (options_.bridge) bridge_.join(*options_.bridge);
    if (options_.serve) serve();
    if (options_.time) scene_->go_to(*options_.time);
    if (options_.frame) scene_->go_to(scene_->opened()->timeline().time_of(*options_.frame));
    state_.look = options_.look;
    state_.view = options_.view;
    state_.cascade = options_.cascade.value_or(-1);
    state_.wireframe = options_.wireframe;
    state_.drawn_by = info_.renderer;
    if (info_.software) state_.drawn_by += "\na processor: fewer pixels, smaller maps";
    for (const Backend& backend : preview_backends()) {
        state_.backends.push_back({std::string(backend.name), "", 0.0});
    }
    reset_camera();
}

void Session::run() {
    auto before = Clock::now();
    while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
        wait_for_input();
        const double seconds = std::min(0.25, milliseconds_since(before) / 1000.0);
        before = Clock::now();
        if (!guarded([&] { scene_->advance(seconds); })) scene_->pause();
        follow_hull();
        if (step(seconds)) frames_to_draw_ = kFramesToSettle;
        if (LiveSea* const sea = scene_->performed(); sea != nullptr && bridge_.apply(*sea)) {
            frames_to_draw_ = kFramesToSettle;
        }
        if (!input_.dropped.empty()) files_.open(input_.dropped);
        if (files_.run({})) frames_to_draw_ = kFramesToSettle;
        show_title();
        follow_kind();
        if (frames_to_draw_ > 0 || !scene_->is_still()) draw();
        if (frames_to_draw_ > 0) --frames_to_draw_;
        if (!std::exchange(began_, true)) context_.console.note("the window is open");
        input_.forget();
    }
    // Never discard a recording or a driven track when the window closes.
    if (LiveSea* const sea = scene_->performed()) sea->stop_drive();
    if (saved_.lacks(*scene_->opened())) save_scene();
}

void Session::follow_kind() {
    if (&scene_.row() == std::exchange(fitted_, &scene_.row())) return;
    const std::vector<std::string> views = all_view_names(*fitted_);
    if (std::ranges::find(views, state_.view) == views.end()) state_.view = "shaded";
    if (static_cast<int>(camera_.mode) >= camera_modes(scene_->ground())) {
        camera_.mode = CameraMode::fly;
    }
    if (scene_->performed() == nullptr && bridge_.is_joined()) {
        bridge_.leave();
        context_.console.note("left the bridge: it is for a sea");
    }
    reset_camera();
    frames_to_draw_ = kFramesToSettle;
}

/// Puts the camera where it began, or at the default place of a scene of the other kind.
void Session::reset_camera() {
    guarded([&] {
        PreviewOptions start = first_ == fitted_ ? options_ : PreviewOptions();
        if (const auto eye = scene_->first_eye(start)) scene_->show(*eye);  // its ground
        const std::string warning = place_on_ground(start, scene_->ground(), start.camera);
        if (!warning.empty()) state_.message = warning;
        camera_.reset(start.camera);
    });
}

/// Blocks while the scene stands still and nothing happens. A gamepad, a bridge and textures that
/// another thread makes wake nobody up: they are polled.
void Session::wait_for_input() {
    const bool iconified = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0;
    bool still = scene_->is_still() && frames_to_draw_ == 0;
    const preview::Pending pending = std::max(viewport_.renderer().pending(), scene_->pending());
    if (still && pending == preview::Pending::ready) {
        frames_to_draw_ = 1;
        still = false;
    }
    note_rest(still && pending == preview::Pending::nothing);
    if (iconified || still) {
        const bool polls = (controls_.has_gamepad() && !iconified) || bridge_.is_joined() ||
                           pending == preview::Pending::in_work || files_.is_asking();
        glfwWaitEventsTimeout(polls ? 0.03 : 0.25);
    } else {
        glfwPollEvents();
    }
    if (input_.any) frames_to_draw_ = kFramesToSettle;
}

/// Notes for scripts that all input is shown and nothing moves until there is more.
void Session::note_rest(bool rests) {
    if (rests && !rests_) context_.console.note("at rest: " + input_.text(window_));
    rests_ = rests;
}

/// Carries out the input of a frame. Returns whether it changed anything.
bool Session::step(double seconds) {
    const double degrees_of_pixel = camera_.camera().field_of_view / std::max(1, viewport_.width());
    LiveSea* const sea = scene_->performed();
    HullDrive* const hull = sea != nullptr ? sea->drive() : nullptr;
    const ControlInput input =
        controls_.read(window_, input_, seconds, degrees_of_pixel, hull != nullptr);
    if (hull != nullptr) hull->steer(input.hull.faster, input.hull.left, seconds);
    for (const WindowCommand command : input.commands) carry_out(command);
    const bool acted = !input.commands.empty();
    const bool rides = camera_.mode == CameraMode::walk || camera_.mode == CameraMode::floating;
    if (input.moves_camera() || (rides && !scene_->is_still()) || acted) {
        guarded([&] { camera_.step(input.camera, seconds, scene_->ground()); });
    }
    return input.moves_camera() || acted;
}

void Session::draw() {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    if (width == 0 || height == 0) return;  // an icon
    viewport_.resize(width, height);
    if (const auto scale = gui_.fit_screen()) {
        context_.console.note(format_text("the panel has scale %g", *scale));
        frames_to_draw_ = kFramesToSettle;
    }
    draw_scene();
    draw_panels();
    const double milliseconds = milliseconds_since(std::exchange(drawn_, Clock::now()));
    if (const LiveSea* const sea = scene_->performed()) {
        bridge_.send_clock(*sea, 1000.0 / std::max(milliseconds, 0.1));
    }
}

void Session::draw_scene() {
    if (!guarded([&] { scene_timer_.measure([&] { scene_->show(camera_.camera().eye); }); })) {
        scene_->pause();
    }
    // Water rises, and a change may have raised the ground above the eye.
    guarded([&] {
        if (const CameraGround ground = scene_->ground(); ground.is_solid) {
            camera_.stay_above(ground);
        }
    });
    state_.cascades = scene_->cascades();
    if (state_.cascade >= state_.cascades) state_.cascade = -1;  // of another scene
    state_.times.scene = scene_timer_.milliseconds();
    list_backends();
    draw_timer_.measure([&] {
        const auto draw_view = [&] { viewport_.draw(*scene_, camera_.camera(), state_); };
        if (!is_stage_picture(state_.view)) return draw_view();
        if (!guarded(draw_view)) state_.view = "shaded";
    });
    state_.times.draw = draw_timer_.milliseconds();
    state_.left_out = preview::text(viewport_.renderer().left_out());
    state_.land_mesh = viewport_.renderer().land_statistics();
}

void Session::draw_panels() {
    const auto start = Clock::now();
    guarded([&] { look_under_mouse(); });
    // Frames may be slow, and the user is not: the panel sees each event with the mouse where it
    // was.
    for (const InputEvent& event : std::exchange(input_.events, {})) {
        Gui::begin(window_, &event);
        lay_out_panel();
        ImGui::EndFrame();
        run_requests();
    }
    Gui::begin(window_);
    lay_out_panel();
    Gui::end();
    state_.times.panel = milliseconds_since(start);
    glfwSwapBuffers(window_);
    run_requests();
}

void Session::lay_out_panel() {
    state_.requests = {};
    viewport_.show_stage(state_);
    bridge_.update_rows();
    follow_kind();
    guarded([&] { draw_panel(scene_, camera_, state_); });
}

std::array<double, 2> Session::in_window(const std::array<double, 2>& at) const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    return {at[0] / width, at[1] / height};
}

double Session::window_aspect() const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    return static_cast<double>(width) / height;
}

void Session::look_under_mouse() {
    state_.under_mouse.clear();
    if (!state_.probing || ImGui::GetIO().WantCaptureMouse) return;
    state_.under_mouse =
        scene_->under_mouse(viewport_.renderer(), camera_.camera(), in_window(controls_.mouse()),
                            window_aspect(), state_.cascade);
    viewport_.bind_window();
}

/// Lists the backends, with the time of a frame once a chosen one has compiled its shaders.
void Session::list_backends() {
    const std::string now(scene_->backend().name);
    frames_of_backend_ = now == state_.backend ? frames_of_backend_ + 1 : 0;
    state_.backend = now;
    const LiveSea* const sea = scene_->performed();
    const bool fades = sea != nullptr && sea->fading();
    const std::span<const Backend> all = preview_backends();
    for (std::size_t i = 0; i < all.size(); ++i) {
        BackendRow& row = state_.backends[i];
        row.why_not = scene_->why_not(all[i]);
        if (row.name == now && frames_of_backend_ > 2 && !fades) {
            row.milliseconds = state_.times.scene;
        }
    }
}

void Session::show_title() {
    if (titled_ == state_.source.source) return;
    titled_ = state_.source.source;
    glfwSetWindowTitle(window_, ("ocean-preview: " + titled_).c_str());
}

}  // namespace ocean::app
