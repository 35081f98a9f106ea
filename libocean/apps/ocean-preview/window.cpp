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
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bridge_host.hpp"
#include "bridge_link.hpp"
#include "console.hpp"
#include "gamepad.hpp"
#include "live_sea.hpp"
#include "ocean/cascades.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/io/png.hpp"
#include "ocean/preview/canvas.hpp"
#include "ocean/preview/probe.hpp"
#include "ocean/seafile.hpp"
#include "ocean/text.hpp"
#include "offscreen_run.hpp"
#include "panel.hpp"
#include "picture_file.hpp"
#include "stage_picture.hpp"
#include "stage_timer.hpp"
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

void keep_on_screen(GLFWwindow* window) {
    int x = 0, y = 0, most_width = 0, most_height = 0, width = 0, height = 0;
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return;
    glfwGetMonitorWorkarea(monitor, &x, &y, &most_width, &most_height);
    glfwGetWindowSize(window, &width, &height);
    if (most_width < 1 || most_height < 1 || (width <= most_width && height <= most_height)) return;
    glfwSetWindowSize(window, std::min(width, most_width), std::min(height, most_height));
}

/// Of the default size as large as the screen's scale asks for, and no larger than the screen.
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
                "no window with OpenGL 4.1 can be opened (" + Windows::last_error() + ")");
}

/// What a hand did, and where the mouse was then.
struct HandAct {
    double x;
    double y;
    std::array<bool, 3> buttons;  // that are down since
    std::function<void(GLFWwindow* window)> tell_gui;
};

/// What happened in a window since it was last looked at: a key may be down for less than a frame.
struct Events {
    bool any = false;
    // Since the window opened.
    int keys_pressed = 0;
    int clicks = 0;
    int held = 0;                // keys and buttons that are down
    std::vector<int> keys;       // that went down
    std::vector<int> with_ctrl;  // of them
    double wheel = 0.0;
    std::vector<HandAct> acts;  // of buttons, keys and wheel, one after another

    /// Gui is told of the acts, and sets no callbacks itself.
    void listen_to(GLFWwindow* window) {
        glfwSetWindowUserPointer(window, this);
        glfwGetCursorPos(window, &x_, &y_);
        glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int code, int action, int mods) {
            Events& all = events(of);
            all.add([=](GLFWwindow* window) {
                ImGui_ImplGlfw_KeyCallback(window, key, code, action, mods);
            });
            all.count(action, all.keys_pressed);
            if (action != GLFW_PRESS) return;
            all.keys.push_back(key);
            if ((mods & GLFW_MOD_CONTROL) != 0) all.with_ctrl.push_back(key);
        });
        glfwSetCharCallback(window, [](GLFWwindow* of, unsigned letter) {
            events(of).add(
                [=](GLFWwindow* window) { ImGui_ImplGlfw_CharCallback(window, letter); });
        });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* of, int button, int action, int mods) {
            Events& all = events(of);
            const auto at = static_cast<std::size_t>(button);
            if (at < all.buttons_.size()) all.buttons_[at] = action == GLFW_PRESS;
            all.count(action, all.clicks);
            all.add([=](GLFWwindow* window) {
                ImGui_ImplGlfw_MouseButtonCallback(window, button, action, mods);
            });
        });
        glfwSetScrollCallback(window, [](GLFWwindow* of, double x, double y) {
            events(of).wheel += y;
            events(of).add(
                [=](GLFWwindow* window) { ImGui_ImplGlfw_ScrollCallback(window, x, y); });
        });
        glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) {
            Events& all = events(of);
            all.any = true;
            all.x_ = x;
            all.y_ = y;
        });
        glfwSetCursorEnterCallback(window, ImGui_ImplGlfw_CursorEnterCallback);
        glfwSetWindowFocusCallback(window, ImGui_ImplGlfw_WindowFocusCallback);
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* of, int, int) { happened(of); });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* of) { happened(of); });
        glfwSetWindowContentScaleCallback(window,
                                          [](GLFWwindow* of, float, float) { happened(of); });
    }

    /// "1000x700, mouse at 90,659, 12 keys, 3 clicks, 0 held".
    std::string text(GLFWwindow* window) const {
        int width = 0, height = 0;
        glfwGetWindowSize(window, &width, &height);
        return format_text("%dx%d, mouse at %.0f,%.0f, %d keys, %d clicks, %d held", width, height,
                           x_, y_, keys_pressed, clicks, held);
    }

    void forget() {
        any = false;
        keys.clear();
        with_ctrl.clear();
        wheel = 0.0;
        acts.clear();
    }

  private:
    static Events& events(GLFWwindow* window) {
        return *static_cast<Events*>(glfwGetWindowUserPointer(window));
    }
    static void happened(GLFWwindow* window) { events(window).any = true; }
    void count(int action, int& presses) {
        if (action == GLFW_PRESS) ++presses, ++held;
        if (action == GLFW_RELEASE) --held;
    }
    void add(std::function<void(GLFWwindow* window)> tell_gui) {
        any = true;
        acts.push_back({x_, y_, buttons_, std::move(tell_gui)});
    }

    double x_ = 0.0;
    double y_ = 0.0;
    std::array<bool, 3> buttons_{};
};

