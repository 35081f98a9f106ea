// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// "Did you mean": the known name nearest to a mistyped one, for error messages.
#pragma once

#include <span>
#include <string_view>

namespace ocean {

/// Returns the one of `names` with the fewest edits from `word`, at most one for each three letters
/// of the longer of both. Empty if all are farther away.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

}  // namespace ocean
