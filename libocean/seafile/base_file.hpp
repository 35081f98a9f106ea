// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The elevation model that is a terrain's base: its file, and its text in a resolved terrain file,
// [terrain.base_heights]. The table contains a model of at most 1 MB; for a larger model it has the
// hash, and the file must lie where `base` says.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "ocean/internal/terrain_base.hpp"
#include "ocean/terrain_model.hpp"
#include "toml_input.hpp"

namespace ocean {

inline constexpr std::string_view kBaseTable = "base_heights";

/// Reads the model and measures its spectrum. Throws Error bad_file.
std::shared_ptr<const TerrainBase> read_base(const std::string& path);
/// Returns the lines of [terrain.base_heights].
std::string base_text(const TerrainBase& base);

/// The contents of [terrain.base_heights]: a model, or only its hash.
struct BaseHeights {
    std::shared_ptr<const TerrainBase> model;
    std::string hash;
};
/// Reads the table. Throws Error invalid_value.
BaseHeights read_base_table(const toml::table& table);
/// Returns the model if `hash` is its hash, with a note if earlier versions made the hash under a
/// locale with decimal commas; else nothing.
std::shared_ptr<const TerrainBase> base_with_hash(const std::shared_ptr<const TerrainBase>& base,
                                                  const std::string& stated);

}  // namespace ocean
