// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/gl/textures.hpp"

#include <bit>

namespace ocean::gl {
namespace {

/// Allocates all levels of a texture, as glTexStorage2D of OpenGL 4.2 does at once.
void make_levels(GLenum format, int resolution, int levels) {
    if (epoxy_gl_version() >= 42)
        return glTexStorage2D(GL_TEXTURE_2D, levels, format, resolution, resolution);
    for (int level = 0; level < levels; ++level) {
        glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(format), resolution >> level,
                     resolution >> level, 0, GL_RED, GL_FLOAT, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
}

}  // namespace

Texture make_texture(GLenum format, int resolution, Mipmaps mipmaps, Filter filter) {
    Texture texture = generate<Texture, &glGenTextures>();
    const bool levels = mipmaps == Mipmaps::yes;
    const bool linear = levels || filter == Filter::linear;
    glBindTexture(GL_TEXTURE_2D, texture.name());
    make_levels(format, resolution, levels ? std::bit_width(static_cast<unsigned>(resolution)) : 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    levels ? GL_LINEAR_MIPMAP_LINEAR : (linear ? GL_LINEAR : GL_NEAREST));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
    return texture;
}

}  // namespace ocean::gl
