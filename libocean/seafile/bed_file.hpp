// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed of a sea: its file, a terrain file or an elevation model, and its text in a resolved sea
// file. A terrain's text stands in [water.bed_terrain], and heights of at most 1 MB in
// [water.bed_heights]; for larger heights the table has the hash, and their file must lie where
// `seabed` says. Heights are inlined as they were given, so that unit, sign and level stay
// parameters.
#pragma once

#include <string>
#include <string_view>

#include "height_grid_text.hpp"
#include "ocean/parameters.hpp"
#include "toml_input.hpp"

namespace ocean {

inline constexpr std::string_view kBedHeights = "bed_heights";
inline constexpr std::string_view kBedTerrain = "bed_terrain";

/// A bed as a sea file holds it: a terrain, heights, the hash of heights, or nothing.
struct InlinedBed {
    std::string terrain;
    HeightGridText heights;
};

/// Reads one of the two tables of [water] into `bed`, and returns true; returns false for any other
/// entry. Throws Error invalid_value.
bool read_bed_table(const TomlEntry& entry, InlinedBed& bed);

/// Sets the bed of `water`: the text's, else its file's, else none. Relative paths are relative to
/// base_dir. Throws Error of water.seabed, with parameter and value in its fields.
void resolve_bed(Water& water, const std::string& base_dir, InlinedBed inlined = {});

/// Returns the table of a bed, with its header; "" if there is no bed.
std::string bed_text(const Water& water);

}  // namespace ocean
