// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that are there already: what they hold, and whether a plan would write the same.
#pragma once

#include <optional>

#include "manifest.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"

namespace ocean {

/// A device or a pipe has nothing to keep, and nothing to read back.
bool is_regular(const BakeFile& file);

/// Throws Error invalid_value for a file of the plan that is there and was not baked, which is then
/// the user's: neither the manifest lists it nor does it look so.
void require_own_files(const BakePlan& plan, const Manifest& manifest);

/// Writes into the entry what a plan says of a file before it is read: name, frame, time, product
/// and recipe.
void describe(const BakePlan& plan, const BakeFile& file, ManifestEntry& entry);

/// Reads all of a file, and its pixels. Throws Error bad_file if it is damaged or none of this
/// plan.
ManifestEntry inspect(const BakePlan& plan, const BakeFile& file, int threads);

/// What is to be said of a file that is whole and what this plan would write; nothing for any
/// other. A file that tells its recipe must agree with the manifest if that lists it; other files
/// need the manifest.
std::optional<ManifestEntry> find_complete(const BakePlan& plan, const BakeFile& file,
                                           const Manifest& manifest, int threads);

}  // namespace ocean
