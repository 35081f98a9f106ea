// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How a coast divides the waves of the open sea: bands of wavenumbers, equal ratios apart, times
// sectors of directions, fixed in the world. The waves of one band and sector travel over the bed
// together: as one group delay, one transverse delay, one phase and one amplitude.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

inline constexpr int kShoreBands = 4;
inline constexpr int kShoreSectors = 9;
inline constexpr double kSectorWidth = kTwoPi / kShoreSectors;  // 40 degrees [rad]

/// Returns the direction to which the waves in the middle of a sector travel [rad]. Sector s
/// reaches from (s - 1/2) to (s + 1/2) times kSectorWidth and is half open, so that each mode is in
/// exactly one sector.
constexpr double sector_centre(int sector) {
    return sector * kSectorWidth;
}

/// The waves of one band in one sector.
struct ShoreWaves {
    int band = 0;
    int sector = 0;
    double variance = 0.0;  // of the open sea, from its spectrum [m^2]
};

/// The division of one sea. Wavenumbers are the open sea's, in water of its own depth.
struct ShoreBands {
    /// Ascending [rad/m]: band b has the wavenumbers edges[b] <= k < edges[b + 1].
    std::array<double, kShoreBands + 1> edges{};
    /// The pairs that hold energy, ordered by sector, then band. Empty for a flat sea.
    std::vector<ShoreWaves> waves;

    /// Returns the band of a wavenumber [rad/m], or -1.
    int band_of(double wavenumber) const;
    /// Returns the sector of a direction [rad].
    static int sector_of(double direction);
    /// Returns the index in `waves`, or -1 for waves that stay as they are in the open sea.
    int find(int band, int sector) const;
    /// Returns the wavenumber in the middle of a band [rad/m].
    double centre(int band) const {
        const auto b = static_cast<std::size_t>(band);
        return 0.5 * (edges[b] + edges[b + 1]);
    }
};

/// Returns the division of the sea of a spectrum. The lowest edge has all but 2e-4 of the variance
/// above it, the highest is 80 times as high, but not above the Nyquist line of the grid, the end
/// of the spectrum or the limit of shortest waves. `waves` lacks the pairs below 0.5 % of the
/// variance: these waves stay as they are in the open sea. Needs validated parameters. The result
/// depends on the arguments alone.
ShoreBands choose_bands(const DirectionalSpectrum& spectrum, const Parameters& parameters);

}  // namespace ocean
