// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A uniform block of shaders/preview and the buffer that holds its values.
#pragma once

#include "ocean/internal/gl/objects.hpp"

namespace ocean::preview {

/// The bindings of the blocks. A drawable with a block of its own adds a binding here.
enum class BlockBinding : GLuint { frame, water, land, coast };

/// Makes a program read a block by its binding; a program without the block is left as it is.
inline void attach_block(GLuint program, const char* name, BlockBinding binding) {
    const GLuint index = glGetUniformBlockIndex(program, name);
    if (index != GL_INVALID_INDEX) {
        glUniformBlockBinding(program, index, static_cast<GLuint>(binding));
    }
}

template <typename Values>
class UniformBlock {
  public:
    explicit UniformBlock(BlockBinding binding) : binding_(binding), buffer_(gl::make_buffer()) {
        glBindBuffer(GL_UNIFORM_BUFFER, buffer_.name());
        glBufferData(GL_UNIFORM_BUFFER, sizeof(Values), nullptr, GL_DYNAMIC_DRAW);
    }

    /// Uploads the values and binds them for all programs that are attached.
    void set(const Values& values) const {
        glBindBuffer(GL_UNIFORM_BUFFER, buffer_.name());
        glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(Values), &values);
        glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding_), buffer_.name());
    }

  private:
    BlockBinding binding_;
    gl::Buffer buffer_;
};

}  // namespace ocean::preview
