// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The division of the open sea into bands and sectors, by the variance that its spectrum has there.
#include "coast/statics/shore_bands.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"

namespace ocean {

namespace {

constexpr double kShareBelow = 2e-4;   // share of the variance below the lowest edge
constexpr double kHighestEdge = 80.0;  // highest edge over the lowest
constexpr double kLeastShare = 0.005;  // min share of the variance in a pair
constexpr double kLeastWidth = 1e-9;   // min relative width of all bands together
constexpr double kEdgeStep = 0.125;    // of the lattice of the outer edges [octaves]
constexpr auto kSectors = static_cast<std::size_t>(kShoreSectors);

using SectorSums = std::array<double, kSectors>;

/// Returns the integrals of a row over the sectors, exact for the table's interpolation, which is
/// linear between its columns and periodic.
SectorSums sector_sums(std::span<const double> row) {
    const std::size_t columns = row.size();
    const auto count = static_cast<double>(columns);
    std::vector<double> to_column(columns + 1);  // the integral from direction 0, in columns
    for (std::size_t j = 0; j < columns; ++j) {
        to_column[j + 1] = to_column[j] + 0.5 * (row[j] + row[(j + 1) % columns]);
    }
    SectorSums to_end;  // of a sector, from direction 0
    for (std::size_t s = 0; s < kSectors; ++s) {
        const double end = (static_cast<double>(s) + 0.5) / kShoreSectors * count;
        const auto j = static_cast<std::size_t>(end);
        const double part = end - static_cast<double>(j);
        const double next = row[(j + 1) % columns];
        to_end[s] = to_column[j] + part * (row[j] + 0.5 * part * (next - row[j]));
    }
    SectorSums sums;
    for (std::size_t s = 1; s < kSectors; ++s) sums[s] = to_end[s] - to_end[s - 1];
    sums[0] = to_end[0] + to_column[columns] - to_end[kSectors - 1];
    for (double& sum : sums) sum *= kTwoPi / count;
    return sums;
}

/// The spectrum by sectors: a row for each of its frequencies, linear between them.
class SectorSpectrum {
  public:
    explicit SectorSpectrum(const DirectionalSpectrum& spectrum)
        : omega_(spectrum.angular_frequencies()) {
        for (std::size_t i = 0; i < omega_.size(); ++i) {
            rows_.push_back(sector_sums(spectrum.row(i)));
        }
    }

    /// Returns the variance of the frequencies from .. to [rad/s] in each sector [m^2].
    SectorSums variance(double from, double to) const {
        SectorSums sums{};
        for (std::size_t i = 0; i + 1 < omega_.size(); ++i) {
            const double low = std::max(omega_[i], from);
            const double high = std::min(omega_[i + 1], to);
            if (low >= high) continue;
            const double v = (0.5 * (low + high) - omega_[i]) / (omega_[i + 1] - omega_[i]);
            for (std::size_t s = 0; s < kSectors; ++s) {
                sums[s] += (high - low) * (rows_[i][s] + v * (rows_[i + 1][s] - rows_[i][s]));
            }
        }
        return sums;
    }
    double whole_variance(double from, double to) const {
        double sum = 0.0;
        for (const double part : variance(from, to)) sum += part;
        return sum;
    }

  private:
    std::span<const double> omega_;
    std::vector<SectorSums> rows_;
};

/// The angular frequencies between which a sea has waves [rad/s].
struct FrequencyRange {
    double low;
    double high;
};

FrequencyRange frequencies_of(const DirectionalSpectrum& spectrum, const Dispersion& dispersion,
                              const SurfaceSettings& limits) {
    FrequencyRange range{spectrum.angular_frequencies().front(),
                         spectrum.angular_frequencies().back()};
    if (limits.longest_wavelength > 0.0) {
        const double omega = dispersion.angular_frequency(kTwoPi / limits.longest_wavelength);
        range.low = std::max(range.low, omega);
    }
    if (limits.shortest_wavelength > 0.0) {
        const double omega = dispersion.angular_frequency(kTwoPi / limits.shortest_wavelength);
        range.high = std::min(range.high, omega);
    }
    return range;
}

/// Returns the frequency below which `variance` lies, to rounding [rad/s].
double frequency_above(const SectorSpectrum& sectors, FrequencyRange range, double variance) {
    double low = range.low;
    double high = range.high;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high)) return low;
        (sectors.whole_variance(range.low, middle) < variance ? low : high) = middle;
    }
}

