// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The measured spectrum of a terrain, from its file.
#pragma once

#include <string>

#include "ocean/internal/measured_rings.hpp"

namespace ocean {

/// Throws Error invalid_value of `parameter` unless the rings have 2 .. 4096 finite wavenumbers
/// above 0 in ascending order, each with a finite density of 0 or more.
void validate_rings(const MeasuredRings& rings, const std::string& parameter);
/// Returns the rings of a file of rings, or measured in an elevation model. Throws Error bad_file
/// "PATH:LINE: ...".
MeasuredRings read_measured_rings(const std::string& path);

}  // namespace ocean
