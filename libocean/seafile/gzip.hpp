// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Packed text files, as archives of buoys hand them out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ocean {

/// By its first bytes.
bool is_gzip(std::string_view content);
/// Unpacks all members. `name` is for messages. Throws Error bad_file: damaged, cut off, larger
/// than `limit` when unpacked; unsupported where zlib was not there at build time.
std::string gunzip(std::string_view packed, const std::string& name, std::size_t limit);

}  // namespace ocean
