// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From a shader's text to a program; see compute_program.hpp.
#include "compute_program.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "ocean/error.hpp"

namespace ocean::gl {

namespace {

/// The words that shaders/wave/ leaves to those who include it.
constexpr std::string_view kHead =
    "#version 430 core\n"
    "#define real float\n"
    "#define formula\n"
    "#define splitter 4097.0\n";

template <auto kGetLength, auto kGetLog>
std::string log_of(GLuint name) {
    GLint length = 0;
    (*kGetLength)(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    (*kGetLog)(name, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) log.pop_back();
    return log;
}

/// "0:12(3): error" and "0(12) : error" say the file by its number.
std::string with_names(const std::string& log, const std::vector<std::string>& files) {
    std::string text = log;
    for (std::size_t i = 0; i < files.size(); ++i) {
        text += "\n  file " + std::to_string(i) + " is " + files[i];
    }
    return text;
}

}  // namespace

std::string program_text(const ShaderText& text, std::string_view defines) {
    return std::string(kHead) + std::string(defines) + text.text;
}

void dispatch_texels(int resolution) {
    const auto tiles = static_cast<GLuint>(resolution) / 16;
    glDispatchCompute(tiles, tiles, 1);
}

ComputeProgram::ComputeProgram(std::string_view path, std::string defines)
    : path_(path), defines_(std::move(defines)), text_(load_shader(path)) {
    compile(text_);
}

void ComputeProgram::use() {
    if (text_.changed_on_disk()) {
        text_ = load_shader(path_);
        compile(text_);
    }
    glUseProgram(program_.name());
}

void ComputeProgram::set(const char* name, int x) {
    glUniform1i(glGetUniformLocation(program_.name(), name), x);
}

void ComputeProgram::set(const char* name, float x) {
    glUniform1f(glGetUniformLocation(program_.name(), name), x);
}

void ComputeProgram::set(const char* name, float x, float y) {
    glUniform2f(glGetUniformLocation(program_.name(), name), x, y);
}

void ComputeProgram::compile(const ShaderText& text) {
    const std::string source = program_text(text, defines_);
    const char* const pointer = source.c_str();
    const Shader shader(glCreateShader(GL_COMPUTE_SHADER));
    glShaderSource(shader.name(), 1, &pointer, nullptr);
    glCompileShader(shader.name());
    GLint good = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good == 0) {
        require_no_error("compiling a shader");
        const auto log = log_of<&glGetShaderiv, &glGetShaderInfoLog>(shader.name());
        throw Error(ErrorKind::no_gpu, "the driver does not compile the shader " + path_ + ": " +
                                           with_names(log, text.files));
    }
    Program program(glCreateProgram());
    glAttachShader(program.name(), shader.name());
    glLinkProgram(program.name());
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good == 0) {
        require_no_error("linking a shader");
        const auto log = log_of<&glGetProgramiv, &glGetProgramInfoLog>(program.name());
        throw Error(ErrorKind::no_gpu, "the driver does not link the shader " + path_ + ": " + log);
    }
    glDetachShader(program.name(), shader.name());
    program_ = std::move(program);
}

}  // namespace ocean::gl
