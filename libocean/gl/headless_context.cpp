// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Contexts through EGL; see ocean/internal/gl/context.hpp.
#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <initializer_list>

#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/text.hpp"
#include "self_check.hpp"

namespace ocean::gl {

namespace {

std::atomic<int> chosen_device = -1;

[[noreturn]] void refuse(const std::string& message) {
    throw Error(ErrorKind::no_gpu, message);
}

bool has_word(const char* words, std::string_view word) {
    if (words == nullptr) return false;
    const std::string_view all(words);
    for (std::size_t at = all.find(word); at != std::string_view::npos;
         at = all.find(word, at + 1)) {
        const bool begins = at == 0 || all[at - 1] == ' ';
        const std::size_t end = at + word.size();
        if (begins && (end == all.size() || all[end] == ' ')) return true;
    }
    return false;
}

const char* egl_error_name() {
    switch (eglGetError()) {
        case EGL_NOT_INITIALIZED:
            return "not initialized";
        case EGL_BAD_ALLOC:
            return "bad alloc";
        case EGL_BAD_MATCH:
            return "bad match";
        case EGL_BAD_CONFIG:
            return "bad config";
        case EGL_BAD_ATTRIBUTE:
            return "bad attribute";
        case EGL_BAD_DISPLAY:
            return "bad display";
        case EGL_CONTEXT_LOST:
            return "context lost";
        default:
            return "failed";
    }
}

/// Returns true if one of these libraries exists; without it, epoxy would end the process.
bool has_library(std::initializer_list<const char*> names) {
    return std::ranges::any_of(
        names, [](const char* name) { return dlopen(name, RTLD_LAZY | RTLD_LOCAL) != nullptr; });
}

std::optional<int> device_number(const HeadlessOptions& options) {
    if (options.device) return options.device;
    if (chosen_device >= 0) return chosen_device.load();
    const char* named = std::getenv("OCEAN_EGL_DEVICE");
    if (named == nullptr || *named == '\0') return std::nullopt;
    return parse_whole_number(named, "OCEAN_EGL_DEVICE", 0, 63);
}

std::vector<EGLDeviceEXT> list_devices() {
    std::array<EGLDeviceEXT, 64> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == 0) {
        return {};
    }
    return {devices.begin(), devices.begin() + count};
}

bool is_software_device(EGLDeviceEXT device) {
    return has_word(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

void GLAPIENTRY keep_message(GLenum, GLenum, GLuint, GLenum, GLsizei length, const GLchar* text,
                             const void* user) {
    auto* messages = static_cast<std::vector<std::string>*>(const_cast<void*>(user));
    messages->emplace_back(text, static_cast<std::size_t>(std::max(length, 0)));
}

}  // namespace

void use_egl_device(int device) {
    chosen_device = device;
}

struct HeadlessContext::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE;  // a pbuffer, where a context without surface is refused
    ContextInfo info;
    std::vector<std::string> messages;

    // Displays are shared by all of a process, so none is ever terminated.
    ~Impl() {
        if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    }

    /// Opens a context. Returns the failure, or nothing.
    std::string open(EGLDisplay on, const HeadlessOptions& options) {
        if (on == EGL_NO_DISPLAY || eglInitialize(on, nullptr, nullptr) == 0) {
            return egl_error_name();
        }
        display = on;
        if (eglBindAPI(EGL_OPENGL_API) == 0) return "has no desktop OpenGL";
        const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint configs = 0;
        eglChooseConfig(display, wanted, &config, 1, &configs);
        // A driver reports a reset only if that was requested; some cannot.
        for (const EGLint reset : {EGL_LOSE_CONTEXT_ON_RESET, EGL_NO_RESET_NOTIFICATION}) {
            const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                                 4,
                                                 EGL_CONTEXT_MINOR_VERSION,
                                                 options.compute ? 3 : 1,
                                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                 EGL_CONTEXT_OPENGL_DEBUG,
                                                 options.debug ? EGL_TRUE : EGL_FALSE,
                                                 EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                                 reset,
                                                 EGL_NONE};
            context = eglCreateContext(display, configs > 0 ? config : EGL_NO_CONFIG_KHR,
                                       EGL_NO_CONTEXT, context_attributes);
            if (context != EGL_NO_CONTEXT) break;
        }
        if (context == EGL_NO_CONTEXT) {
            return std::string("has no OpenGL ") + (options.compute ? "4.3" : "4.1") + " core (" +
                   egl_error_name() + ")";
        }
        if (!has_word(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
            const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface = eglCreatePbufferSurface(display, config, size);
            if (surface == EGL_NO_SURFACE) return "has neither surfaceless contexts nor pbuffers";
        }
        return {};
    }
};

HeadlessContext::HeadlessContext(const HeadlessOptions& options) {
    if (!epoxy_has_egl()) refuse("no GPU can be used: libEGL.so.1 is missing on this machine");
    if (!has_library({"libOpenGL.so.0", "libGL.so.1"})) {
        refuse("no GPU can be used: libOpenGL.so.0 and libGL.so.1 are missing on this machine");
    }
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const bool lists_devices =
        has_word(client, "EGL_EXT_platform_device") &&
        (has_word(client, "EGL_EXT_device_enumeration") || has_word(client, "EGL_EXT_device_base"));
    std::string tried;
    const auto open = [&](const std::string& what, EGLDisplay display) {
        auto parts = std::make_unique<Impl>();
        const std::string failure = parts->open(display, options);
        if (!failure.empty()) {
            tried += (tried.empty() ? "" : "; ") + what + ": " + failure;
            return false;
        }
        impl_ = std::move(parts);
        return true;
    };
    const auto open_device = [&](const std::vector<EGLDeviceEXT>& devices, std::size_t i) {
        return open("device " + std::to_string(i),
                    eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    };

    const std::vector<EGLDeviceEXT> devices =
        lists_devices ? list_devices() : std::vector<EGLDeviceEXT>();
    if (const std::optional<int> number = device_number(options)) {
        const auto i = static_cast<std::size_t>(*number);
        if (*number < 0 || i >= devices.size()) {
            refuse("EGL device " + std::to_string(*number) + ": there are " +
                   std::to_string(devices.size()) + ", numbered from 0");
        }
        open_device(devices, i);
    } else {
        for (const bool software : {false, true}) {
            for (std::size_t i = 0; i < devices.size() && !impl_; ++i) {
                if (is_software_device(devices[i]) == software) open_device(devices, i);
            }
        }
        if (!impl_ && has_word(client, "EGL_MESA_platform_surfaceless")) {
            open("surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                         EGL_DEFAULT_DISPLAY, nullptr));
        }
        if (!impl_) open("default display", eglGetDisplay(EGL_DEFAULT_DISPLAY));
    }
    if (!impl_) refuse("no GPU can be used (EGL " + tried + ")");

    const Current current(*this);
    if (options.debug) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(keep_message, &impl_->messages);
    }
    impl_->info = context_info();
    if (options.compute) check_shader_arithmetic();
}

HeadlessContext::~HeadlessContext() = default;

HeadlessContext::Current::Current(const HeadlessContext& context)
    : display_(eglGetCurrentDisplay()),
      context_(eglGetCurrentContext()),
      draw_(eglGetCurrentSurface(EGL_DRAW)),
      read_(eglGetCurrentSurface(EGL_READ)),
      own_display_(context.impl_->display) {
    const Impl& parts = *context.impl_;
    eglBindAPI(EGL_OPENGL_API);
    if (eglMakeCurrent(parts.display, parts.surface, parts.surface, parts.context) == 0) {
        refuse(std::string("the GPU's context cannot be used any more: ") + egl_error_name());
    }
}

HeadlessContext::Current::~Current() {
    if (context_ == EGL_NO_CONTEXT) {
        eglMakeCurrent(own_display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    } else {
        eglMakeCurrent(display_, draw_, read_, context_);
    }
}

const ContextInfo& HeadlessContext::info() const {
    return impl_->info;
}

const std::vector<std::string>& HeadlessContext::messages() const {
    return impl_->messages;
}

}  // namespace ocean::gl
