// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the provenance of a file back from its header, and writes headers made of comments.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/provenance.hpp"

namespace ocean::io {

using ocean::HeaderString;
using ocean::Provenance;
using ocean::provenance_strings;

/// Returns the kind of the subject that a header names, "" for none.
std::string subject_kind(std::span<const HeaderString> strings);
/// Reads it back from a header; nothing where no subject is named. Throws Error bad_file
/// "PATH: ..." for a number that is none.
std::optional<Provenance> find_provenance(std::span<const HeaderString> strings,
                                          const std::string& path);

/// Returns the first bytes of a file, as many as the longest header may have; all of a shorter one,
/// none of one that cannot be read.
std::string read_head(const std::string& path);

/// Returns "PREFIX NAME LINE" for each line of each text, for files whose header is made of
/// comments.
std::string comment_lines(std::span<const HeaderString> strings, std::string_view prefix);
/// Returns the strings again, of all lines that begin so; other lines are left out.
std::vector<HeaderString> parse_comment_lines(std::string_view text, std::string_view prefix);

}  // namespace ocean::io
