// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a part of a frame costs, without waiting for the GPU.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <chrono>
#include <cstddef>

#include "ocean/gl/objects.hpp"

namespace ocean::app {

/// Needs the context in which it was made. OpenGL 3.3.
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

    /// Milliseconds of the last frame of the processor, or, if that is more, of the frame on the
    /// GPU that is known last.
    double milliseconds() const { return processor_ > gpu_ ? processor_ : gpu_; }

  private:
    using Round = std::array<gl::Query, 2>;

    /// Four frames later they are there; if not, the one before counts.
    void read(const Round& round) {
        GLint there = 0;
        glGetQueryObjectiv(round[1].name(), GL_QUERY_RESULT_AVAILABLE, &there);
        if (there == 0) return;
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
