// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/gui.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>

#include "panel/widgets.hpp"
#include "preview_options.hpp"

namespace ocean::app {

Gui::Gui(GLFWwindow* window, std::optional<double> scale) : window_(window), wanted_(scale) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // it leaves no file in the working directory
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 4.0f;
    style_ = ImGui::GetStyle();
    constexpr bool kSetsCallbacks = false;
    ImGui_ImplGlfw_InitForOpenGL(window, kSetsCallbacks);
    ImGui_ImplOpenGL3_Init("#version 410");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

std::optional<double> Gui::fit_screen() {
    float scale = 1.0f, ignored = 1.0f;
    glfwGetWindowContentScale(window_, &scale, &ignored);
    scale = std::isfinite(scale) ? std::clamp(scale, kMinScale, kMaxScale) : 1.0f;
    if (wanted_) scale = static_cast<float>(*wanted_);
    const float unit = pixels_of_unit();
    if (scale == scale_ && unit == unit_) return std::nullopt;
    scale_ = scale;
    unit_ = unit;
    ImGui::GetStyle() = style_;
    ImGui::GetStyle().ScaleAllSizes(scale / unit);
    load_letters(scale, unit);
    return scale;
}

void Gui::load_letters(float scale, float unit) const {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    ImFontConfig letters;
    letters.SizePixels = std::round(kLetterSize * scale);
    letters.OversampleH = letters.OversampleV = 1;
    letters.PixelSnapH = true;
    io.Fonts->AddFontDefault(&letters);
    io.FontGlobalScale = 1.0f / unit;
    if (ImGui::GetFrameCount() > 0) {  // the first frame makes the letters' texture by itself
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
}

void Gui::begin(GLFWwindow* window, const InputEvent* event) {
    ImGui_ImplOpenGL3_NewFrame();
    if (event != nullptr) event->report_to_gui(window);
    ImGui_ImplGlfw_NewFrame();
    if (event != nullptr) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {static_cast<float>(event->x), static_cast<float>(event->y)};
        std::ranges::copy(event->buttons, io.MouseDown);
    }
    ImGui::NewFrame();
}

void Gui::end() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

/// Returns the pixels of a unit of the window's coordinates: more than 1 on Wayland and macOS,
/// where units carry a part of the scale. In quarters, because the two sizes are read one after the
/// other.
float Gui::pixels_of_unit() const {
    int units = 0, pixels = 0, ignored = 0;
    glfwGetWindowSize(window_, &units, &ignored);
    glfwGetFramebufferSize(window_, &pixels, &ignored);
    if (units < 1 || pixels < 1) return unit_;
    const float quarters =
        std::round(4.0f * static_cast<float>(pixels) / static_cast<float>(units));
    return std::max(quarters, 1.0f) / 4.0f;
}

}  // namespace ocean::app
