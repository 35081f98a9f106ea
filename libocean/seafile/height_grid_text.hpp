// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A grid of heights inside a file of parameters, for the base of a terrain and the bed of a sea: a
// grid of at most 1 MB stands there in base 64; for a larger grid the table has the hash, and the
// file must lie where the parameters say.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "ocean/domain.hpp"
#include "ocean/page_vector.hpp"
#include "toml_input.hpp"

namespace ocean {

inline constexpr std::size_t kMaxInlinedHeights = std::size_t{1} << 20;  // [bytes]

struct HeightGridView {
    Domain grid;
    std::string hash;
    std::span<const float> heights;
};
/// Returns the lines of the table, without its header: sha256, and for heights of at most 1 MB
/// samples, cell and heights.
std::string height_grid_text(const HeightGridView& grid);

/// The contents of the table of a height grid.
struct HeightGridText {
    Domain grid{.origin = {}, .size = {}, .samples = {}, .wraps = false};
    PageVector<float> heights;  // empty: only the hash is known
    std::string hash;
};
/// Reads the table; messages call it `name`. Throws Error invalid_value.
HeightGridText read_height_grid(const toml::table& table, const std::string& name, int max_side);
/// Throws Error invalid_value if the table's heights have another hash than the table states.
void require_stated_hash(const std::string& hash, const std::string& stated,
                         const std::string& name);

}  // namespace ocean
