// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/window.hpp"

#include <epoxy/gl.h>
//
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <memory>
#include <string>

#include "ocean/error.hpp"
#include "window/gui.hpp"
#include "window/session.hpp"
#include "window/window_input.hpp"

namespace ocean::app {
namespace {

/// GLFW, from its initialization to its termination.
class WindowLibrary {
  public:
    WindowLibrary() {
        glfwSetErrorCallback([](int, const char* text) { last_error() = text; });
        if (glfwInit() == GLFW_FALSE) {
            throw Error(ErrorKind::no_gpu, "no window can be opened (" + last_error() +
                                               "); --offscreen FILE.png needs none");
        }
    }
    ~WindowLibrary() { glfwTerminate(); }
    WindowLibrary(const WindowLibrary&) = delete;
    WindowLibrary& operator=(const WindowLibrary&) = delete;

    static std::string& last_error() {
        static std::string text;
        return text;
    }
};

struct CloseWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using Window = std::unique_ptr<GLFWwindow, CloseWindow>;

void keep_on_screen(GLFWwindow* window) {
    int x = 0, y = 0, max_width = 0, max_height = 0, width = 0, height = 0;
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return;
    glfwGetMonitorWorkarea(monitor, &x, &y, &max_width, &max_height);
    glfwGetWindowSize(window, &width, &height);
    if (max_width < 1 || max_height < 1 || (width <= max_width && height <= max_height)) return;
    glfwSetWindowSize(window, std::min(width, max_width), std::min(height, max_height));
}

/// Opens a window of OpenGL 4.3, or 4.1. The default size grows with the screen's scale, up to the
/// size of the screen. Throws Error no_gpu.
Window open_window(const PreviewOptions& options, const std::string& title) {
    const auto [width, height] = options.size;
    const bool scales = !options.has_size && !options.scale;
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, scales ? GLFW_TRUE : GLFW_FALSE);
    for (const int minor : {3, 1}) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        Window window(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
        if (!window) continue;
        if (scales) keep_on_screen(window.get());
        return window;
    }
    throw Error(ErrorKind::no_gpu,
                "no window with OpenGL 4.1 can be opened (" + WindowLibrary::last_error() + ")");
}

}  // namespace

void run_window(const PreviewOptions& options, const OpenedScene& scene,
                const SubjectArgument& source, const Context& context) {
    const WindowLibrary library;
    const Window window = open_window(options, "ocean-preview: " + source.source);
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    WindowInput input;
    input.listen_to(window.get());
    Gui gui(window.get(), options.scale);
    Session session(options, scene, source, context, window.get(), input, gui);
    session.run();
}

}  // namespace ocean::app
