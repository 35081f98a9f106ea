// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pixels without a window.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "ocean/gl/objects.hpp"

namespace ocean::preview {

/// Colour and depth to draw into. GL_RGBA8 for pictures, GL_RGBA32F for light and numbers. Of more
/// samples than one, as many as the driver has, a pixel is their mean when it is read or copied.
class Canvas {
  public:
    /// Throws Error no_gpu.
    Canvas(int width, int height, GLenum format, int samples = 1);

    void bind() const;
    /// Of a pixel, as many as the driver has of those that were asked for.
    int samples() const { return samples_; }
    /// Into the window's own framebuffer, which has that size; leaves it bound.
    void copy_to_window(int width, int height) const;
    std::vector<std::uint8_t> rgb() const;
    std::vector<float> rgba() const;

  private:
    void bind_to_read() const;

    int width_;
    int height_;
    int samples_;
    gl::Renderbuffer colour_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
    std::unique_ptr<Canvas> means_;  // of the samples of each pixel
};

}  // namespace ocean::preview
