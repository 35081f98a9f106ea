// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Output paths; see write_output.hpp.
#include "write_output.hpp"

#include <filesystem>

#include "ocean/error.hpp"
#include "ocean/io.hpp"
#include "ocean/platform.hpp"

namespace ocean::app {

void make_folder(const std::string& folder) {
    if (folder.empty()) return;
    std::error_code code;
    std::filesystem::create_directories(utf8_path(folder), code);
    if (!code) return;
    throw Error(ErrorKind::output, folder + ": the folder cannot be made: " + code.message());
}

void write_output(const std::string& path, std::string_view bytes) {
    make_folder(utf8_path(path).parent_path().string());
    io::write_file_atomically(path, bytes);
}

}  // namespace ocean::app