/// Dear ImGui in a window.
class Gui {
  public:
    /// `scale` in place of what the window's screen asks for.
    Gui(GLFWwindow* window, std::optional<double> scale) : window_(window), wanted_(scale) {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;  // it leaves no file where it is started
        ImGui::StyleColorsDark();
        ImGui::GetStyle().WindowRounding = 4.0f;
        style_ = ImGui::GetStyle();
        constexpr bool kSetsCallbacks = false;
        ImGui_ImplGlfw_InitForOpenGL(window, kSetsCallbacks);
        ImGui_ImplOpenGL3_Init("#version 410");
    }
    ~Gui() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Makes letters, controls and spaces as large as the screen asks for that the window is on
    /// now, the letters of as many pixels as they are shown with. Between frames. Returns the
    /// scale, if it is another one than before.
    std::optional<double> fit_screen() {
        float scale = 1.0f, ignored = 1.0f;
        glfwGetWindowContentScale(window_, &scale, &ignored);
        scale = std::isfinite(scale) ? std::clamp(scale, kLeastScale, kLargestScale) : 1.0f;
        if (wanted_) scale = static_cast<float>(*wanted_);
        const float unit = pixels_of_unit();
        if (scale == scale_ && unit == unit_) return std::nullopt;
        scale_ = scale;
        unit_ = unit;
        ImGui::GetStyle() = style_;
        ImGui::GetStyle().ScaleAllSizes(scale / unit);
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
        return scale;
    }

    /// At an act of the hand, or as everything is now.
    static void begin(GLFWwindow* window, const HandAct* act = nullptr) {
        ImGui_ImplOpenGL3_NewFrame();
        if (act != nullptr) act->tell_gui(window);
        ImGui_ImplGlfw_NewFrame();
        if (act != nullptr) {
            ImGuiIO& io = ImGui::GetIO();
            io.MousePos = {static_cast<float>(act->x), static_cast<float>(act->y)};
            std::ranges::copy(act->buttons, io.MouseDown);
        }
        ImGui::NewFrame();
    }
    static void end() {
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }

  private:
    /// Where a window's coordinates are no pixels, as on Wayland and macOS, a part of the scale is
    /// theirs. In quarters: the two sizes are asked for one after the other.
    float pixels_of_unit() const {
        int units = 0, pixels = 0, ignored = 0;
        glfwGetWindowSize(window_, &units, &ignored);
        glfwGetFramebufferSize(window_, &pixels, &ignored);
        if (units < 1 || pixels < 1) return unit_;
        const float quarters =
            std::round(4.0f * static_cast<float>(pixels) / static_cast<float>(units));
        return std::max(quarters, 1.0f) / 4.0f;
    }

