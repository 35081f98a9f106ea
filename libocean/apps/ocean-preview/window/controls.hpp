// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Keys, mouse and gamepad as commands and movements of the camera.
#pragma once

#include <array>
#include <vector>

#include "window/camera_control.hpp"
#include "window/window_input.hpp"

namespace ocean::app {

/// The steering of a driven hull, each -1 .. 1.
struct HullInput {
    double faster = 0.0;
    double left = 0.0;
};

/// The left stick moves, the right stick turns, triggers go up and down. A joystick without a known
/// layout moves by its first two axes and turns by the next two. A, B, X and Y of a gamepad pause,
/// change the camera, change the view, and return to the start. While a hull is driven, the left
/// stick or the first two axes drive it.
class Gamepad {
  public:
    enum Button { pause, camera, view, reset };

    /// Reads the connected device, after GLFW's events were polled.
    void read();
    /// Adds its movement for so many seconds to an input.
    void add_to(CameraInput& input, double seconds) const;
    /// Adds the motion of its left stick to the steering of a hull, in place of that of the camera.
    void add_to(HullInput& hull, CameraInput& camera) const;
    /// Returns whether the button went down since the previous read().
    bool pressed(Button button) const { return down_[button] && !before_[button]; }
    bool is_connected() const { return is_connected_; }

  private:
    bool is_connected_ = false;
    double right_ = 0.0, ahead_ = 0.0, turn_left_ = 0.0, turn_up_ = 0.0, up_ = 0.0;
    std::array<bool, 4> down_{};
    std::array<bool, 4> before_{};
};

enum class WindowCommand {
    close,
    pause,
    toggle_panel,
    toggle_wireframe,
    toggle_probe,
    next_view,
    next_camera,
    reset_camera,
    record,
    drive,
    place_crest,
    undo,
    reload,
    open,
    save_as,
    save_png,
    save_exr,
};

/// The commands and the movement of one frame.
struct ControlInput {
    CameraInput camera;
    HullInput hull;
    std::vector<WindowCommand> commands;

    bool moves_camera() const;
};

class Controls {
  public:
    /// Reads the input of the frame, `seconds` long. degrees_of_pixel: the turn of the camera for a
    /// pixel of dragging. drives: a hull is driven. Keys that the panel takes as text are no
    /// commands.
    ControlInput read(GLFWwindow* window, const WindowInput& input, double seconds,
                      double degrees_of_pixel, bool drives);

    bool has_gamepad() const { return gamepad_.is_connected(); }
    /// Returns the place of the mouse in the window, in its units.
    const std::array<double, 2>& mouse() const { return mouse_; }

  private:
    void add_keys(GLFWwindow* window, const WindowInput& input, ControlInput& result) const;
    void add_mouse(GLFWwindow* window, const WindowInput& input, double degrees_of_pixel,
                   ControlInput& result);
    void add_gamepad(double seconds, bool drives, ControlInput& result);

    Gamepad gamepad_;
    std::array<double, 2> mouse_{};
};

}  // namespace ocean::app
