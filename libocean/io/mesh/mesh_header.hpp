// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The comments in the header of a mesh file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/io/provenance.hpp"

namespace ocean::io {

/// Returns the comments before `end` of a file that begins with `magic`. Throws Error bad_file for
/// a file that does not, or that names no subject.
std::vector<HeaderString> read_comments(const std::string& path, std::string_view magic,
                                        std::string_view end, std::string_view prefix);

}  // namespace ocean::io