    GLFWwindow* window_;
    const std::optional<double> wanted_;
    ImGuiStyle style_;  // at scale 1
    float scale_ = 0.0f;
    float unit_ = 1.0f;
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
    Preview(const PreviewOptions& options, const Sea& sea, const SeaArgument& source,
            const Context& context, GLFWwindow* window, Events& events, Gui& gui)
        : options_(options),
          context_(context),
          source_(source),
          stem_(stem_of(source.source)),
          window_(window),
          events_(events),
          gui_(gui),
          info_(gl::context_info()),
          backend_(preview_backend(options.backend).value_or(best_backend(info_))),
          renderer_(live(renderer_for(options, info_))),
          sea_(sea, {.threads = context.options.threads,
                     .computing = [this](const Sea& of) { return computing(of); }}),
          camera_(options.camera) {
        sea_.after_set = [this](const std::string& name, const std::string& value) {
            if (link_) link_->tell(name, value);
        };
        sea_.after_open = [this] {
            if (link_) link_->tell_values(sea_, true);
        };
        sea_.near_detail = options.detail && !info_.software;  // half as much again for its water
        state_.bridge.host = options.host;
        state_.bridge.is_own = !options.bridge;
        if (options.bridge) join(*options.bridge);
        if (options.serve) serve();
        if (options.time) sea_.go_to(*options.time);
        if (options.frame) sea_.go_to(sea.time_of(*options.frame));
        kept_take_ = write_take(sea.take);
        state_.look = options.look;
        state_.view = options.view;
        state_.cascade = options.cascade.value_or(-1);
        state_.wireframe = options.wireframe;
        state_.drawn_by = info_.renderer;
        if (info_.software) state_.drawn_by += "\na processor: fewer pixels, smaller maps";
        for (const Backend& backend : preview_backends()) {
            state_.backends.push_back({std::string(backend.name), "", 0.0});
        }
    }

