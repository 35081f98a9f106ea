// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A compute shader with what is defined outside of it.
#pragma once

#include <string>
#include <string_view>

#include "objects.hpp"
#include "shader_text.hpp"

namespace ocean::gl {

class ComputeProgram {
  public:
    ComputeProgram() = default;
    /// path: in the folder of shaders. defines: lines of #define. Throws Error no_gpu with the
    /// compiler's words, the files by their names, if the driver does not take it.
    ComputeProgram(std::string_view path, std::string defines);

    /// Makes it the current program. A shader that was changed on disk is compiled anew first; if
    /// that fails it throws once, and the program of before goes on with the next call.
    void use();
    /// A uniform of the current program; one that the driver found to be of no use is left out.
    void set(const char* name, int x);
    void set(const char* name, float x);
    void set(const char* name, float x, float y);

  private:
    void compile(const ShaderText& text);

    std::string path_;
    std::string defines_;
    ShaderText text_;
    Program program_;
};

/// Runs the current program for each of N x N texels, in workgroups of 16 x 16.
void dispatch_texels(int resolution);

/// The whole text that the driver compiles.
std::string program_text(const ShaderText& text, std::string_view defines);

}  // namespace ocean::gl
