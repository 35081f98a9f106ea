// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of square maps.
#pragma once

#include "ocean/internal/gl/objects.hpp"

namespace ocean::gl {

enum class Mipmaps { no, yes };
enum class Filter { nearest, linear };

/// Returns a texture of N x N texels that repeats, in the float format `format`. With mipmaps it is
/// filtered through all of them. Leaves it bound to GL_TEXTURE_2D.
Texture make_texture(GLenum format, int resolution, Mipmaps mipmaps = Mipmaps::no,
                     Filter filter = Filter::nearest);

/// Returns an array of such textures of N x N texels, and leaves it bound to GL_TEXTURE_2D_ARRAY.
Texture make_texture_array(GLenum format, int resolution, int layers,
                           Mipmaps mipmaps = Mipmaps::no);

/// Returns a texture of GL_TEXTURE_2D that shares its texels, mipmaps included, with a layer of an
/// array, whose format it has. Needs OpenGL 4.3.
Texture make_layer_view(const Texture& array, GLenum format, int resolution, int layer,
                        Mipmaps mipmaps = Mipmaps::no);

}  // namespace ocean::gl
