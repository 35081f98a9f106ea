// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Programs made of the files in shaders/ and of definitions made by C++.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ocean/internal/gl/objects.hpp"

namespace ocean::gl {

/// A shader file with all files that it includes.
struct ShaderText {
    std::string text;                // without #version; lines are numbered by file
    std::vector<std::string> files;  // in the order of their numbers
    /// The files on disk with their times; empty for files inside the library.
    std::vector<std::pair<std::filesystem::path, std::filesystem::file_time_type>> on_disk;

    /// Returns true if one of the files on disk has changed.
    bool changed_on_disk() const;
};

/// One stage of a program: GL_COMPUTE_SHADER, GL_VERTEX_SHADER ... and a file in the folder of
/// shaders.
struct ShaderStage {
    GLenum kind;
    std::string path;
};

class ShaderProgram {
  public:
    ShaderProgram() = default;
    /// Compiles and links. defines: lines of #define. Throws Error no_gpu with the compiler's
    /// messages, files by their names, if the driver refuses it.
    ShaderProgram(std::vector<ShaderStage> stages, std::string defines);

    /// Makes this the current program. If a shader has changed on disk, it is compiled first; if
    /// that fails, this throws once and later calls continue with the previous program. Returns
    /// true if the program is new, so that all its uniforms must be set.
    bool use();
    GLuint name() const { return program_.name(); }
    /// Sets a uniform of the current program. Ignores a uniform that the driver has optimised away.
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

/// Returns the whole text that the driver compiles: of OpenGL 4.3 for compute shaders, else of 4.1.
std::string program_text(const ShaderText& text, std::string_view defines,
                         GLenum kind = GL_COMPUTE_SHADER);

}  // namespace ocean::gl
