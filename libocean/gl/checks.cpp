// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors of OpenGL as errors of ours.
#include "checks.hpp"

#include <epoxy/gl.h>

#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::gl {

namespace {

[[noreturn]] void report_reset(const char* doing) {
    throw Error(ErrorKind::no_gpu, std::string("the GPU was reset or taken away while ") + doing +
                                       "; finished outputs are complete");
}

}  // namespace

void require_no_error(const char* doing) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    // A lost context may report its loss for ever.
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
    if (error == GL_OUT_OF_MEMORY) {
        throw Error(ErrorKind::out_of_memory,
                    std::string("the GPU has no memory left for ") + doing);
    }
    if (error == GL_CONTEXT_LOST) report_reset(doing);
    throw Error(ErrorKind::no_gpu, format_text("OpenGL error 0x%04X while %s", error, doing));
}

void require_not_reset(const ContextInfo& context, const char* doing) {
    if (context.reports_resets && glGetGraphicsResetStatus() != GL_NO_ERROR) report_reset(doing);
}

}  // namespace ocean::gl
