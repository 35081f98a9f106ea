// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The shaders' texts: those of shaders/, which are inside the library, or of the folder that
// OCEAN_SHADER_DIR names, which can be edited while they run.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ocean::gl {

/// What is inside the library: a path below shaders/ and its text.
struct EmbeddedShader {
    std::string_view path;
    std::string_view text;
};
extern const EmbeddedShader kEmbeddedShaders[];
extern const int kEmbeddedShaderCount;

/// A file with all that it includes.
struct ShaderText {
    std::string text;                // without #version; lines are numbered by file
    std::vector<std::string> files;  // in the order of their numbers
    /// Of the files on disk; empty for those inside the library.
    std::vector<std::pair<std::filesystem::path, std::filesystem::file_time_type>> on_disk;

    bool changed_on_disk() const;
};

/// Throws Error bad_file for a file that is not there, includes itself or too many.
ShaderText load_shader(std::string_view path);

}  // namespace ocean::gl
