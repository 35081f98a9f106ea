// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Archives of text files (tar), as servers of wave models hand out the spectra of many points.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ocean {

struct ArchiveMember {
    std::string name;          // printable, with its folders
    std::string_view content;  // within the archive
};

/// Recognises a tar archive by the checksum of its first header.
bool is_tar(std::string_view content);
/// Returns the regular files of an archive, at most kMaxArchiveMembers. `name` is for messages.
/// Throws Error bad_file for a damaged header, more files than that, or a truncated last file if no
/// other file is whole; otherwise a truncated last file is left out and its name put into
/// `cut_off`.
std::vector<ArchiveMember> tar_members(std::string_view content, const std::string& name,
                                       std::string& cut_off);
inline constexpr std::size_t kMaxArchiveMembers = 10000;

}  // namespace ocean
