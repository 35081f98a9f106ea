// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "user_files.hpp"

#include <cstdlib>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/io/output_file.hpp"

namespace ocean::app {
namespace {

std::string folder_of(const char* variable) {
    const char* const value = std::getenv(variable);
    return value != nullptr && *value == '/' ? value : "";
}

}  // namespace

std::string user_file(const char* variable, const char* fallback, const char* name) {
    std::string folder = folder_of(variable);
    if (folder.empty()) {
        folder = folder_of("HOME");
        if (folder.empty()) return "";
        folder += std::string("/") + fallback;
    }
    return folder + "/libocean/" + name;
}

preview::KeptTextures textures_in_cache() {
    const std::string path = user_file("XDG_CACHE_HOME", ".cache", "foam_pattern");
    if (path.empty()) return {};
    const auto read = [path]() -> std::string {
        constexpr std::size_t kMaxBytes = std::size_t{32} << 20;
        try {
            return text::read_file(path, kMaxBytes);
        } catch (const Error&) {
            return "";
        }
    };
    const auto write = [path](std::string_view bytes) {
        try {
            io::write_output(path, bytes);
        } catch (const Error&) {
            return;  // a full or protected disk costs time in the next run
        }
    };
    return {read, write};
}

}  // namespace ocean::app
