// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pixels without a window.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <vector>

#include "ocean/gl/objects.hpp"

namespace ocean::preview {

/// Colour and depth to draw into. GL_RGBA8 for pictures, GL_RGBA32F for numbers.
class Canvas {
  public:
    Canvas(int width, int height, GLenum format);

    void bind() const;
    /// Into the window's own framebuffer, which has that size; leaves it bound.
    void copy_to_window(int width, int height) const;
    std::vector<std::uint8_t> rgb() const;
    std::vector<float> rgba() const;

  private:
    int width_;
    int height_;
    gl::Renderbuffer colour_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
};

}  // namespace ocean::preview
