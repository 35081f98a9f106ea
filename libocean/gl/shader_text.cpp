// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Shaders and their includes; see shader_text.hpp. An include is alone on its line, between quotes,
// with a path from the root of shaders/; each file is included once.
#include "shader_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::gl {

namespace {

class Loader {
  public:
    ShaderText load(std::string_view path) {
        append(path);
        return std::move(result_);
    }

  private:
    static constexpr std::string_view kInclude = "#include \"";

    void append(std::string_view path) {
        const auto number = result_.files.size();
        result_.files.emplace_back(path);
        const std::string text = read(path);
        start_line(1, number);
        int line_number = 0;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            const std::string_view line = std::string_view(text).substr(at, end - at);
            at = end + 1;
            ++line_number;
            if (!line.starts_with(kInclude)) {
                result_.text.append(line).push_back('\n');
                continue;
            }
            const std::string_view rest = line.substr(kInclude.size());
            const std::string_view included = rest.substr(0, rest.find('"'));
            const auto& files = result_.files;
            if (std::ranges::find(files, included) == files.end()) append(included);
            start_line(line_number + 1, number);
        }
    }

    void start_line(int line, std::size_t file) {
        result_.text += "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
    }

    std::string read(std::string_view path) {
        const char* folder = std::getenv("OCEAN_SHADER_DIR");
        if (folder != nullptr && *folder != '\0') return read_from_disk(utf8_path(folder), path);
        for (int i = 0; i < kEmbeddedShaderCount; ++i) {
            if (kEmbeddedShaders[i].path == path) return std::string(kEmbeddedShaders[i].text);
        }
        throw Error(ErrorKind::bad_file, "shader '" + std::string(path) + "' does not exist");
    }

    std::string read_from_disk(const std::filesystem::path& folder, std::string_view path) {
        const std::filesystem::path file = folder / utf8_path(path);
        std::error_code failure;
        const auto time = std::filesystem::last_write_time(file, failure);
        std::ifstream stream(file, std::ios::binary);
        std::ostringstream text;
        if (!failure) text << stream.rdbuf();
        if (failure || !stream || !text) {
            throw Error(ErrorKind::bad_file,
                        "shader '" + file.string() + "' (OCEAN_SHADER_DIR) cannot be read");
        }
        result_.on_disk.emplace_back(file, time);
        return std::move(text).str();
    }

    ShaderText result_;
};

}  // namespace

bool ShaderText::changed_on_disk() const {
    return std::ranges::any_of(on_disk, [](const auto& file) {
        std::error_code failure;
        const auto time = std::filesystem::last_write_time(file.first, failure);
        return !failure && time != file.second;
    });
}

ShaderText load_shader(std::string_view path) {
    return Loader().load(path);
}

}  // namespace ocean::gl
