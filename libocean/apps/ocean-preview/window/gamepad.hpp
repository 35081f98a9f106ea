// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The first connected gamepad or joystick.
#pragma once

#include <array>

#include "window/camera_control.hpp"

namespace ocean::app {

/// The left stick moves, the right stick turns, triggers go up and down. A joystick without a known
/// layout moves by its first two axes and turns by the next two. A, B, X and Y of a gamepad pause,
/// change the camera, change the view, and return to the start.
class Gamepad {
  public:
    enum Button { pause, camera, view, reset };

    /// Reads the connected device, after GLFW's events were polled.
    void read();
    /// Adds its movement for so many seconds to an input.
    void add_to(CameraInput& input, double seconds) const;
    /// Returns whether the button went down since the previous read().
    bool pressed(Button button) const { return down_[button] && !before_[button]; }
    bool is_connected() const { return is_connected_; }

  private:
    bool is_connected_ = false;
    double right_ = 0.0, ahead_ = 0.0, turn_left_ = 0.0, turn_up_ = 0.0, up_ = 0.0;
    std::array<bool, 4> down_{};
    std::array<bool, 4> before_{};
};

}  // namespace ocean::app
