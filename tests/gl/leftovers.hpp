// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Leftovers after a test: objects of the current context, and memory of the process.
#pragma once

#include <epoxy/gl.h>
#include <malloc.h>

#include <fstream>

namespace ocean::test {

inline int count_objects() {
    int count = 0;
    for (GLuint name = 1; name < 4096; ++name) {
        count += glIsBuffer(name) + glIsTexture(name) + glIsProgram(name) + glIsShader(name) +
                 glIsFramebuffer(name) + glIsRenderbuffer(name) + glIsVertexArray(name) +
                 glIsSampler(name);
    }
    return count;
}

/// Returns the resident memory of this process, without freed blocks that malloc keeps (6 MB or
/// none).
inline double resident_megabytes() {
    malloc_trim(0);
    std::ifstream statm("/proc/self/statm");
    double all = 0.0;
    double resident = 0.0;
    statm >> all >> resident;
    return resident * 4096.0 / 1e6;
}

}  // namespace ocean::test
