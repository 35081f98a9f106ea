// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/saved_sea.hpp"

#include <filesystem>
#include <utility>

#include "ocean/internal/platform.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/seafile.hpp"

namespace ocean::app {

std::string free_name(const std::string& stem, const std::string& ending) {
    for (int n = 1;; ++n) {
        const std::string name = stem + "-" + std::to_string(n) + ending;
        if (!std::filesystem::exists(utf8_path(name))) return name;
    }
}

SavedSea::SavedSea(std::string stem, const Sea& sea) : stem_(std::move(stem)) {
    set_read(sea);
}

std::string SavedSea::save(const Sea& sea, const std::string& requested) {
    std::string name = requested + ".toml";
    if (requested.empty()) {
        name = free_name(stem_ + (sea.take.empty() ? "-changed" : "-performed"), ".toml");
    } else if (std::filesystem::exists(utf8_path(name))) {
        name = free_name(requested, ".toml");
    }
    io::write_file_atomically(name, write_sea(sea));
    set_read(sea);
    return name;
}

void SavedSea::set_read(const Sea& sea) {
    kept_take_ = write_take(sea.take);
}

bool SavedSea::lacks(const Sea& sea) const {
    const std::string take = write_take(sea.take);
    return !take.empty() && take != kept_take_;
}

}  // namespace ocean::app
