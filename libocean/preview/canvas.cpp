// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/preview/canvas.hpp"

#include <algorithm>

#include "ocean/error.hpp"

namespace ocean::preview {
namespace {

gl::Renderbuffer renderbuffer(GLenum format, int width, int height, int samples) {
    gl::Renderbuffer made = gl::make_renderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, made.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width,
                                     height);
    return made;
}

int possible_samples(int requested) {
    GLint max = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &max);
    return std::min(requested, max);
}

}  // namespace

Canvas::Canvas(int width, int height, GLenum format, int samples)
    : width_(width),
      height_(height),
      samples_(possible_samples(samples)),
      colour_(renderbuffer(format, width, height, samples_)),
      depth_(renderbuffer(GL_DEPTH_COMPONENT32F, width, height, samples_)),
      framebuffer_(gl::make_framebuffer()) {
    if (samples_ > 1) means_ = std::make_unique<Canvas>(width, height, format);
    bind();
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              colour_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(ErrorKind::no_gpu, "the driver cannot make a picture of " +
                                           std::to_string(width) + "x" + std::to_string(height) +
                                           " pixels");
    }
}

void Canvas::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
}

void Canvas::bind_to_read() const {
    if (means_) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, means_->framebuffer_.name());
        glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    }
    const Canvas& read = means_ ? *means_ : *this;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, read.framebuffer_.name());
}

void Canvas::copy_to_window(int width, int height) const {
    bind_to_read();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
}

std::vector<std::uint8_t> Canvas::rgb() const {
    std::vector<std::uint8_t> pixels(3 * static_cast<std::size_t>(width_) *
                                     static_cast<std::size_t>(height_));
    bind_to_read();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

std::vector<float> Canvas::rgba() const {
    std::vector<float> pixels(4 * static_cast<std::size_t>(width_) *
                              static_cast<std::size_t>(height_));
    bind_to_read();
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

}  // namespace ocean::preview
