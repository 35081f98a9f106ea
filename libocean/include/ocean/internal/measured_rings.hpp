// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spectrum of measured land as a table: the mean density in rings of the wavenumber plane.
// Files of rings are CSV with the columns `wavenumber` [rad/m] and `density` [m^4]; further
// columns, such as `count`, `model` and `residual`, are for people and are not read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ocean {

inline constexpr std::size_t kMinRings = 2;
inline constexpr std::size_t kMaxRings = 4096;
inline constexpr std::size_t kMaxRingsBytes = std::size_t{1} << 20;

/// A density over (kx, ky), isotropic: variance = integral of S dkx dky. Wavenumbers increase.
struct MeasuredRings {
    std::vector<double> wavenumber;  // [rad/m]
    std::vector<double> density;     // S [m^4]

    bool operator==(const MeasuredRings&) const = default;
};

/// Reads a file of rings (library ocean::seafile). Throws Error bad_file "PATH:LINE: ..." unless it
/// has kMinRings .. kMaxRings rows, the wavenumbers are positive and increase, and the densities
/// are finite, at least 0 and not all 0.
MeasuredRings read_rings(const std::string& path);
/// Reads the text of a file of rings; `name` stands for the path in messages. Throws as read_rings.
MeasuredRings parse_rings(std::string_view text, const std::string& name);

}  // namespace ocean
