// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The measured land that a terrain names. `measured` is a file of rings, or an elevation model
// whose rings are measured. `base` is an elevation model: its file, and its text in a resolved
// terrain file, [terrain.base_heights]. The table contains a model of at most 1 MB; for a larger
// model it has the hash, and the file must lie where `base` says.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "ocean/internal/measured_rings.hpp"
#include "ocean/internal/terrain_base.hpp"
#include "ocean/terrain_model.hpp"
#include "toml_input.hpp"

namespace ocean {

/// Throws Error invalid_value of `parameter` unless the rings have 2 .. 4096 finite wavenumbers
/// above 0 in ascending order, each with a finite density of 0 or more.
void validate_rings(const MeasuredRings& rings, const std::string& parameter);
/// Returns the rings of a file of rings, or measured in an elevation model. Throws Error bad_file
/// "PATH:LINE: ...".
MeasuredRings read_measured_rings(const std::string& path);

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
