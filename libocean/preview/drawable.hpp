// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A part of the scene that stands in front of the sky: the water, and what Renderer::add is given.
// All drawables of a picture share its uniform block and its depth, so that they hide each other.
#pragma once

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/gl/shader_program.hpp"
#include "ocean/internal/preview/renderer.hpp"
#include "projection.hpp"

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

/// A uniform block of shaders/preview and the buffer that holds its values.
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

/// One picture, as a drawable sees it.
struct PictureFrame {
    const Camera& camera;
    const Look& look;
    const DrawOptions& options;
    const Projection& projection;

    /// Texture unit of the sky's map, sky_map of shaders/preview/sky.glsl. A drawable binds its own
    /// textures to the units above.
    static constexpr GLint kSkyUnit = 0;

    /// Makes a program read the picture's values (preview/frame.glsl) and its sky.
    static void attach(GLuint program) {
        attach_block(program, "FrameBlock", BlockBinding::frame);
        const GLint sky = glGetUniformLocation(program, "sky_map");
        if (sky >= 0) glProgramUniform1i(program, sky, kSkyUnit);
    }
};

class Drawable {
  public:
    Drawable() = default;
    virtual ~Drawable() = default;
    Drawable(const Drawable&) = delete;
    Drawable& operator=(const Drawable&) = delete;

    /// Returns the distance from the eye beyond which it draws nothing [m]. The scale of the
    /// picture's depth follows from the farthest drawable.
    virtual double farthest(const PictureFrame& frame) const = 0;

    /// Draws into the current framebuffer with the depth of preview/on_screen.glsl. The depth test
    /// is on, blending and culling are off; leaves them so, and no sampler bound to a unit. Throws
    /// Error.
    virtual void draw(const PictureFrame& frame) = 0;
};

}  // namespace ocean::preview
