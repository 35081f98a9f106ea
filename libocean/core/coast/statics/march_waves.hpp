// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The energy that marches over a bed: the open sea's energy by direction, joined into groups of
// sectors with one march each, and how depth changes the speed and the energy of each band.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/parameters.hpp"
#include "shore_bands.hpp"

namespace ocean {

/// Waves that a march tracks by a tag of their own.
struct MarchWave {
    int band = 0;
    double variance = 0.0;           // of the open sea [m^2]
    std::vector<float> bin_share{};  // of the variance, by bin of directions
};

/// Sectors that march together.
struct MarchGroup {
    double direction = 0.0;              // of the march [rad]
    std::vector<std::size_t> members{};  // indices in ShoreBands::waves
    std::vector<MarchWave> waves{};      // one for each member
};

/// The bins of directions of a march, relative to the march's direction: odd in number, about 0, to
/// +-75 degrees.
struct DirectionBins {
    double width = 0.0;  // [rad]
    int count = 0;

    static DirectionBins of_width(double width);
    double centre(int bin) const { return (bin - (count - 1) / 2) * width; }
    double edge(int bin) const { return centre(bin) - 0.5 * width; }  // the lower one
};

/// The waves of a sea, grouped for marching.
struct MarchSea {
    std::vector<MarchGroup> groups{};  // ordered by their first sector
    /// The directions of the waves of the sea [rad]: the direction of highest energy of each of its
    /// systems, and 15 and 30 degrees to either side.
    std::vector<double> incoming{};
};

/// Returns the waves of a sea. Empty for a flat sea.
MarchSea make_march_sea(const ShoreBands& bands, const DirectionalSpectrum& spectrum,
                        const Water& water, const DirectionBins& bins);
/// Returns the group with its waves joined band by band, for a march without tags.
MarchGroup without_sectors(const MarchGroup& group);

/// A band at each depth of a table.
struct BandDepths {
    double open_group_speed = 0.0;   // mean in the open sea [m/s]
    std::vector<float> log_speed{};  // ln(c / open sea's c), the mean over its energy
    std::vector<float> shoaling{};   // energy relative to the open sea, at equal flux
};

/// How the bands change with depth. Depths are the entries least * ratio^n; between them, tables
/// are linear in the logarithm of depth.
class DepthTables {
  public:
    DepthTables(const ShoreBands& bands, const DirectionalSpectrum& spectrum, const Water& water,
                double min_depth);

    /// Returns the position of a depth [m] in the tables, within their ends.
    float position(double depth) const;
    const BandDepths& band(int b) const { return bands_[static_cast<std::size_t>(b)]; }
    double peak_frequency() const { return peak_frequency_; }  // of the sea [Hz]
    double min_depth() const { return least_; }                // shallower water counts as this [m]
    double max_depth() const { return greatest_; }  // deeper water counts as the open sea

  private:
    double least_ = 0.0;
    double greatest_ = 0.0;
    double per_log_ = 0.0;
    double peak_frequency_ = 0.0;
    std::array<BandDepths, kShoreBands> bands_{};
};

/// Returns the entry of a table at a position, linear between entries.
inline float read_table(const std::vector<float>& table, float position) {
    const auto n = static_cast<std::size_t>(position);
    if (n + 1 >= table.size()) return table.back();
    return table[n] + (position - static_cast<float>(n)) * (table[n + 1] - table[n]);
}

}  // namespace ocean
