// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "user_files.hpp"

#include <cstdlib>

namespace ocean::app {
namespace {

std::string folder_of(const char* variable) {
    const char* const value = std::getenv(variable);
    return value != nullptr && *value == '/' ? value : "";
}

std::string user_file(const char* variable, const std::string& in_home, const std::string& name) {
    std::string folder = folder_of(variable);
    if (folder.empty()) {
        folder = folder_of("HOME");
        if (folder.empty()) return "";
        folder += in_home;
    }
    return folder + "/libocean/" + name;
}

}  // namespace

std::string state_file(const std::string& name) {
    return user_file("XDG_STATE_HOME", "/.local/state", name);
}

std::string cache_file(const std::string& name) {
    return user_file("XDG_CACHE_HOME", "/.cache", name);
}

}  // namespace ocean::app
