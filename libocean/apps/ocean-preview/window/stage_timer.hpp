// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The cost of a part of a frame, measured without waiting for the GPU.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <chrono>
#include <cstddef>

#include "ocean/internal/gl/objects.hpp"

namespace ocean::app {

/// The OpenGL context of the constructor must be current in every call. OpenGL 3.3.
class StageTimer {
  public:
    StageTimer() {
        for (Round& round : rounds_) {
            for (gl::Query& query : round) query = gl::make_query();
        }
    }

    template <typename Work>
    void measure(Work&& work) {
        const auto start = std::chrono::steady_clock::now();
        Round& round = rounds_[frame_ % rounds_.size()];
        if (frame_ >= rounds_.size()) read(round);
        glQueryCounter(round[0].name(), GL_TIMESTAMP);
        work();
        glQueryCounter(round[1].name(), GL_TIMESTAMP);
        ++frame_;
        const std::chrono::duration<double, std::milli> taken =
            std::chrono::steady_clock::now() - start;
        processor_ = taken.count();
    }

    /// Returns the time of the last frame on the processor, or that of the last known frame on the
    /// GPU if it is longer [ms].
    double milliseconds() const { return processor_ > gpu_ ? processor_ : gpu_; }

  private:
    using Round = std::array<gl::Query, 2>;

    /// Reads times of four frames ago; if they are not available yet, the earlier ones stay.
    void read(const Round& round) {
        GLint available = 0;
        glGetQueryObjectiv(round[1].name(), GL_QUERY_RESULT_AVAILABLE, &available);
        if (available == 0) return;
        GLuint64 from = 0, to = 0;
        glGetQueryObjectui64v(round[0].name(), GL_QUERY_RESULT, &from);
        glGetQueryObjectui64v(round[1].name(), GL_QUERY_RESULT, &to);
        gpu_ = to > from ? 1e-6 * static_cast<double>(to - from) : 0.0;
    }

    std::array<Round, 4> rounds_;
    std::size_t frame_ = 0;
    double processor_ = 0.0;
    double gpu_ = 0.0;
};

}  // namespace ocean::app
