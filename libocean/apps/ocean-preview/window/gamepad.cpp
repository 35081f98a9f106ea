// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/gamepad.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

namespace ocean::app {
namespace {

constexpr double kTurn = 90.0;      // [degrees/s]
constexpr double kDeadZone = 0.15;  // around the middle of a stick

/// Returns 0 for a stick within its dead zone, and values that grow from 0 outside it.
double stick(float value) {
    const double size = std::abs(static_cast<double>(value));
    if (!(size > kDeadZone)) return 0.0;
    return std::copysign(std::min(1.0, (size - kDeadZone) / (1.0 - kDeadZone)),
                         static_cast<double>(value));
}

}  // namespace

void Gamepad::read() {
    before_ = down_;
    down_ = {};
    is_connected_ = false;
    right_ = ahead_ = turn_left_ = turn_up_ = up_ = 0.0;
    for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
        if (glfwJoystickPresent(joystick) == GLFW_FALSE) continue;
        is_connected_ = true;
        GLFWgamepadstate pad;
        if (glfwGetGamepadState(joystick, &pad) == GLFW_TRUE) {
            right_ = stick(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X]);
            ahead_ = -stick(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]);
            turn_left_ = -stick(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X]);
            turn_up_ = -stick(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]);
            // At rest a trigger is at -1.
            up_ = 0.5 * static_cast<double>(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] -
                                            pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER]);
            constexpr int kButtons[] = {GLFW_GAMEPAD_BUTTON_A, GLFW_GAMEPAD_BUTTON_B,
                                        GLFW_GAMEPAD_BUTTON_X, GLFW_GAMEPAD_BUTTON_Y};
            for (std::size_t i = 0; i < down_.size(); ++i) {
                down_[i] = pad.buttons[kButtons[i]] == GLFW_PRESS;
            }
            return;
        }
        int axes = 0, buttons = 0;
        const float* axis = glfwGetJoystickAxes(joystick, &axes);
        const unsigned char* button = glfwGetJoystickButtons(joystick, &buttons);
        if (axes < 2) continue;  // a keyboard with a joystick's name
        right_ = stick(axis[0]);
        ahead_ = -stick(axis[1]);
        if (axes >= 4) {
            turn_left_ = -stick(axis[2]);
            turn_up_ = -stick(axis[3]);
        }
        for (std::size_t i = 0; i < down_.size() && static_cast<int>(i) < buttons; ++i) {
            down_[i] = button[i] == GLFW_PRESS;
        }
        return;
    }
}

void Gamepad::add_to(CameraInput& input, double seconds) const {
    input.right += right_;
    input.ahead += ahead_;
    input.turn_left += kTurn * seconds * turn_left_;
    input.turn_up += kTurn * seconds * turn_up_;
    input.up += up_;
}

}  // namespace ocean::app
