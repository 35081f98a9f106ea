// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window.hpp"

#include <epoxy/gl.h>
//
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "console.hpp"
#include "live_sea.hpp"
#include "ocean/error.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/io/png.hpp"
#include "ocean/platform.hpp"
#include "ocean/preview/canvas.hpp"
#include "ocean/seafile.hpp"
#include "ocean/text.hpp"
#include "offscreen_run.hpp"
#include "panel.hpp"
#include "workload.hpp"

namespace ocean::app {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The library of windows, begun and ended.
class Windows {
  public:
    Windows() {
        glfwSetErrorCallback([](int, const char* text) { last_error() = text; });
        if (glfwInit() == GLFW_FALSE) {
            throw Error(ErrorKind::no_gpu, "there is no window here (" + last_error() +
                                               "); --offscreen FILE.png needs none");
        }
    }
    ~Windows() { glfwTerminate(); }
    Windows(const Windows&) = delete;
    Windows& operator=(const Windows&) = delete;

    static std::string& last_error() {
        static std::string text;
        return text;
    }
};

struct CloseWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using Window = std::unique_ptr<GLFWwindow, CloseWindow>;

Window open_window(int width, int height, const std::string& title) {
    for (const int minor : {3, 1}) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        Window window(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
        if (window) return window;
    }
    throw Error(ErrorKind::no_gpu,
                "no window with OpenGL 4.1 can be opened (" + Windows::last_error() + ")");
}

/// What happened in a window since it was last looked at: a key may be down for less than a frame.
struct Events {
    bool any = false;
    std::vector<int> keys;       // that went down
    std::vector<int> with_ctrl;  // of them

    /// Before Gui, which then calls these too.
    void listen_to(GLFWwindow* window) {
        glfwSetWindowUserPointer(window, this);
        glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int, int action, int modifiers) {
            Events& all = events(of);
            all.any = true;
            if (action != GLFW_PRESS) return;
            all.keys.push_back(key);
            if ((modifiers & GLFW_MOD_CONTROL) != 0) all.with_ctrl.push_back(key);
        });
        glfwSetCursorPosCallback(window, [](GLFWwindow* of, double, double) { happened(of); });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* of, int, int, int) { happened(of); });
        glfwSetScrollCallback(window, [](GLFWwindow* of, double, double) { happened(of); });
        glfwSetCharCallback(window, [](GLFWwindow* of, unsigned) { happened(of); });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* of, int, int) { happened(of); });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* of) { happened(of); });
    }

    void forget() {
        any = false;
        keys.clear();
        with_ctrl.clear();
    }

  private:
    static Events& events(GLFWwindow* window) {
        return *static_cast<Events*>(glfwGetWindowUserPointer(window));
    }
    static void happened(GLFWwindow* window) { events(window).any = true; }
};

/// Dear ImGui in a window.
class Gui {
  public:
    explicit Gui(GLFWwindow* window) {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;  // it leaves no file where it is started
        ImGui::StyleColorsDark();
        ImGui::GetStyle().WindowRounding = 4.0f;
        ImGui_ImplGlfw_InitForOpenGL(window, true);
        ImGui_ImplOpenGL3_Init("#version 410");
    }
    ~Gui() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Keys that were pressed since the last frame count, even if they are up again.
    static void begin(GLFWwindow* window, const std::vector<int>& pressed) {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGuiIO& io = ImGui::GetIO();
        for (const int key : pressed) {
            if (key >= 0) io.KeysDown[key] = true;
        }
        ImGui::NewFrame();
        for (const int key : pressed) {
            if (key >= 0) io.KeysDown[key] = glfwGetKey(window, key) == GLFW_PRESS;
        }
    }
    static void end() {
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }
};

/// The first of NAME-1.png, NAME-2.png ... that is not there: nothing is ever written over.
std::string free_name(const std::string& stem, const std::string& ending) {
    for (int n = 1;; ++n) {
        const std::string name = stem + "-" + std::to_string(n) + ending;
        if (!std::filesystem::exists(utf8_path(name))) return name;
    }
}

class Preview {
  public:
    Preview(const PreviewOptions& options, const Sea& sea, const std::string& source,
            const Context& context, GLFWwindow* window, Events& events)
        : options_(options),
          context_(context),
          stem_(stem_of(source)),
          window_(window),
          events_(events),
          info_(gl::context_info()),
          computes_(options.computer == Computer::gpu ||
                    (options.computer == Computer::best && computes_well(info_))),
          work_(workload_for(options, sea, info_, computes_)),
          renderer_(work_.renderer),
          sea_(sea, context.options.threads, work_.maps, renderer_.most_cascades()),
          camera_(options.camera) {
        if (options.time) sea_.clock.go_to(*options.time);
        if (options.frame) sea_.clock.go_to(sea.time_of(*options.frame));
        state_.look = options.look;
        state_.view = options.view;
        state_.wireframe = options.wireframe;
        state_.computed_by = info_.renderer + (computes_ ? "" : "; the sea by the processor");
    }