    void run() {
        auto before = Clock::now();
        while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
            wait_for_something();
            const double seconds = std::min(0.25, milliseconds_since(before) / 1000.0);
            before = Clock::now();
            if (!guarded([&] { sea_.advance(seconds); })) sea_.paused = true;
            if (step(seconds)) frames_to_draw_ = 3;
            if (link_ && link_->apply(sea_)) frames_to_draw_ = 3;
            if (frames_to_draw_ > 0 || !sea_.paused || sea_.fading()) draw();
            if (frames_to_draw_ > 0) --frames_to_draw_;
            if (!std::exchange(began_, true)) context_.console.note("the window is open");
            events_.forget();
        }
        // What was recorded is dear, and was not to be lost with the window.
        const std::string take = write_take(sea_.sea().take);
        if (!take.empty() && take != kept_take_) save_sea();
    }

  private:
    static preview::RendererOptions live(preview::RendererOptions options) {
        options.live = true;
        return options;
    }

    /// By the chosen backend, or where that cannot, as a grid that has grown is too large for it,
    /// by the best that can.
    Computing computing(const Sea& of) {
        if (const std::string reason = why_not(backend_, of, info_); !reason.empty()) {
            state_.message = std::string(backend_.name) + " " + reason;
            backend_ = best_backend(info_);
        }
        return computing_for(backend_, options_, of, info_);
    }

    /// While the sea stands still nothing is done but what a person wants.
    void wait_for_something() {
        const bool iconified = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0;
        bool still = sea_.paused && !sea_.fading() && frames_to_draw_ == 0;
        const preview::Pending pending = std::max(renderer_.pending(), sea_.pending());
        if (still && pending == preview::Pending::ready) {
            frames_to_draw_ = 1;
            still = false;
        }
        tell_rest(still && pending == preview::Pending::nothing);
        if (iconified || still) {
            // A gamepad tells of nothing: it is asked.
            // Nor does a bridge.
            // Nor do textures that another thread makes.
            const bool listens = (gamepad_.is_there() && !iconified) || link_ ||
                                 pending == preview::Pending::in_work;
            glfwWaitEventsTimeout(listens ? 0.03 : 0.25);
        } else {
            glfwPollEvents();
        }
        if (events_.any) frames_to_draw_ = 3;  // what is under the mouse is known a frame late
    }

    /// For scripts: all that a hand has done is shown, and nothing moves until it does more.
    void tell_rest(bool rests) {
        if (rests && !rests_) context_.console.note("at rest: " + events_.text(window_));
        rests_ = rests;
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
        const bool shift = glfwGetKey(window_, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS;
        on(GLFW_KEY_F12, [&] { picture_asked_ = shift ? ".exr" : ".png"; });
        if (!io.WantTextInput) {
            on(GLFW_KEY_ESCAPE, [&] {
                // A list that is open is what is meant.
                if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
                    glfwSetWindowShouldClose(window_, GLFW_TRUE);
                }
            });
            on(GLFW_KEY_SPACE, [&] { sea_.paused = !sea_.paused; });
            on(GLFW_KEY_TAB, [&] { state_.shown = !state_.shown; });
            on(GLFW_KEY_F, [&] { state_.wireframe = !state_.wireframe; });
            on(GLFW_KEY_P, [&] { state_.probing = !state_.probing; });
            on(GLFW_KEY_V, [&] { next_view(); });
            on(GLFW_KEY_C, [&] { next_camera(); });
            on(GLFW_KEY_R,
               [&] { with_ctrl(GLFW_KEY_R) ? reload() : toggle_recording(sea_, state_); });
            if (with_ctrl(GLFW_KEY_Z)) {
                guarded([&] { undo(sea_, state_); });
                acted = true;
            }
            input.ahead = axis(GLFW_KEY_W, GLFW_KEY_S);
            input.right = axis(GLFW_KEY_D, GLFW_KEY_A);
            input.up = axis(GLFW_KEY_E, GLFW_KEY_Q);
            input.fast = shift;
        }
        double x = 0.0, y = 0.0;
        glfwGetCursorPos(window_, &x, &y);
        if (!io.WantCaptureMouse) {
            if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
                const double degrees = camera_.camera().field_of_view / std::max(1, width_);
                input.turn_left = degrees * (x - mouse_x_);
                input.turn_up = degrees * (y - mouse_y_);
            }
            input.closer = events_.wheel;
        }
        mouse_x_ = x;
        mouse_y_ = y;
        gamepad_.read();
        gamepad_.add_to(input, seconds);
        const auto pushed = [&](Gamepad::Button button, auto&& act) {
            if (!gamepad_.pressed(button)) return;
            act();
            acted = true;
        };
        pushed(Gamepad::pause, [&] { sea_.paused = !sea_.paused; });
        pushed(Gamepad::camera, [&] { next_camera(); });
        pushed(Gamepad::view, [&] { next_view(); });
        pushed(Gamepad::reset, [&] { camera_.reset(options_.camera); });
        const bool moves = input.ahead != 0.0 || input.right != 0.0 || input.up != 0.0 ||
                           input.turn_left != 0.0 || input.turn_up != 0.0 || input.closer != 0.0;
        const bool rides = camera_.mode == CameraMode::walk || camera_.mode == CameraMode::floating;
        if (moves || (rides && !sea_.paused) || acted) {
            guarded([&] { camera_.step(input, seconds, sea_.ocean(), sea_.time()); });
        }
        return moves || acted;
    }

    bool with_ctrl(int key) const {
        return std::ranges::find(events_.with_ctrl, key) != events_.with_ctrl.end();
    }

    void next_view() {
        const std::vector<std::string> views = all_view_names();
        const auto at = std::ranges::find(views, state_.view) - views.begin();
        state_.view = views[static_cast<std::size_t>(at + 1) % views.size()];
    }

    void next_camera() {
        camera_.mode = static_cast<CameraMode>((static_cast<int>(camera_.mode) + 1) % 4);
    }

    void draw() {
        glfwGetFramebufferSize(window_, &width_, &height_);
        if (width_ == 0 || height_ == 0) return;  // an icon
        if (const auto scale = gui_.fit_screen()) {
            context_.console.note(format_text("the panel has scale %g", *scale));
            frames_to_draw_ = 3;  // what is where is known a frame late
        }
        if (!guarded([&] { sea_timer_.measure([&] { shown_ = sea_.show(); }); })) {
            sea_.paused = true;
        }
        state_.times.sea = sea_timer_.milliseconds();
        list_backends();
        state_.cascades = static_cast<int>(cascade_divisors(sea_.ocean().parameters().grid).size());
        if (state_.cascade >= state_.cascades) state_.cascade = -1;  // of another sea

        draw_timer_.measure([&] { draw_sea(); });
        state_.times.draw = draw_timer_.milliseconds();

        const auto start = Clock::now();
        guarded([&] { look_under_mouse(); });
        // Frames may be slow, and a hand is not: each thing that it did is done where it did it.
        for (const HandAct& act : std::exchange(events_.acts, {})) {
            Gui::begin(window_, &act);
            lay_out_panel();
            ImGui::EndFrame();
            do_what_was_asked();
        }
        Gui::begin(window_);
        lay_out_panel();
        Gui::end();
        state_.times.panel = milliseconds_since(start);
        glfwSwapBuffers(window_);
        do_what_was_asked();
        const double milliseconds = milliseconds_since(std::exchange(drawn_, Clock::now()));
        if (link_) link_->tell_clock(sea_, 1000.0 / std::max(milliseconds, 0.1));
    }

    void lay_out_panel() {
        state_.touched = state_.save_sea = state_.reset_camera = false;
        state_.save_picture.clear();
        state_.reload = state_.record = false;
        state_.backend_asked.reset();
        show_stage();
        show_bridge();
        guarded([&] { draw_panel(sea_, shown_, camera_, state_); });
    }

    void join(const bridge::LineClientOptions& bridge) {
        link_.emplace(
            bridge,
            BridgeWishes{
                .record = [this](bool on, const std::string& name) { record(on, name); },
                .said =
                    [this](const std::string& line) { context_.console.note("bridge: " + line); }});
        state_.bridge.link = &*link_;
    }

    /// Starts a bridge of its own, or the one that there is anew, and joins it.
    void serve() {
        leave();
        host_.start(state_.bridge.host, sea_.sea());
        join({.server = host_.endpoint(), .token = state_.bridge.host.token});
        context_.console.note("a bridge at " + host_.endpoint().text());
    }

    void leave() {
        state_.bridge.link = nullptr;
        link_.reset();
        host_.stop();
    }

    void show_bridge() {
        state_.bridge.asked = BridgeRows::Asked::nothing;
        state_.bridge.is_running = host_.is_running();
        if (link_) host_.leave_out_clock_of(link_->own_name());
        state_.bridge.log = state_.bridge.is_own ? host_.log() : link_->log();
    }

    /// As the bridge asks: what was recorded is written when it ends.
    void record(bool on, const std::string& name) {
        if (on == sea_.recording()) return;
        toggle_recording(sea_, state_);
        if (!on) save_sea(name.substr(0, name.find('.')));
        frames_to_draw_ = 3;
    }

    void do_what_was_asked() {
        if (state_.touched) frames_to_draw_ = 3;
        if (state_.reset_camera) camera_.reset(options_.camera);
        if (state_.record) toggle_recording(sea_, state_);
        if (state_.reload) reload();
        if (state_.bridge.asked == BridgeRows::Asked::start) guarded([&] { serve(); });
        if (state_.bridge.asked == BridgeRows::Asked::stop) leave();
        if (state_.backend_asked) {
            backend_ = preview_backend(*state_.backend_asked).value_or(backend_);
            guarded([&] {
                sea_.compute_anew();
                context_.console.note("the sea by " + std::string(sea_.computing().backend.name));
            });
        }
        if (state_.save_sea) save_sea();
        if (!state_.save_picture.empty()) save_picture(state_.save_picture);
        if (!picture_asked_.empty()) save_picture(std::exchange(picture_asked_, ""));
    }

    /// What can compute the sea, and what it takes; a moment after it was chosen, when shaders are
    /// compiled and memory is there.
    void list_backends() {
        const std::string now(sea_.computing().backend.name);
        frames_of_backend_ = now == state_.backend ? frames_of_backend_ + 1 : 0;
        state_.backend = now;
        const std::span<const Backend> all = preview_backends();
        for (std::size_t i = 0; i < all.size(); ++i) {
            BackendRow& row = state_.backends[i];
            row.why_not = why_not(all[i], sea_.sea(), info_);
            if (row.name == now && frames_of_backend_ > 2 && !sea_.fading()) {
                row.milliseconds = state_.times.sea;
            }
        }
    }

    void draw_sea() {
        const int width = std::max(16, static_cast<int>(std::lround(width_ * scale_)));
        const int height = std::max(16, static_cast<int>(std::lround(height_ * scale_)));
        if (!canvas_ || width != canvas_width_ || height != canvas_height_) {
            canvas_ = std::make_unique<preview::Canvas>(width, height, GL_RGBA8,
                                                        live_samples(options_, info_));
            canvas_width_ = width;
            canvas_height_ = height;
        }
        if (is_stage_picture(state_.view)) return draw_stage();
        canvas_->bind();
        renderer_.draw(shown_, camera_.camera(), state_.look, draw_options());
        canvas_->copy_to_window(width_, height_);
    }

    preview::DrawOptions draw_options() const {
        preview::DrawOptions options;
        options.width = canvas_width_;
        options.height = canvas_height_;
        options.view = preview::view_of(state_.view);
        options.wireframe = state_.wireframe;
        options.cascade = state_.cascade;
        return options;
    }

    /// A stage of the transform, as large as the window lets it be.
    void draw_stage() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        const std::string view = state_.view;
        if (!guarded([&] {
                stage_ =
                    make_stage_picture(stages_, sea_.ocean(), sea_.time(),
                                       static_cast<std::size_t>(std::max(0, state_.cascade)), view);
            })) {
            state_.view = "shaded";
            return;
        }
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        if (!stage_texture_) stage_texture_ = gl::Texture(make_name());
        glBindTexture(GL_TEXTURE_2D, stage_texture_.name());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, stage_.width, stage_.height, 0, GL_RGB,
                     GL_UNSIGNED_BYTE, stage_.rgb.data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    }

    static GLuint make_name() {
        GLuint name = 0;
        glGenTextures(1, &name);
        return name;
    }

    /// A square beside the panel, of the butterfly too, which is a few pixels wide.
    void show_stage() {
        if (!is_stage_picture(state_.view) || !stage_texture_) return;
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        const float left = state_.shown ? std::min(panel_length(kPanelWidth), 0.5f * size.x) : 0.0f;
        const float side = std::min(size.x - left, size.y);
        const ImVec2 low{left + 0.5f * (size.x - left - side), 0.5f * (size.y - side)};
        ImGui::GetBackgroundDrawList()->AddImage(
            reinterpret_cast<void*>(static_cast<std::uintptr_t>(stage_texture_.name())), low,
            {low.x + side, low.y + side}, {0.0f, 1.0f}, {1.0f, 0.0f});
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
            sea_.ocean().query(sea_.time(), {&point, 1}, {&sample, 1}, {.foam = false});
            const auto nearer =
                camera_.camera().meet_level(mouse_x_ / width, mouse_y_ / height,
                                            static_cast<double>(width) / height, sample.height);
            if (!nearer) return;
            point = {(*nearer)[0], (*nearer)[1]};
        }
        const auto drawn =
            preview::probe(renderer_, shown_, camera_.camera(), {point.x, point.y}, state_.cascade);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, width_, height_);
        state_.under_mouse =
            format_text("x %.2f  y %.2f  height %.2f m\nnormal %.2f %.2f %.2f\nfoam %.2f", point.x,
                        point.y, sample.height, sample.normal[0], sample.normal[1],
                        sample.normal[2], drawn ? drawn->cover : 0.0);
    }

    /// Under a name that is free, if possible the one that was asked for.
    void save_sea(const std::string& asked = "") {
        write([&] {
            std::string name = asked + ".toml";
            if (asked.empty()) {
                const char* what = sea_.sea().take.empty() ? "-changed" : "-performed";
                name = free_name(stem_ + what, ".toml");
            } else if (std::filesystem::exists(utf8_path(name))) {
                name = free_name(asked, ".toml");
            }
            io::write_file_atomically(name, write_sea(sea_.sea()));
            kept_take_ = write_take(sea_.sea().take);
            return name;
        });
    }

    /// What is shown, as .png or .exr.
    void save_picture(const std::string& ending) {
        write([&] {
            if (is_stage_picture(state_.view)) {
                const std::string name = free_name(stem_, ".png");
                io::write_png(name, stage_.width, stage_.height, stage_.rgb);
                return name;
            }
            const std::string name = free_name(stem_, ending);
            write_picture(name, renderer_, shown_, camera_.camera(), state_.look, draw_options(),
                          options_.samples.value_or(kSamples));
            return name;
        });
    }

    template <typename Write>
    void write(Write&& write) {
        guarded([&] {
            state_.message = "written: " + write();
            context_.console.note(state_.message);
        });
        frames_to_draw_ = 3;
    }

    /// The sea file as it is now; the one that is shown stays where that is not there or is bad.
    void reload() {
        open([&] { return open_sea(source_); });
    }

    template <typename Open>
    void open(Open&& open) {
        guarded([&] {
            Sea before = sea_.sea();
            sea_.open(open());
            kept_take_ = write_take(sea_.sea().take);
            state_.changes.push_back({"the sea", "what it was", std::move(before)});
            state_.message = "opened: " + source_.source;
        });
        frames_to_draw_ = 3;
    }

    /// Whether it was done; why not is said in the window.
    template <typename Work>
    bool guarded(Work&& work) {
        try {
            work();
            return true;
        } catch (const Error& error) {
            state_.message = error.what();
            return false;
        }
    }

    const PreviewOptions& options_;
    const Context& context_;
    SeaArgument source_;
    std::string stem_;
    std::string kept_take_;  // in a file
    GLFWwindow* window_;
    Events& events_;
    Gui& gui_;
    gl::ContextInfo info_;
    Backend backend_;  // chosen
    PanelState state_;
    preview::Renderer renderer_;
    LiveSea sea_;
    preview::ShownSea shown_;
    CameraControl camera_;
    Gamepad gamepad_;
    BridgeHost host_;
    std::optional<BridgeLink> link_;
    Clock::time_point drawn_ = Clock::now();
    StageTimer sea_timer_, draw_timer_;
    gl::StageMaker stages_;
    StagePicture stage_;
    gl::Texture stage_texture_;
    std::unique_ptr<preview::Canvas> canvas_;
    int canvas_width_ = 0, canvas_height_ = 0;
    int width_ = 0, height_ = 0;
    double mouse_x_ = 0.0, mouse_y_ = 0.0;
    double scale_ = pixel_scale(info_);
    int frames_to_draw_ = 3;
    bool began_ = false, rests_ = false;
    int frames_of_backend_ = 0;
    std::string picture_asked_;  // ".png" or ".exr", of what is drawn next
};

}  // namespace

void run_window(const PreviewOptions& options, const Sea& sea, const SeaArgument& source,
                const Context& context) {
    const Windows windows;
    const Window window = open_window(options, "ocean-preview: " + source.source);
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    Events events;
    events.listen_to(window.get());
    Gui gui(window.get(), options.scale);
    Preview preview(options, sea, source, context, window.get(), events, gui);
    preview.run();
}

}  // namespace ocean::app
