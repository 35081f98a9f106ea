// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of rings: CSV with the columns `wavenumber` [rad/m] and `density` [m^4]. Further columns,
// such as `count`, `model` and `residual`, are for people and are not read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "ocean/measured_rings.hpp"

namespace ocean {

inline constexpr std::size_t kMaxRingsBytes = std::size_t{1} << 20;

/// Reads a file of rings. Throws Error bad_file "PATH:LINE: ..." unless it
/// has kMinRings .. kMaxRings rows, the wavenumbers are positive and increase, and the densities
/// are finite, at least 0 and not all 0.
MeasuredRings read_rings(const std::string& path);
/// Reads the text of such a file; `name` stands for the path in messages. Throws as read_rings.
MeasuredRings parse_rings(std::string_view text, const std::string& name);

}  // namespace ocean
