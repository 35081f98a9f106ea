// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers as Fortran writes them into the files of wave models.
#pragma once

#include <optional>
#include <string_view>

namespace ocean::text {

/// Removes a number that Fortran wrote from the front of `text` and returns it: 0.1D-02, 0.123-100
/// (an exponent of three digits leaves no room for its letter), 40.98-171.12 (the first of two
/// without a blank between). Returns nothing, and removes nothing, if there is no number.
std::optional<double> next_fortran_number(std::string_view& text);

}  // namespace ocean::text
