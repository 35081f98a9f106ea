// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pixels without a window.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "ocean/internal/gl/objects.hpp"

namespace ocean::preview {

/// A framebuffer with colour and depth: GL_RGBA8 for pictures, GL_RGBA32F for light and numbers. A
/// pixel with several samples is read and copied as their mean.
class Canvas {
  public:
    /// samples: per pixel, up to the driver's limit. Throws Error no_gpu.
    Canvas(int width, int height, GLenum format, int samples = 1);

    void bind() const;
    /// Returns the samples of a pixel: the requested number or the driver's limit.
    int samples() const { return samples_; }
    /// Copies the picture into the window's framebuffer, which has that size [pixels] and is bound
    /// afterwards.
    void copy_to_window(int width, int height) const;
    /// Returns the pixels, the bottom row first.
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
    std::unique_ptr<Canvas> means_;  // the mean of each pixel's samples
};

}  // namespace ocean::preview
