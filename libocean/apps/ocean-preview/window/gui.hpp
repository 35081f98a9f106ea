// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Dear ImGui in a window.
#pragma once

#include <imgui.h>

#include <optional>

#include "window/window_input.hpp"

namespace ocean::app {

class Gui {
  public:
    /// scale: of letters and controls, in place of the scale of the window's screen.
    Gui(GLFWwindow* window, std::optional<double> scale);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Fits letters, controls and spaces to the scale of the screen that the window is on now;
    /// letters have as many pixels as they are shown with. Between frames. Returns the scale if it
    /// has changed.
    std::optional<double> fit_screen();

    /// Begins a frame at an event, with the mouse where it was then, or with the present state.
    static void begin(GLFWwindow* window, const InputEvent* event = nullptr);
    static void end();

  private:
    float pixels_of_unit() const;
    void load_letters(float scale, float unit) const;

    GLFWwindow* window_;
    const std::optional<double> wanted_;
    ImGuiStyle style_;  // at scale 1
    float scale_ = 0.0f;
    float unit_ = 1.0f;
};

}  // namespace ocean::app