/// Returns the edge below or above a wavenumber, on a fixed lattice: seas that differ in height, or
/// little in period, have the same edges, and so the same delays over a bed, which take longest to
/// compute. Coarser steps serve more seas, but waste the bands: with half an octave groups in 2 m
/// of water are 3 % too fast (docs/figures/coast_figures.py).
double edge_below(double wavenumber) {
    return std::exp2(kEdgeStep * std::floor(std::log2(wavenumber) / kEdgeStep));
}
double edge_above(double wavenumber) {
    return std::exp2(kEdgeStep * std::ceil(std::log2(wavenumber) / kEdgeStep));
}

/// Returns the pairs that hold at least `variance`.
std::vector<ShoreWaves> pairs_above(double variance, const SectorSpectrum& sectors,
                                    FrequencyRange range, const Dispersion& dispersion,
                                    const std::array<double, kShoreBands + 1>& edges) {
    std::array<SectorSums, kShoreBands> part;
    for (std::size_t b = 0; b < kShoreBands; ++b) {
        part[b] =
            sectors.variance(std::max(dispersion.angular_frequency(edges[b]), range.low),
                             std::min(dispersion.angular_frequency(edges[b + 1]), range.high));
    }
    std::vector<ShoreWaves> pairs;
    for (std::size_t s = 0; s < kSectors; ++s) {
        for (std::size_t b = 0; b < kShoreBands; ++b) {
            if (part[b][s] < variance) continue;
            pairs.push_back({static_cast<int>(b), static_cast<int>(s), part[b][s]});
        }
    }
    return pairs;
}

}  // namespace

int ShoreBands::band_of(double wavenumber) const {
    if (!(wavenumber >= edges.front() && wavenumber < edges.back())) return -1;
    const auto above = std::upper_bound(edges.begin(), edges.end(), wavenumber);
    return static_cast<int>(above - edges.begin()) - 1;
}

int ShoreBands::sector_of(double direction) {
    const double turns = direction / kTwoPi;
    const double place = (turns - std::floor(turns)) * kShoreSectors + 0.5;
    return static_cast<int>(place) % kShoreSectors;
}

int ShoreBands::find(int band, int sector) const {
    for (std::size_t i = 0; i < waves.size(); ++i) {
        if (waves[i].band == band && waves[i].sector == sector) return static_cast<int>(i);
    }
    return -1;
}

ShoreBands choose_bands(const DirectionalSpectrum& spectrum, const Parameters& parameters) {
    ShoreBands bands;
    if (spectrum.flat()) return bands;
    const Dispersion dispersion(parameters.water);
    const SectorSpectrum sectors(spectrum);
    const FrequencyRange range = frequencies_of(spectrum, dispersion, parameters.surface);
    if (!(range.low < range.high)) return bands;
    const double whole = sectors.whole_variance(range.low, range.high);
    if (!(whole > 0.0)) return bands;

    const double lowest =
        edge_below(dispersion.wavenumber(frequency_above(sectors, range, kShareBelow * whole)));
    const double nyquist = kPi * parameters.grid.resolution / parameters.grid.patch_size *
                           cascade_divisors(parameters.grid).back();
    const double highest =
        std::min({kHighestEdge * lowest, nyquist, edge_above(dispersion.wavenumber(range.high))});
    if (!(highest > lowest * (1.0 + kLeastWidth))) return bands;
    const double ratio = std::pow(highest / lowest, 1.0 / kShoreBands);
    bands.edges.front() = lowest;
    for (std::size_t b = 1; b < kShoreBands; ++b) bands.edges[b] = bands.edges[b - 1] * ratio;
    bands.edges.back() = highest;

    bands.waves = pairs_above(kLeastShare * whole, sectors, range, dispersion, bands.edges);
    return bands;
}

}  // namespace ocean
