// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds ocean-raster: see raster_program.hpp.
#include "raster_program.hpp"

#include <filesystem>
#include <system_error>

namespace ocean::elevation {

std::string raster_program() {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path self = fs::read_symlink("/proc/self/exe", ignored);
    for (const fs::path& program : {self.parent_path().parent_path() / OCEAN_RASTER_BESIDE,
                                    fs::path(OCEAN_RASTER_INSTALLED)}) {
        if (fs::is_regular_file(program, ignored)) return program.string();
    }
    return "";
}

}  // namespace ocean::elevation
