// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The map of the water that foam hides, foam^power, with mipmaps: see DrawnCover.
#pragma once

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/gl/shader_program.hpp"

namespace ocean::preview {

class CoverMap {
  public:
    CoverMap();

    /// Makes the map from a texture of foam of `resolution` texels along a side, each multiplied by
    /// `fade`.
    void make(unsigned foam, int resolution, float fade, double power);

    unsigned texture() const { return map_.name(); }
    int resolution() const { return resolution_; }

  private:
    gl::ShaderProgram program_;
    gl::VertexArray no_vertices_;
    gl::Framebuffer framebuffer_;
    gl::Texture map_;
    int resolution_ = 0;
};

}  // namespace ocean::preview
