// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The provenance of a file, which headers of all formats hold: its subject, frame, time and domain.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/subject_kind.hpp"

namespace ocean::io {

/// A named text in a file's header.
struct HeaderString {
    std::string name;
    std::string text;
};

/// The data from which a file can be made again. Headers hold it as strings (provenance_strings);
/// members that are not set are left out.
struct Provenance {
    std::string kind = {};  // of the subject, "sea"; ocean:sea is then the name of `text`
    std::string text = {};  // the subject's own file, resolved: it needs no other file
    std::string id = {};    // a short hash of the subject and its map, for hosts; not in headers
    std::optional<int> frame = {};
    std::optional<double> time = {};  // [s]
    std::optional<Domain> domain = {};
    std::string backend = {};  // backends differ in the last bits
};

/// Returns ocean:KIND, frame, time, period (or origin, size, samples and wraps for a domain that
/// does not wrap), backend and version. Kinds that are not in the list of provenance.cpp
/// also have ocean:subject = KIND.
std::vector<HeaderString> provenance_strings(const Provenance& provenance);
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
