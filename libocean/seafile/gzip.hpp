// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Packed text files, as archives of buoys hand them out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ocean {

/// Recognises gzip by its first bytes.
bool is_gzip(std::string_view content);
/// Returns the unpacked content of all members. `name` is for messages. Throws Error bad_file if it
/// is damaged, cut off, or larger than `limit` bytes when unpacked; unsupported in a build without
/// zlib.
std::string gunzip(std::string_view packed, const std::string& name, std::size_t limit);

}  // namespace ocean
