// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/saved_scene.hpp"

#include <filesystem>
#include <utility>

#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/seafile.hpp"

namespace ocean::app {
namespace {

/// Returns the take of a sea as text; "" for a sea without one and for any other subject.
std::string take_of(const Subject& scene) {
    const Sea* const sea = find_sea(scene);
    return sea != nullptr ? write_take(sea->take) : "";
}

}  // namespace

std::string free_name(const std::string& stem, const std::string& ending) {
    for (int n = 1;; ++n) {
        const std::string name = stem + "-" + std::to_string(n) + ending;
        if (!std::filesystem::exists(utf8_path(name))) return name;
    }
}

SavedScene::SavedScene(std::string stem, const OpenedScene& scene) : stem_(std::move(stem)) {
    set_read(*scene);
}

std::string SavedScene::save(const Subject& scene, const std::string& requested) {
    std::string name = requested + ".toml";
    if (requested.empty()) {
        name = free_name(stem_ + (take_of(scene).empty() ? "-changed" : "-performed"), ".toml");
    } else if (std::filesystem::exists(utf8_path(name))) {
        name = free_name(requested, ".toml");
    }
    io::write_file_atomically(name, scene.text());
    set_read(scene);
    return name;
}

void SavedScene::set_read(const Subject& scene) {
    kept_take_ = take_of(scene);
}

bool SavedScene::lacks(const Subject& scene) const {
    const std::string take = take_of(scene);
    return !take.empty() && take != kept_take_;
}

}  // namespace ocean::app
