// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The texture units of a program, given out one after another, and samplers of footprints.
#pragma once

#include <string>

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/gl/shader_program.hpp"
#include "ocean/internal/preview/renderer.hpp"

namespace ocean::preview {

/// Returns the samples along a footprint; 0: the driver's anisotropic filter fits it.
int filter_taps(const RendererOptions& options);
/// Returns a sampler through all mipmaps for these taps.
gl::Sampler make_footprint_sampler(int taps);

class TextureUnits {
  public:
    /// first: the units below it are the picture's.
    explicit TextureUnits(GLint first) : first_(first), next_(first) {}
    /// Unbinds the samplers.
    ~TextureUnits() {
        for (GLint unit = first_; unit < next_; ++unit) glBindSampler(static_cast<GLuint>(unit), 0);
        glActiveTexture(GL_TEXTURE0);
    }
    TextureUnits(const TextureUnits&) = delete;
    TextureUnits& operator=(const TextureUnits&) = delete;

    /// Binds a texture to the next unit and the uniform `name` of the current program to that unit.
    /// sampler: 0 for the texture's own filter.
    void bind(gl::ShaderProgram& program, const std::string& name, GLenum target, GLuint texture,
              GLuint sampler = 0) {
        program.set(name.c_str(), next_);
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(next_));
        glBindTexture(target, texture);
        glBindSampler(static_cast<GLuint>(next_), sampler);
        ++next_;
    }

  private:
    GLint first_;
    GLint next_;
};

}  // namespace ocean::preview
