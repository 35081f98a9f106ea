// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The properties of the current context.
#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"

namespace ocean::gl {

namespace {

std::string text_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

int integer_of(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

bool is_software(const std::string& renderer) {
    constexpr std::array<std::string_view, 5> kNames = {"llvmpipe", "softpipe", "swrast",
                                                        "SwiftShader", "lavapipe"};
    return std::ranges::any_of(
        kNames, [&](std::string_view name) { return renderer.find(name) != std::string::npos; });
}

}  // namespace

std::string ContextInfo::text() const {
    return renderer + " (" + vendor + "), OpenGL " + version;
}

bool has_current_context() {
    if (epoxy_has_egl() && eglGetCurrentContext() != EGL_NO_CONTEXT) return true;
    // Whoever has a context of GLX has its library, but perhaps for himself alone, as GLFW has.
    for (const char* name : {"libGLX.so.0", "libGL.so.1"}) {
        void* library = dlopen(name, RTLD_LAZY | RTLD_NOLOAD);
        if (library == nullptr) continue;
        using GetContext = void* (*)();
        const auto get = reinterpret_cast<GetContext>(dlsym(library, "glXGetCurrentContext"));
        const bool current = get != nullptr && get() != nullptr;
        dlclose(library);
        if (current) return true;
    }
    return false;
}

ContextInfo context_info() {
    if (!has_current_context()) {
        throw Error(ErrorKind::no_gpu, "no context of OpenGL is current on this thread");
    }
    ContextInfo info;
    info.vendor = text_of(GL_VENDOR);
    info.renderer = text_of(GL_RENDERER);
    info.version = text_of(GL_VERSION);
    info.software = is_software(info.renderer);
    info.major = integer_of(GL_MAJOR_VERSION);
    info.minor = integer_of(GL_MINOR_VERSION);
    const bool computes = info.major * 10 + info.minor >= 43;
    info.texture_size = integer_of(GL_MAX_TEXTURE_SIZE);
    if (!computes) return info;
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    info.storage_block_bytes = bytes;
    info.storage_blocks = integer_of(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
    info.shared_bytes = integer_of(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE);
    info.workgroup_threads = integer_of(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS);
    info.image_units = integer_of(GL_MAX_COMPUTE_IMAGE_UNIFORMS);
    info.reports_resets =
        info.major * 10 + info.minor >= 45 || epoxy_has_gl_extension("GL_KHR_robustness");
    return info;
}

}  // namespace ocean::gl
