// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See input_files.hpp.
#include "input_files.hpp"

#include <filesystem>
#include <system_error>

#include "command.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::app {

InputFiles::InputFiles(const std::string& source, const std::vector<std::string>& named) {
    add(source);
    const std::filesystem::path folder = utf8_path(source).parent_path();
    for (const std::string& name : named) add((folder / utf8_path(name)).string());
}

void InputFiles::add(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(utf8_path(path), ignored)) paths_.push_back(path);
}

void InputFiles::spare(const std::string& output) const {
    std::error_code missing;
    if (!std::filesystem::exists(utf8_path(output), missing)) return;
    for (const std::string& path : paths_) {
        if (!std::filesystem::equivalent(utf8_path(path), utf8_path(output), missing)) continue;
        const bool same_name = path == output;
        refuse("'" + output + "' is an input of this command" +
               (same_name ? "" : ", as '" + path + "'") +
               ": it is not overwritten; choose another file");
    }
}

}  // namespace ocean::app
