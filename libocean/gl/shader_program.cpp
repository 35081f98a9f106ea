// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From shaders' texts to a program; see ocean/internal/gl/shader_program.hpp.
#include "ocean/internal/gl/shader_program.hpp"

#include <algorithm>

#include "checks.hpp"
#include "ocean/error.hpp"
#include "shader_text.hpp"

namespace ocean::gl {

namespace {

/// The macros that shaders/wave/ expects from the including code.
constexpr std::string_view kHead =
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

/// Returns the log with file names: "0:12(3): error" and "0(12) : error" give a file by its number.
std::string with_names(const std::string& log, const std::vector<std::string>& files) {
    std::string text = log;
    for (std::size_t i = 0; i < files.size(); ++i) {
        text += "\n  file " + std::to_string(i) + " is " + files[i];
    }
    return text;
}

Shader compile_stage(const ShaderStage& stage, const ShaderText& text, std::string_view defines) {
    const std::string source = program_text(text, defines, stage.kind);
    const char* const pointer = source.c_str();
    Shader shader(glCreateShader(stage.kind));
    glShaderSource(shader.name(), 1, &pointer, nullptr);
    glCompileShader(shader.name());
    GLint good = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good == 0) {
        require_no_error("compiling a shader");
        const auto log = log_of<&glGetShaderiv, &glGetShaderInfoLog>(shader.name());
        throw Error(ErrorKind::no_gpu, "the driver does not compile the shader " + stage.path +
                                           ": " + with_names(log, text.files));
    }
    return shader;
}

std::vector<ShaderText> load_stages(const std::vector<ShaderStage>& stages) {
    std::vector<ShaderText> texts;
    for (const ShaderStage& stage : stages) texts.push_back(load_shader(stage.path));
    return texts;
}

}  // namespace

std::string program_text(const ShaderText& text, std::string_view defines, GLenum kind) {
    const char* version = kind == GL_COMPUTE_SHADER ? "#version 430 core\n" : "#version 410 core\n";
    return version + std::string(kHead) + std::string(defines) + text.text;
}

ShaderProgram::ShaderProgram(std::vector<ShaderStage> stages, std::string defines)
    : stages_(std::move(stages)), defines_(std::move(defines)), texts_(load_stages(stages_)) {
    compile(texts_);
}

bool ShaderProgram::use() {
    const bool changed = std::ranges::any_of(texts_, &ShaderText::changed_on_disk);
    if (changed) {
        texts_ = load_stages(stages_);
        compile(texts_);
    }
    glUseProgram(program_.name());
    return changed;
}

void ShaderProgram::set(const char* name, int x) {
    glUniform1i(glGetUniformLocation(program_.name(), name), x);
}

void ShaderProgram::set(const char* name, float x) {
    glUniform1f(glGetUniformLocation(program_.name(), name), x);
}

void ShaderProgram::set(const char* name, float x, float y) {
    glUniform2f(glGetUniformLocation(program_.name(), name), x, y);
}

void ShaderProgram::set(const char* name, float x, float y, float z, float w) {
    glUniform4f(glGetUniformLocation(program_.name(), name), x, y, z, w);
}

void ShaderProgram::compile(const std::vector<ShaderText>& texts) {
    Program program(glCreateProgram());
    std::vector<Shader> shaders;
    for (std::size_t i = 0; i < stages_.size(); ++i) {
        shaders.push_back(compile_stage(stages_[i], texts[i], defines_));
        glAttachShader(program.name(), shaders.back().name());
    }
    glLinkProgram(program.name());
    GLint good = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good == 0) {
        require_no_error("linking a shader");
        const auto log = log_of<&glGetProgramiv, &glGetProgramInfoLog>(program.name());
        throw Error(ErrorKind::no_gpu,
                    "the driver does not link the shader " + stages_.back().path + ": " + log);
    }
    for (const Shader& shader : shaders) glDetachShader(program.name(), shader.name());
    program_ = std::move(program);
}

}  // namespace ocean::gl
