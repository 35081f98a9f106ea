// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spectrum of measured land as a table: the mean density in rings of the wavenumber plane.
// Files of rings are CSV with the columns `wavenumber` [rad/m] and `density` [m^4]; further
// columns, such as `count`, `model` and `residual`, are for people and are not read.
#pragma once

#include <cstddef>
#include <vector>

namespace ocean {

inline constexpr std::size_t kMinRings = 2;
inline constexpr std::size_t kMaxRings = 4096;

/// A density over (kx, ky), isotropic: variance = integral of S dkx dky. Wavenumbers increase.
struct MeasuredRings {
    std::vector<double> wavenumber;  // [rad/m]
    std::vector<double> density;     // S [m^4]

    bool operator==(const MeasuredRings&) const = default;
};

}  // namespace ocean
