// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/gl/textures.hpp"

#include <bit>

namespace ocean::gl {
namespace {

int level_count(int resolution, Mipmaps mipmaps) {
    return mipmaps == Mipmaps::yes ? std::bit_width(static_cast<unsigned>(resolution)) : 1;
}

/// Allocates all levels of the bound texture, as glTexStorage2D of OpenGL 4.2 does at once.
void make_levels(GLenum format, int resolution, int levels) {
    if (epoxy_gl_version() >= 42)
        return glTexStorage2D(GL_TEXTURE_2D, levels, format, resolution, resolution);
    for (int level = 0; level < levels; ++level) {
        glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(format), resolution >> level,
                     resolution >> level, 0, GL_RED, GL_FLOAT, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
}

void make_array_levels(GLenum format, int resolution, int layers, int levels) {
    if (epoxy_gl_version() >= 42) {
        return glTexStorage3D(GL_TEXTURE_2D_ARRAY, levels, format, resolution, resolution, layers);
    }
    for (int level = 0; level < levels; ++level) {
        glTexImage3D(GL_TEXTURE_2D_ARRAY, level, static_cast<GLint>(format), resolution >> level,
                     resolution >> level, layers, 0, GL_RED, GL_FLOAT, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, levels - 1);
}

/// Sets how the bound texture is read: between texels, and through all mipmaps that it has.
void set_filter(GLenum target, Mipmaps mipmaps, Filter filter) {
    const bool levels = mipmaps == Mipmaps::yes;
    const GLint linear = levels || filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, levels ? GL_LINEAR_MIPMAP_LINEAR : linear);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, linear);
}

}  // namespace

Texture make_texture(GLenum format, int resolution, Mipmaps mipmaps, Filter filter) {
    Texture texture = generate<Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    make_levels(format, resolution, level_count(resolution, mipmaps));
    set_filter(GL_TEXTURE_2D, mipmaps, filter);
    return texture;
}

Texture make_texture_array(GLenum format, int resolution, int layers, Mipmaps mipmaps) {
    Texture texture = generate<Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
    make_array_levels(format, resolution, layers, level_count(resolution, mipmaps));
    set_filter(GL_TEXTURE_2D_ARRAY, mipmaps, Filter::nearest);
    return texture;
}

Texture make_layer_view(const Texture& array, GLenum format, int resolution, int layer,
                        Mipmaps mipmaps) {
    Texture view = generate<Texture, &glGenTextures>();
    glTextureView(view.name(), GL_TEXTURE_2D, array.name(), format, 0,
                  static_cast<GLuint>(level_count(resolution, mipmaps)), static_cast<GLuint>(layer),
                  1);
    glBindTexture(GL_TEXTURE_2D, view.name());
    set_filter(GL_TEXTURE_2D, mipmaps, Filter::nearest);
    return view;
}

}  // namespace ocean::gl
