// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A compute shader with the definitions made by C++.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "ocean/internal/gl/shader_program.hpp"

namespace ocean::gl {

class ComputeProgram : public ShaderProgram {
  public:
    ComputeProgram() = default;
    /// Compiles a shader. path: in the folder of shaders. defines: lines of #define. Throws Error
    /// no_gpu.
    ComputeProgram(std::string_view path, std::string defines)
        : ShaderProgram({{GL_COMPUTE_SHADER, std::string(path)}}, std::move(defines)) {}
};

/// Runs the current program for each of N x N texels, in workgroups of 16 x 16.
void dispatch_texels(int resolution);

}  // namespace ocean::gl
