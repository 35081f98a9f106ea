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
/// does not list it, and it does not look like a baked file. Throws it too if files of the plan's
/// name show another subject, by the manifests and by the headers of files that none lists, unless
/// the plan overwrites them.
void refuse_to_overwrite_others(const BakePlan& plan, const Manifest& manifest);

/// Returns true if a header has the text of a subject: a header that is made of comments loses the
/// end of its last line.
bool is_same_text(const std::string& in_header, const std::string& text);
/// Sets an entry's number of bytes and their SHA-256. Throws Error bad_file.
void hash_file(const BakeFile& file, ManifestEntry& entry);

/// Sets the members of an entry that depend on the plan alone: name, frame, time, product,
/// recipe, subject and sequence.
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
