// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/controls.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
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

bool is_down(GLFWwindow* window, int key) {
    return glfwGetKey(window, key) == GLFW_PRESS;
}

double axis(GLFWwindow* window, int more, int less) {
    return (is_down(window, more) ? 1.0 : 0.0) - (is_down(window, less) ? 1.0 : 0.0);
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

void Gamepad::add_to(HullInput& hull, CameraInput& camera) const {
    hull.faster += ahead_;
    hull.left -= right_;
    camera.ahead -= ahead_;
    camera.right -= right_;
}

bool ControlInput::moves_camera() const {
    return camera.ahead != 0.0 || camera.right != 0.0 || camera.up != 0.0 ||
           camera.turn_left != 0.0 || camera.turn_up != 0.0 || camera.closer != 0.0;
}

ControlInput Controls::read(GLFWwindow* window, const WindowInput& input, double seconds,
                            double degrees_of_pixel, bool drives) {
    ControlInput result;
    add_keys(window, input, result);
    add_mouse(window, input, degrees_of_pixel, result);
    add_gamepad(seconds, drives, result);
    return result;
}

void Controls::add_keys(GLFWwindow* window, const WindowInput& input, ControlInput& result) const {
    const auto on = [&](int key, WindowCommand command) {
        if (input.pressed(key)) result.commands.push_back(command);
    };
    const bool shift = is_down(window, GLFW_KEY_LEFT_SHIFT);
    on(GLFW_KEY_F12, shift ? WindowCommand::save_exr : WindowCommand::save_png);
    if (ImGui::GetIO().WantTextInput) return;
    // Escape closes an open list first, and the window only if none is open.
    if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
        on(GLFW_KEY_ESCAPE, WindowCommand::close);
    on(GLFW_KEY_SPACE, WindowCommand::pause);
    on(GLFW_KEY_TAB, WindowCommand::toggle_panel);
    on(GLFW_KEY_F, WindowCommand::toggle_wireframe);
    on(GLFW_KEY_P, WindowCommand::toggle_probe);
    on(GLFW_KEY_V, WindowCommand::next_view);
    on(GLFW_KEY_C, WindowCommand::next_camera);
    on(GLFW_KEY_H, WindowCommand::drive);
    on(GLFW_KEY_R,
       input.pressed_with_ctrl(GLFW_KEY_R) ? WindowCommand::reload : WindowCommand::record);
    if (input.pressed_with_ctrl(GLFW_KEY_Z)) result.commands.push_back(WindowCommand::undo);
    if (input.pressed_with_ctrl(GLFW_KEY_O)) result.commands.push_back(WindowCommand::open);
    if (input.pressed_with_ctrl(GLFW_KEY_S)) result.commands.push_back(WindowCommand::save_as);
    // Ctrl S saves, and moves nothing.
    if (is_down(window, GLFW_KEY_LEFT_CONTROL) || is_down(window, GLFW_KEY_RIGHT_CONTROL)) return;
    result.hull = {axis(window, GLFW_KEY_UP, GLFW_KEY_DOWN),
                   axis(window, GLFW_KEY_LEFT, GLFW_KEY_RIGHT)};
    result.camera.ahead = axis(window, GLFW_KEY_W, GLFW_KEY_S);
    result.camera.right = axis(window, GLFW_KEY_D, GLFW_KEY_A);
    result.camera.up = axis(window, GLFW_KEY_E, GLFW_KEY_Q);
    result.camera.fast = shift;
}

void Controls::add_mouse(GLFWwindow* window, const WindowInput& input, double degrees_of_pixel,
                         ControlInput& result) {
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window, &x, &y);
    if (!ImGui::GetIO().WantCaptureMouse) {
        if (input.clicked_with_ctrl) result.commands.push_back(WindowCommand::place_crest);
        if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
            result.camera.turn_left = degrees_of_pixel * (x - mouse_[0]);
            result.camera.turn_up = degrees_of_pixel * (y - mouse_[1]);
        }
        result.camera.closer = input.wheel;
    }
    mouse_ = {x, y};
}

void Controls::add_gamepad(double seconds, bool drives, ControlInput& result) {
    gamepad_.read();
    gamepad_.add_to(result.camera, seconds);
    if (drives) gamepad_.add_to(result.hull, result.camera);
    const auto on = [&](Gamepad::Button button, WindowCommand command) {
        if (gamepad_.pressed(button)) result.commands.push_back(command);
    };
    on(Gamepad::pause, WindowCommand::pause);
    on(Gamepad::camera, WindowCommand::next_camera);
    on(Gamepad::view, WindowCommand::next_view);
    on(Gamepad::reset, WindowCommand::reset_camera);
}

}  // namespace ocean::app
