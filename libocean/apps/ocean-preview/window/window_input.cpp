// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/window_input.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include <algorithm>
#include <utility>

#include "ocean/internal/text.hpp"

namespace ocean::app {

void WindowInput::listen_to(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwGetCursorPos(window, &x_, &y_);
    listen_to_keys(window);
    listen_to_mouse(window);
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        WindowInput& input = of(w);
        input.any = true;
        input.dropped.insert(input.dropped.end(), paths, paths + count);
    });
    glfwSetWindowFocusCallback(window, ImGui_ImplGlfw_WindowFocusCallback);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { happened(w); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { happened(w); });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { happened(w); });
}

void WindowInput::listen_to_keys(GLFWwindow* window) {
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int code, int action, int mods) {
        WindowInput& input = of(w);
        input.add([=](GLFWwindow* target) {
            ImGui_ImplGlfw_KeyCallback(target, key, code, action, mods);
        });
        input.count(action, input.keys_pressed_);
        if (action != GLFW_PRESS) return;
        input.keys_.push_back(key);
        if ((mods & GLFW_MOD_CONTROL) != 0) input.with_ctrl_.push_back(key);
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned letter) {
        of(w).add([=](GLFWwindow* target) { ImGui_ImplGlfw_CharCallback(target, letter); });
    });
}

void WindowInput::listen_to_mouse(GLFWwindow* window) {
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        WindowInput& input = of(w);
        const auto at = static_cast<std::size_t>(button);
        if (at < input.buttons_.size()) input.buttons_[at] = action == GLFW_PRESS;
        input.count(action, input.clicks_);
        if (action == GLFW_PRESS && button == GLFW_MOUSE_BUTTON_LEFT &&
            (mods & GLFW_MOD_CONTROL) != 0) {
            input.clicked_with_ctrl = {{input.x_, input.y_}};
        }
        input.add([=](GLFWwindow* target) {
            ImGui_ImplGlfw_MouseButtonCallback(target, button, action, mods);
        });
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).wheel += y;
        of(w).add([=](GLFWwindow* target) { ImGui_ImplGlfw_ScrollCallback(target, x, y); });
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        WindowInput& input = of(w);
        input.any = true;
        input.x_ = x;
        input.y_ = y;
    });
    glfwSetCursorEnterCallback(window, ImGui_ImplGlfw_CursorEnterCallback);
}

std::string WindowInput::text(GLFWwindow* window) const {
    int width = 0, height = 0;
    glfwGetWindowSize(window, &width, &height);
    return format_text("%dx%d, mouse at %.0f,%.0f, %d keys, %d clicks, %d held", width, height, x_,
                       y_, keys_pressed_, clicks_, held_);
}

bool WindowInput::pressed(int key) const {
    return std::ranges::find(keys_, key) != keys_.end();
}

bool WindowInput::pressed_with_ctrl(int key) const {
    return std::ranges::find(with_ctrl_, key) != with_ctrl_.end();
}

void WindowInput::forget() {
    any = false;
    clicked_with_ctrl.reset();
    keys_.clear();
    with_ctrl_.clear();
    wheel = 0.0;
    events.clear();
    dropped.clear();
}

WindowInput& WindowInput::of(GLFWwindow* window) {
    return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

void WindowInput::count(int action, int& presses) {
    if (action == GLFW_PRESS) ++presses, ++held_;
    if (action == GLFW_RELEASE) --held_;
}

void WindowInput::add(std::function<void(GLFWwindow* window)> report_to_gui) {
    any = true;
    events.push_back({x_, y_, buttons_, std::move(report_to_gui)});
}

}  // namespace ocean::app
