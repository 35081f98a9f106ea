// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The analytic signals of the pairs of a band and a sector at one time, for reads at any place:
//
//   eta(x, t) = sum over the modes of the pair of 2 h0(k) e^(i (k.x - omega t))
//
// Its real part is the height that these waves have in the open sea, its modulus their envelope.
// Each pair is one complex inverse transform about a carrier K near its middle, e^(-i K.x) eta, to
// the coefficients of a cubic B-spline (waves/query/spline_map.hpp has its theory). This is the
// stage between the modes of the sea and the coast, which reads the signals at shifted places.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/batch_fft.hpp"
#include "coast/loops/band_lattice.hpp"
#include "coast/loops/signal_task.hpp"
#include "coast/statics/shore_bands.hpp"
#include "ocean/internal/coast_waves.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// A signal at a place, summed mode by mode.
struct ExactSignal {
    std::complex<double> value;  // [m]
    std::complex<double> by_x;
    std::complex<double> by_y;
    std::complex<double> rate;  // [m/s]
};

/// The coefficients that reads at certain places take.
struct SignalCells {
    struct Pair {
        std::vector<std::uint8_t> columns;  // a flag for each column; equal in a batch of columns
        std::vector<std::uint8_t> rows;     // of each batch of columns, a flag for each row
    };
    std::vector<Pair> pairs;
};

/// Copies are independent. Several threads may read one object while none moves it.
class BandSignals {
  public:
    /// Copies the needed data from the modes. spline_tolerance: the rms error of a read of all
    /// pairs together, relative to their rms. The gradient's error is about (error)^(3/4), see
    /// spline_map.hpp. Single precision limits both to about 2e-7. `rates` doubles the memory.
    /// Reads are allowed after the first move_to.
    BandSignals(const Modes& modes, const ShoreBands& bands, double spline_tolerance = 2e-6,
                bool rates = false);
    /// Makes the maps of a time [s]. `rates`: those of rates too, if the signals have them, which
    /// doubles the work. The bits are the same for any number of threads. `cells`: coefficients
    /// beside these are left as they are; nullptr: all are made.
    void move_to(double time, ThreadPool& pool, bool rates = true,
                 const SignalCells* cells = nullptr);
    /// Returns whether all coefficients are those of the time.
    bool is_whole() const { return is_whole_; }
    /// Returns cells without a flag.
    SignalCells no_cells() const;
    /// Flags the coefficients that reads of pair `index` at n finite places [m] take. Other threads
    /// may flag those of other pairs.
    void add_cells(std::size_t index, std::size_t n, const double* x, const double* y,
                   SignalCells& cells) const;
    /// Returns whether rates of the time may be read.
    bool has_rates() const { return has_rates_; }
    /// Returns the number of pairs: ShoreBands::waves.size().
    std::size_t count() const { return band_sectors_.size(); }
    /// Writes the signals of pair `index` at n finite places [m]; the sea's period wraps. Throws
    /// Error invalid_value for a rate of maps that were made without rates.
    void read(std::size_t index, std::size_t n, const double* x, const double* y,
              const SignalOutputs& out) const;
    /// Writes the maps of pair `index` and the mapping of places into them. Valid until the next
    /// move_to.
    void describe(std::size_t index, CoastBandSector& pair) const;
    /// Returns the signal of pair `index` at a time and a place, in double, from its modes: slow,
    /// and independent of move_to.
    ExactSignal exact(std::size_t index, double time, double x, double y) const;
    /// Returns the number of complex samples of all maps of one time, without the maps of rates.
    std::uint64_t samples() const;
    std::uint64_t bytes() const;

  private:
    /// A SignalMap with its coefficients.
    struct SplineRows {
        std::size_t pitch = 0;
        PageVector<float> values;
    };
    struct BandSector {
        BandLattice lattice;
        std::array<int, 2> side{};
        std::vector<BatchFft> fft;                  // along x and y
        std::array<std::vector<float>, 2> gain;     // spline_gain of -reach .. reach
        std::vector<std::size_t> row_begin;         // of each row m = -reach .. reach, and the end
        std::array<std::vector<BatchRow>, 2> rows;  // of values and rates, transformed along x
        std::array<SplineRows, 2> map;              // of values and rates
    };
    /// kFftBatch rows or columns of a map: work for one thread.
    struct Batch {
        std::size_t pair;
        std::size_t map;
        int first;
    };
    struct Work {
        std::vector<BatchRow> spectrum;
        std::vector<BatchRow> samples;
    };
    void prepare(BandSector& pair, std::array<int, 2> side) const;
    void transform_rows(const Batch& batch, double tau, const SignalCells* cells, Work& work);
    void transform_columns(const Batch& batch, const SignalCells* cells, Work& work);

    Modes clock_;  // without arrays: converts time to tau
    bool rates_;
    bool has_rates_ = false;  // in the maps of the time
    bool is_whole_ = false;
    SignalLoop loop_ = signal_loop(simd_level());
    std::vector<BandSector> band_sectors_;
    std::vector<Batch> row_batches_;  // those of the values first, as many of the rates
    std::vector<Batch> column_batches_;
    std::vector<Work> work_;  // one for each thread
};

/// Returns the modes that are in no pair, which stay as they are in the open sea; h0 of the other
/// modes is 0. The covariance of gradients of each shell is reduced to the share that the remaining
/// modes have in this draw. Lattices and lattice_revision equal those of `modes`.
Modes open_remainder(const Modes& modes, const ShoreBands& bands);

}  // namespace ocean
