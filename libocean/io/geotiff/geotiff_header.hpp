// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The words that both parts of GeoTIFF share.
#pragma once

#include <string_view>

namespace ocean::io {

/// The prefix of each line of header strings in ImageDescription.
inline constexpr std::string_view kGeotiffLine = "libocean";

}  // namespace ocean::io
