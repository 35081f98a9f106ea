// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Input of a window since the last frame. A frame may be slow, so that a key can go down and up
// within one: nothing is polled that an event reports.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace ocean::app {

/// One event of a button, a key or the wheel, with the state of the mouse at that moment.
struct InputEvent {
    double x;
    double y;
    std::array<bool, 3> buttons;  // the mouse buttons that are down after it
    std::function<void(GLFWwindow* window)> report_to_gui;
};

class WindowInput {
  public:
    /// Receives the window's events from now on. They are reported to the GUI one by one, at its
    /// frames; it must not set callbacks of its own.
    void listen_to(GLFWwindow* window);

    /// Returns the state for scripts: "1000x700, mouse at 90,659, 12 keys, 3 clicks, 0 held".
    std::string text(GLFWwindow* window) const;
    bool pressed(int key) const;
    bool pressed_with_ctrl(int key) const;
    void forget();

    bool any = false;  // something happened
    // The left button went down with the control key held, at this place.
    std::optional<std::array<double, 2>> clicked_with_ctrl;
    double wheel = 0.0;
    std::vector<InputEvent> events;    // in their order
    std::vector<std::string> dropped;  // paths of files that were dropped on the window

  private:
    static WindowInput& of(GLFWwindow* window);
    static void happened(GLFWwindow* window) { of(window).any = true; }
    void count(int action, int& presses);
    void add(std::function<void(GLFWwindow* window)> report_to_gui);
    void listen_to_keys(GLFWwindow* window);
    void listen_to_mouse(GLFWwindow* window);

    // Since the window opened.
    int keys_pressed_ = 0;
    int clicks_ = 0;
    int held_ = 0;                // keys and buttons that are down
    std::vector<int> keys_;       // that went down in this frame
    std::vector<int> with_ctrl_;  // of those, with the control key
    double x_ = 0.0;
    double y_ = 0.0;
    std::array<bool, 3> buttons_{};
};

}  // namespace ocean::app
