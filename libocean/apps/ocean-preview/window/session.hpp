// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A window's session: the loop over input, clock and picture, and the actions that a person, a
// gamepad or a bridge requests.
#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <string>

#include "command.hpp"
#include "console.hpp"
#include "live_scene.hpp"
#include "ocean/error.hpp"
#include "panel/panel_state.hpp"
#include "preview_options.hpp"
#include "window/controls.hpp"
#include "window/gui.hpp"
#include "window/session_bridge.hpp"
#include "window/session_files.hpp"
#include "window/stage_timer.hpp"
#include "window/viewport.hpp"

namespace ocean::app {

class Session {
  public:
    /// All arguments outlive the session. Throws Error.
    Session(const PreviewOptions& options, const OpenedScene& scene, const SubjectArgument& source,
            const Context& context, GLFWwindow* window, WindowInput& input, Gui& gui);

    /// Blocks until the window is closed. A recording that is in no file is saved then.
    void run();

  private:
    using Clock = std::chrono::steady_clock;

    LiveSceneOptions scene_options(const PreviewOptions& options);
    void begin();
    /// Fits camera, view and bridge to a scene of another kind.
    void follow_kind();
    void wait_for_input();
    void note_rest(bool rests);
    bool step(double seconds);
    void carry_out(WindowCommand command);
    void carry_out_on_sea(WindowCommand command);
    void drive(LiveSea& sea, bool new_hull);
    void place_crest(LiveSea& sea);
    /// Moves the camera along with the driven hull.
    void follow_hull();
    /// Returns a place of the window as a share of it, from the left and from the top.
    std::array<double, 2> in_window(const std::array<double, 2>& at) const;
    double window_aspect() const;
    void draw();
    void draw_scene();
    void draw_panels();
    void lay_out_panel();
    void run_requests();
    void look_under_mouse();
    void list_backends();
    void next_view();
    void reset_camera();
    void serve();
    void record(bool on, const std::string& name);
    void choose_backend(const std::string& name);
    void save_scene(const std::string& requested = "");
    void save_picture(const std::string& ending);
    void reload();
    void show_title();
    /// Writes a file by a function that returns its name, which the window shows.
    template <typename Write>
    void write(Write&& write) {
        guarded([&] {
            state_.message = "written: " + write();
            context_.console.note(state_.message);
        });
        frames_to_draw_ = kFramesToSettle;
    }
    /// Returns true if the work was done; else the window's message says why not.
    template <typename Work>
    bool guarded(Work&& work) {
        try {
            work();
            return true;
        } catch (const Error& error) {
            state_.message = error.what();
            return false;
        }
    }

    /// Frames after a change: the item under the mouse is known a frame late.
    static constexpr int kFramesToSettle = 3;

    const PreviewOptions& options_;
    const Context& context_;
    GLFWwindow* window_;
    WindowInput& input_;
    Gui& gui_;
    gl::ContextInfo info_;
    PanelState state_;
    Viewport viewport_;
    LiveScene scene_;
    const SceneRow* first_;   // that the options are for
    const SceneRow* fitted_;  // that camera and view fit
    SavedScene saved_;
    SessionFiles files_;
    std::string titled_;  // the source in the window's title
    CameraControl camera_;
    Controls controls_;
    SessionBridge bridge_;
    StageTimer scene_timer_, draw_timer_;
    Clock::time_point drawn_ = Clock::now();
    int frames_to_draw_ = 3;
    int frames_of_backend_ = 0;
    std::optional<std::array<double, 2>> hull_place_;  // of the driven one, in the last frame [m]
    bool began_ = false, rests_ = false;
    std::string picture_requested_;  // ".png" or ".exr", of the next frame
};

}  // namespace ocean::app