    void run() {
        auto before = Clock::now();
        while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
            wait_for_something();
            const double seconds = std::min(0.25, milliseconds_since(before) / 1000.0);
            before = Clock::now();
            sea_.advance(seconds);
            if (step(seconds)) frames_to_draw_ = 3;
            if (frames_to_draw_ > 0 || !sea_.clock.paused || sea_.fading()) draw();
            if (frames_to_draw_ > 0) --frames_to_draw_;
            events_.forget();
        }
    }

  private:
    /// While the sea stands still nothing is done but what a person wants.
    void wait_for_something() {
        const bool iconified = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0;
        const bool still = sea_.clock.paused && !sea_.fading() && frames_to_draw_ == 0;
        if (iconified || still) {
            glfwWaitEventsTimeout(0.25);
        } else {
            glfwPollEvents();
        }
        if (events_.any) frames_to_draw_ = 3;  // what is under the mouse is known a frame late
    }

    bool pressed(int key) const {
        return std::ranges::find(events_.keys, key) != events_.keys.end();
    }

    double axis(int more, int less) {
        return (glfwGetKey(window_, more) == GLFW_PRESS ? 1.0 : 0.0) -
               (glfwGetKey(window_, less) == GLFW_PRESS ? 1.0 : 0.0);
    }

    /// Keys, mouse, joystick. Returns whether they changed anything.
    bool step(double seconds) {
        const ImGuiIO& io = ImGui::GetIO();
        CameraInput input;
        bool acted = false;
        const auto on = [&](int key, auto&& act) {
            if (!pressed(key)) return;
            act();
            acted = true;
        };
        on(GLFW_KEY_F12, [&] { picture_asked_ = true; });
        if (!io.WantTextInput) {
            on(GLFW_KEY_ESCAPE, [&] { glfwSetWindowShouldClose(window_, GLFW_TRUE); });
            on(GLFW_KEY_SPACE, [&] { sea_.clock.paused = !sea_.clock.paused; });
            on(GLFW_KEY_TAB, [&] { state_.shown = !state_.shown; });
            on(GLFW_KEY_F, [&] { state_.wireframe = !state_.wireframe; });
            on(GLFW_KEY_P, [&] { state_.probing = !state_.probing; });
            on(GLFW_KEY_V, [&] {
                const auto views = static_cast<int>(preview::view_names().size());
                state_.view =
                    static_cast<preview::View>((static_cast<int>(state_.view) + 1) % views);
            });
            on(GLFW_KEY_C, [&] {
                camera_.mode = static_cast<CameraMode>((static_cast<int>(camera_.mode) + 1) % 4);
            });
            if (std::ranges::find(events_.with_ctrl, GLFW_KEY_Z) != events_.with_ctrl.end()) {
                undo(sea_, state_);
                acted = true;
            }
            input.ahead = axis(GLFW_KEY_W, GLFW_KEY_S);
            input.right = axis(GLFW_KEY_D, GLFW_KEY_A);
            input.up = axis(GLFW_KEY_E, GLFW_KEY_Q);
            input.fast = glfwGetKey(window_, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS;
        }
        double x = 0.0, y = 0.0;
        glfwGetCursorPos(window_, &x, &y);
        if (!io.WantCaptureMouse) {
            if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
                const double degrees = camera_.camera().field_of_view / std::max(1, width_);
                input.turn_left = degrees * (x - mouse_x_);
                input.turn_up = degrees * (y - mouse_y_);
            }
            input.closer = static_cast<double>(io.MouseWheel);
        }
        mouse_x_ = x;
        mouse_y_ = y;
        add_joystick(input, seconds);
        const bool moves = input.ahead != 0.0 || input.right != 0.0 || input.up != 0.0 ||
                           input.turn_left != 0.0 || input.turn_up != 0.0 || input.closer != 0.0;
        const bool rides = camera_.mode == CameraMode::walk || camera_.mode == CameraMode::floating;
        if (moves || (rides && !sea_.clock.paused) || acted) {
            camera_.step(input, seconds, sea_.ocean(), sea_.clock.time());
        }
        return moves || acted;
    }

    void add_joystick(CameraInput& input, double seconds) {
        GLFWgamepadstate pad;
        if (glfwGetGamepadState(GLFW_JOYSTICK_1, &pad) == GLFW_FALSE) return;
        const auto stick = [&](int number) {
            const auto value = static_cast<double>(pad.axes[number]);
            return std::abs(value) < 0.15 ? 0.0 : value;
        };
        constexpr double kTurn = 90.0;  // degrees a second
        input.right += stick(GLFW_GAMEPAD_AXIS_LEFT_X);
        input.ahead -= stick(GLFW_GAMEPAD_AXIS_LEFT_Y);
        input.turn_left -= kTurn * seconds * stick(GLFW_GAMEPAD_AXIS_RIGHT_X);
        input.turn_up -= kTurn * seconds * stick(GLFW_GAMEPAD_AXIS_RIGHT_Y);
        input.up += 0.5 * (static_cast<double>(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER]) -
                           static_cast<double>(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER]));
    }

    void draw() {
        glfwGetFramebufferSize(window_, &width_, &height_);
        if (width_ == 0 || height_ == 0) return;  // an icon
        auto start = Clock::now();
        const preview::ShownSea shown = sea_.show();
        state_.times.sea = milliseconds_since(start);

        start = Clock::now();
        draw_sea(shown);
        state_.times.draw = milliseconds_since(start);

        start = Clock::now();
        look_under_mouse();
        Gui::begin(window_, events_.keys);
        state_.touched = state_.save_sea = state_.save_picture = state_.reset_camera = false;
        draw_panel(sea_, shown, camera_, state_);
        Gui::end();
        state_.times.panel = milliseconds_since(start);
        glfwSwapBuffers(window_);

        if (state_.touched) frames_to_draw_ = 3;
        if (state_.reset_camera) camera_.reset(options_.camera);
        if (state_.save_sea) save_sea();
        if (state_.save_picture || std::exchange(picture_asked_, false)) save_picture();
    }

    void draw_sea(const preview::ShownSea& shown) {
        const int width = std::max(16, static_cast<int>(std::lround(width_ * work_.scale)));
        const int height = std::max(16, static_cast<int>(std::lround(height_ * work_.scale)));
        if (!canvas_ || width != canvas_width_ || height != canvas_height_) {
            canvas_ = std::make_unique<preview::Canvas>(width, height, GL_RGBA8);
            canvas_width_ = width;
            canvas_height_ = height;
        }
        canvas_->bind();
        preview::DrawOptions options;
        options.width = width;
        options.height = height;
        options.view = state_.view;
        options.wireframe = state_.wireframe;
        renderer_.draw(shown, camera_.camera(), state_.look, options);
        canvas_->copy_to_window(width_, height_);
    }

    /// The sea where the mouse points, by the query: a few steps along the line of sight.
    void look_under_mouse() {
        state_.under_mouse.clear();
        if (!state_.probing || ImGui::GetIO().WantCaptureMouse) return;
        int width = 0, height = 0;
        glfwGetWindowSize(window_, &width, &height);
        const auto place = camera_.camera().meet_level(mouse_x_ / width, mouse_y_ / height,
                                                       static_cast<double>(width) / height, 0.0);
        if (!place) return;
        WorldPoint point{(*place)[0], (*place)[1]};
        QuerySample sample{};
        for (int i = 0; i < 3; ++i) {
            sea_.ocean().query(sea_.clock.time(), {&point, 1}, {&sample, 1}, {.foam = false});
            const auto nearer =
                camera_.camera().meet_level(mouse_x_ / width, mouse_y_ / height,
                                            static_cast<double>(width) / height, sample.height);
            if (!nearer) return;
            point = {(*nearer)[0], (*nearer)[1]};
        }
        state_.under_mouse =
            format_text("x %.2f  y %.2f  height %.2f m\nnormal %.2f %.2f %.2f", point.x, point.y,
                        sample.height, sample.normal[0], sample.normal[1], sample.normal[2]);
    }

    void save_sea() {
        guarded([&] {
            const std::string name = free_name(stem_ + "-performed", ".toml");
            io::write_file_atomically(name, write_sea(sea_.sea()));
            return name;
        });
    }

    void save_picture() {
        guarded([&] {
            const std::string name = free_name(stem_, ".png");
            if (canvas_) io::write_png(name, canvas_width_, canvas_height_, canvas_->rgb());
            return name;
        });
    }

    template <typename Write>
    void guarded(Write&& write) {
        try {
            state_.message = "written: " + write();
            context_.console.note(state_.message);
        } catch (const Error& error) {
            state_.message = error.what();
        }
        frames_to_draw_ = 3;
    }

    const PreviewOptions& options_;
    const Context& context_;
    std::string stem_;
    GLFWwindow* window_;
    Events& events_;
    gl::ContextInfo info_;
    bool computes_;
    Workload work_;
    preview::Renderer renderer_;
    LiveSea sea_;
    CameraControl camera_;
    PanelState state_;
    std::unique_ptr<preview::Canvas> canvas_;
    int canvas_width_ = 0, canvas_height_ = 0;
    int width_ = 0, height_ = 0;
    double mouse_x_ = 0.0, mouse_y_ = 0.0;
    int frames_to_draw_ = 3;
    bool picture_asked_ = false;  // of what is drawn next
};

}  // namespace

void run_window(const PreviewOptions& options, const Sea& sea, const std::string& source,
                const Context& context) {
    const Windows windows;
    const Window window = open_window(options.size[0], options.size[1], "ocean-preview: " + source);
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    Events events;
    events.listen_to(window.get());
    const Gui gui(window.get());
    Preview preview(options, sea, source, context, window.get(), events);
    preview.run();
}

}  // namespace ocean::app
