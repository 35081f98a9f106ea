// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenGL objects, deleted by their owner's destructor while their context is current.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace ocean::gl {

template <void (*kDelete)(GLuint)>
class Object {
  public:
    Object() = default;
    explicit Object(GLuint name) : name_(name) {}
    ~Object() {
        if (name_ != 0) kDelete(name_);
    }
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    GLuint name_ = 0;
};

template <auto kDelete>
void delete_one(GLuint name) {
    (*kDelete)(1, &name);
}
inline void delete_program(GLuint name) {
    glDeleteProgram(name);
}
inline void delete_shader(GLuint name) {
    glDeleteShader(name);
}

using Buffer = Object<delete_one<&glDeleteBuffers>>;
using Texture = Object<delete_one<&glDeleteTextures>>;
using Program = Object<delete_program>;
using Shader = Object<delete_shader>;
using VertexArray = Object<delete_one<&glDeleteVertexArrays>>;
using Sampler = Object<delete_one<&glDeleteSamplers>>;
using Framebuffer = Object<delete_one<&glDeleteFramebuffers>>;
using Renderbuffer = Object<delete_one<&glDeleteRenderbuffers>>;
using Query = Object<delete_one<&glDeleteQueries>>;

template <typename Made, auto kGenerate>
Made generate() {
    GLuint name = 0;
    (*kGenerate)(1, &name);
    return Made(name);
}
inline Buffer make_buffer() {
    return generate<Buffer, &glGenBuffers>();
}
inline VertexArray make_vertex_array() {
    return generate<VertexArray, &glGenVertexArrays>();
}
inline Framebuffer make_framebuffer() {
    return generate<Framebuffer, &glGenFramebuffers>();
}
inline Renderbuffer make_renderbuffer() {
    return generate<Renderbuffer, &glGenRenderbuffers>();
}
inline Query make_query() {
    return generate<Query, &glGenQueries>();
}

}  // namespace ocean::gl
