// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The properties of a sea's modes that depend on lattice, water, loop, limits and seed and not on
// the waves: the position of their cells in frequency and direction, the noise, the phase rates.
// While the wind changes live, only the amplitudes are recomputed. This is the stage between the
// spectrum table and the modes.
#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ocean/internal/modes.hpp"
#include "ocean/parameters.hpp"
#include "waves/modes/quadrant_variances.hpp"

namespace ocean {

class QuadrantSampler;
class ThreadPool;

/// The position of a mode relative to the band and to the limits of `parameters.surface`.
enum class BandSide { too_long, inside, too_short };
BandSide band_side(const Parameters& parameters, const CascadeBand& band, int n, int m);

/// Returns the strongest known wind, which causes the whitecaps [m/s]; unset if no wind is known.
std::optional<double> strongest_wind(const Parameters& parameters);

/// Returns the points along each side of a mode's cell, `length` steps of the lattice from its
/// origin: 1, or an even number. The cell is cut into parts, 1/48 of a wavenumber and of a radian
/// wide, with the two points of [Gauss 1814] along each side: closer than the narrowest beams and
/// peaks of the table. Farther than 96 steps out the cell itself is small. Test:
/// Statistics.EveryRecordKeepsItsEnergyOnEveryPatch.
int samples_per_cell_side(double length);
/// Returns the position of a point in its cell, -1/2 .. 1/2.
double sample_offset(int sample, int side);

/// The points at which the spectrum is read for the modes (+-n, m) and (+-n, -m) of one m >= 0: the
/// points of their cells in the first quadrant. Cells begin .. several - 1 have more than one
/// point; cells several .. end - 1 have one; other cells have no waves.
struct QuadrantRow {
    int begin = 0;
    int several = 0;
    int end = 0;
    std::vector<std::uint32_t> points;  // number of points of each cell up to `several`
    std::vector<double> omega;          // rad/s
    std::vector<double> direction;      // turns, 0 .. 1/4
    std::vector<double> weight;         // c_g / k times the area that the point represents
};

/// The modes n = begin .. end - 1.
struct ModeRange {
    int begin = 0;
    int end = 0;
};

/// Immutable, so that several seas may share one.
class ModeLattice {
  public:
    /// keep: points and noise are kept for the next build, 14 bytes a mode, nearly as much as the
    /// modes themselves. With more than kLargestKept modes along a side nothing is kept, because
    /// the wind of such a sea is not changed live.
    enum class Memory { none, keep };
    static constexpr int kLargestKept = 2048;
    static std::uint64_t kept_bytes(const Grid& grid);

    /// Makes the lattice of the sea's cascades.
    ModeLattice(const Parameters& parameters, Memory memory, ThreadPool& pool);
    /// Makes one band alone of the lattice of parameters.grid, with divisor 1 and with noise of
    /// that number; 0 .. 4 belong to the cascades.
    ModeLattice(const Parameters& parameters, const CascadeBand& band, std::uint32_t noise,
                Memory memory, ThreadPool& pool);

    /// Returns true if this is the lattice of the sea `parameters`.
    bool is_of(const Parameters& parameters) const;
    /// Returns true if nothing remains to be kept.
    bool is_kept() const { return kept_ || parameters_.grid.resolution > kLargestKept; }

    /// Returns the modes of still water: rates and displacements, no waves.
    Modes still_modes(ThreadPool& pool) const;
    /// Sets the waves of `modes`, which must belong to this lattice; overwrites previous waves. The
    /// bits are the same for any number of threads, and with or without kept data. Returns the gain
    /// of the energy of each cascade, band_gain().
    std::vector<double> set_waves(const DirectionalSpectrum& spectrum, double wind_speed,
                                  ThreadPool& pool, Modes& modes) const;

    /// Writes modal_variance of row m >= 0 of a cascade, to rounding.
    void variances(const QuadrantSampler& spectrum, std::size_t cascade, int m,
                   QuadrantVariances& variances) const;

  private:
    struct Cascade {
        CascadeBand band;
        std::uint32_t noise_number;
        Lattice lattice;
        std::vector<QuadrantRow> rows;  // m = 0 .. N/2 - 1; empty if nothing is kept
        std::vector<std::complex<float>> noise;
    };
    struct Work;
    class ShellSums;

    /// Adds the next cascade to this lattice.
    void add(const CascadeBand& band, std::uint32_t noise_number, ThreadPool& pool);
    QuadrantRow make_row(const Cascade& cascade, int m) const;
    /// Returns the kept row, or makes it in `made`.
    const QuadrantRow& row_of(const Cascade& cascade, int m, QuadrantRow& made) const;
    /// Draws row m, which may be negative, in FFT order: modes (n, m) of `east` and (-n, m) of
    /// `west`.
    void draw_row(const Cascade& cascade, int m, ModeRange east, ModeRange west,
                  std::span<std::complex<float>> noise) const;
    static void clear_row(int m, CascadeModes& modes);
    void set_rates(const Cascade& cascade, int m, CascadeModes& modes) const;
    /// Sets the waves of a cascade. Returns the variance of its modes that satisfy measures_band.
    double set_cascade(const Cascade& cascade, const QuadrantSampler& sampler, ThreadPool& pool,
                       CascadeModes& modes) const;
    void set_row(const Cascade& cascade, const QuadrantSampler& sampler, int m, Work& work,
                 ShellSums& sums, CascadeModes& modes) const;

    Parameters parameters_;  // without the waves
    bool kept_ = false;
    std::vector<Cascade> cascades_;
};

}  // namespace ocean
