// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that exist before a bake: reads them and decides whether the plan would write the same
// bytes.
#pragma once

#include <optional>

#include "manifest.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"

namespace ocean {

/// Returns false for devices and pipes, which cannot be kept or read back.
bool is_regular(const BakeFile& file);

/// Throws Error invalid_value if one of the plan's files exists and is the user's: the manifest
/// does not list it, and it does not look like a baked file.
void refuse_to_overwrite_foreign_files(const BakePlan& plan, const Manifest& manifest);

/// Sets the members of an entry that depend on the plan alone: name, frame, time, product and
/// recipe.
void describe(const BakePlan& plan, const BakeFile& file, ManifestEntry& entry);

/// Returns the entry of a file, with the hashes of its bytes and of its pixels. Throws Error
/// bad_file if the file is damaged or not the plan's.
ManifestEntry inspect(const BakePlan& plan, const BakeFile& file, int threads);

/// Returns the entry of a file that is complete and that this plan would write; nothing for any
/// other file. A file whose header proves its recipe must agree with its entry in the manifest, if
/// it has one; any other file must have an entry.
std::optional<ManifestEntry> find_complete(const BakePlan& plan, const BakeFile& file,
                                           const Manifest& manifest, int threads);

}  // namespace ocean
