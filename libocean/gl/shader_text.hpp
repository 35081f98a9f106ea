// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The shaders' texts: those of shaders/, which are inside the library, or of the folder that
// OCEAN_SHADER_DIR names, which can be edited while they run.
#pragma once

#include <string_view>

#include "ocean/internal/gl/shader_program.hpp"

namespace ocean::gl {

/// A shader inside the library: a path below shaders/ and its text.
struct EmbeddedShader {
    std::string_view path;
    std::string_view text;
};
extern const EmbeddedShader kEmbeddedShaders[];
extern const int kEmbeddedShaderCount;

/// Returns a shader with its includes. Throws Error bad_file for a file that is missing, includes
/// itself or too many.
ShaderText load_shader(std::string_view path);

}  // namespace ocean::gl
