// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a file comes from: what the headers of all formats say of the subject that they show, and
// of the moment.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/subject_kind.hpp"

namespace ocean::io {

/// A text of a file's header.
struct HeaderString {
    std::string name;
    std::string text;
};

/// What makes a file again. A header has it as strings (provenance_strings); what is not set is not
/// in the header.
struct Provenance {
    std::string kind = {};  // of the subject, "sea": its text is the header's ocean:sea
    std::string text = {};  // the subject's own file, resolved: it needs no other
    std::string id = {};    // a short name of the subject on its map, for hosts; not in the header
    std::optional<int> frame = {};
    std::optional<double> time = {};  // [s]
    std::optional<Domain> domain = {};
    std::string backend = {};  // which computed it: the last bits differ
};

/// Returns ocean:KIND, frame, time, period (of a domain that is no tile: origin, size, samples and
/// wraps), backend and version. A kind that is newer than this list has ocean:subject = KIND too.
std::vector<HeaderString> provenance_strings(const Provenance& provenance);
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
