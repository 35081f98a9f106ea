// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of square maps.
#pragma once

#include "ocean/gl/objects.hpp"

namespace ocean::gl {

enum class Mipmaps { no, yes };
enum class Filter { nearest, linear };

/// Returns a texture of N x N texels that repeats, in the float format `format`. With mipmaps it is
/// filtered through all of them. Leaves it bound to GL_TEXTURE_2D.
Texture make_texture(GLenum format, int resolution, Mipmaps mipmaps = Mipmaps::no,
                     Filter filter = Filter::nearest);

}  // namespace ocean::gl
