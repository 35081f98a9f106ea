// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The comments at the beginning of a mesh file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ocean/io/provenance.hpp"

namespace ocean::io {

/// Of a file that begins with `magic`, the comments before `end`. Throws Error bad_file for one
/// that does not, or that says nothing of a sea.
std::vector<HeaderString> read_comments(const std::string& path, std::string_view magic,
                                        std::string_view end, std::string_view prefix);

}  // namespace ocean::io
