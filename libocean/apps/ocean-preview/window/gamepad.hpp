// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The first gamepad or joystick that is plugged in.
#pragma once

#include <array>

#include "window/camera_control.hpp"

namespace ocean::app {

/// Left stick moves, right stick turns, triggers go up and down; a joystick without a known layout
/// moves by its first two axes and turns by the next two. Buttons: pause, camera, view, back to
/// where it began, of a gamepad A, B, X, Y.
class Gamepad {
  public:
    enum Button { pause, camera, view, reset };

    /// Asks what is plugged in. After GLFW's events.
    void read();
    /// What it asks of the camera for so many seconds, beside what is there.
    void add_to(CameraInput& input, double seconds) const;
    /// Went down since it was read before.
    bool pressed(Button button) const { return down_[button] && !before_[button]; }
    bool is_connected() const { return is_connected_; }

  private:
    bool is_connected_ = false;
    double right_ = 0.0, ahead_ = 0.0, turn_left_ = 0.0, turn_up_ = 0.0, up_ = 0.0;
    std::array<bool, 4> down_{};
    std::array<bool, 4> before_{};
};

}  // namespace ocean::app
