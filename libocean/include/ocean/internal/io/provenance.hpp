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

/// Returns the kind of the subject that a header names, "" if it names none.
std::string subject_kind(std::span<const HeaderString> strings);
/// Returns the provenance in a header; nothing if the header names no subject. Throws Error
/// bad_file "PATH: ..." for a text that should be a number and is not.
std::optional<Provenance> find_provenance(std::span<const HeaderString> strings,
                                          const std::string& path);

/// Returns the first bytes of a file, up to the maximal length of a header; nothing for a file that
/// cannot be read.
std::string read_head(const std::string& path);

/// Returns "PREFIX NAME LINE" for each line of each text, for files whose header consists of
/// comments.
std::string comment_lines(std::span<const HeaderString> strings, std::string_view prefix);
/// Returns the strings that comment_lines() wrote; ignores lines without the prefix.
std::vector<HeaderString> parse_comment_lines(std::string_view text, std::string_view prefix);

}  // namespace ocean::io
