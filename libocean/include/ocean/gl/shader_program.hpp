// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Shaders of shaders/, with what is defined outside of them, as one program.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ocean/gl/objects.hpp"

namespace ocean::gl {

/// A file with all that it includes.
struct ShaderText {
    std::string text;                // without #version; lines are numbered by file
    std::vector<std::string> files;  // in the order of their numbers
    /// Of the files on disk; empty for those inside the library.
    std::vector<std::pair<std::filesystem::path, std::filesystem::file_time_type>> on_disk;

    bool changed_on_disk() const;
};

/// GL_COMPUTE_SHADER, GL_VERTEX_SHADER ... and a file in the folder of shaders.
struct ShaderStage {
    GLenum kind;
    std::string path;
};

class ShaderProgram {
  public:
    ShaderProgram() = default;
    /// defines: lines of #define. Throws Error no_gpu with the compiler's words, the files by their
    /// names, if the driver does not take it.
    ShaderProgram(std::vector<ShaderStage> stages, std::string defines);

    /// Makes it the current program. A shader that was changed on disk is compiled anew first; if
    /// that fails it throws once, and the program of before goes on with the next call. Returns
    /// whether it is another program than before, which knows no uniforms yet.
    bool use();
    GLuint name() const { return program_.name(); }
    /// A uniform of the current program; one that the driver found to be of no use is left out.
    void set(const char* name, int x);
    void set(const char* name, float x);
    void set(const char* name, float x, float y);
    void set(const char* name, float x, float y, float z, float w);

  private:
    void compile(const std::vector<ShaderText>& texts);

    std::vector<ShaderStage> stages_;
    std::string defines_;
    std::vector<ShaderText> texts_;
    Program program_;
};

/// The whole text that the driver compiles: of OpenGL 4.3 for compute shaders, else of 4.1.
std::string program_text(const ShaderText& text, std::string_view defines,
                         GLenum kind = GL_COMPUTE_SHADER);

}  // namespace ocean::gl
