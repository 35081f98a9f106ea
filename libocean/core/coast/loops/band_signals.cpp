// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the modes of the pairs to spline coefficients of one time; see band_signals.hpp. The reads
// are in band_reads.cpp.
#include "coast/loops/band_signals.hpp"

#include <algorithm>
#include <cmath>

#include "wave/wave.hpp"

namespace ocean {

namespace formula = wave::double_precision;

namespace {

constexpr auto kBatch = static_cast<std::size_t>(kFftBatch);
constexpr std::size_t kColumnsBefore = 1;  // coefficients in a row before the first column
constexpr std::size_t kColumnsBeyond = 4;  // before and after: three after the last

/// Returns e^(-i omega t) of a mode.
std::complex<double> phase_of(double rate, double tau) {
    const double turns = formula::phase_turns(rate, 0.0, tau, 0.0);
    const formula::SinCos phase = formula::sin_cos_turns(turns);
    return {phase.cosine, -phase.sine};
}

}  // namespace

BandSignals::BandSignals(const Modes& modes, const ShoreBands& bands, double spline_tolerance,
                         bool rates)
    : rates_(rates) {
    clock_.loop_period = modes.loop_period;
    std::vector<BandLattice> lattices = gather_bands(modes, bands);
    const std::vector<std::array<int, 2>> sides = choose_sides(lattices, spline_tolerance);
    band_sectors_.resize(lattices.size());
    for (std::size_t i = 0; i < band_sectors_.size(); ++i) {
        band_sectors_[i].lattice = std::move(lattices[i]);
        prepare(band_sectors_[i], sides[i]);
    }
    for (std::size_t map = 0; map < (rates ? 2u : 1u); ++map) {
        for (std::size_t i = 0; i < band_sectors_.size(); ++i) {
            const int rows = 2 * band_sectors_[i].lattice.reach[1] + 1;
            for (int m = 0; m < rows; m += kFftBatch) row_batches_.push_back({i, map, m});
            for (int c = 0; c < sides[i][0]; c += kFftBatch) column_batches_.push_back({i, map, c});
        }
    }
}

void BandSignals::prepare(BandSector& pair, std::array<int, 2> side) const {
    const BandLattice& lattice = pair.lattice;
    pair.side = side;
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        const int reach = lattice.reach[axis];
        pair.fft.emplace_back(side[axis], reach);
        for (int n = -reach; n <= reach; ++n) {
            pair.gain[axis].push_back(static_cast<float>(spline_gain(n, side[axis])));
        }
    }
    std::size_t at = 0;
    for (int m = -lattice.reach[1]; m <= lattice.reach[1]; ++m) {
        pair.row_begin.push_back(at);
        while (at < lattice.modes.size() && lattice.modes[at].m == m) ++at;
    }
    pair.row_begin.push_back(at);
    const auto width = static_cast<std::size_t>(side[0]);
    const auto height = static_cast<std::size_t>(side[1]);
    for (std::size_t map = 0; map < (rates_ ? 2u : 1u); ++map) {
        pair.rows[map].resize(pair.gain[1].size() * (width / kBatch));
        pair.map[map].pitch = width + kColumnsBeyond;
        pair.map[map].values.resize(2 * height * pair.map[map].pitch);
    }
}

void BandSignals::move_to(double time, ThreadPool& pool, bool rates, const SignalCells* cells) {
    const double tau = clock_.tau(time);
    has_rates_ = rates_ && rates;
    is_whole_ = cells == nullptr;
    const std::size_t parts = rates_ && !rates ? 2 : 1;
    work_.resize(static_cast<std::size_t>(pool.size()));
    pool.for_each_item(static_cast<int>(row_batches_.size() / parts), [&](int item, int thread) {
        transform_rows(row_batches_[static_cast<std::size_t>(item)], tau, cells,
                       work_[static_cast<std::size_t>(thread)]);
    });
    pool.for_each_item(static_cast<int>(column_batches_.size() / parts), [&](int item, int thread) {
        transform_columns(column_batches_[static_cast<std::size_t>(item)], cells,
                          work_[static_cast<std::size_t>(thread)]);
    });
}

/// Propagates the modes of kFftBatch rows, transforms them along x and stores them row by row.
void BandSignals::transform_rows(const Batch& batch, double tau, const SignalCells* cells,
                                 Work& work) {
    BandSector& pair = band_sectors_[batch.pair];
    const BandLattice& lattice = pair.lattice;
    const auto first = static_cast<std::size_t>(batch.first);
    const std::size_t last = std::min(first + kBatch, pair.gain[1].size());
    work.spectrum.assign(pair.gain[0].size(), BatchRow{});
    for (std::size_t row = first; row < last; ++row) {
        for (std::size_t i = pair.row_begin[row]; i < pair.row_begin[row + 1]; ++i) {
            const BandMode& mode = lattice.modes[i];
            std::complex<double> h =
                std::complex<double>(mode.amplitude) * phase_of(mode.rate, tau);
            if (batch.map == 1) {
                const double omega = kTwoPi * clock_.rate_unit() * mode.rate;
                h = {omega * h.imag(), -omega * h.real()};
            }
            const auto column = static_cast<std::size_t>(mode.n + lattice.reach[0]);
            h *= pair.gain[0][column] * pair.gain[1][row];
            work.spectrum[column].re[row - first] += static_cast<float>(h.real());
            work.spectrum[column].im[row - first] += static_cast<float>(h.imag());
        }
    }
    const auto width = static_cast<std::size_t>(pair.side[0]);
    if (work.samples.size() < width) work.samples.resize(width);
    const std::uint8_t* const needed =
        cells == nullptr ? nullptr : cells->pairs[batch.pair].columns.data();
    pair.fft[0].transform(work.spectrum.data(), 1, {.work = work.samples.data(), .needed = needed});
    for (std::size_t x = 0; x < width; x += kBatch) {
        if (needed != nullptr && needed[x] == 0) continue;
        for (std::size_t row = first; row < last; ++row) {
            BatchRow& to = pair.rows[batch.map][(row * width + x) / kBatch];
            for (std::size_t i = 0; i < kBatch; ++i) {
                to.re[i] = work.samples[x + i].re[row - first];
                to.im[i] = work.samples[x + i].im[row - first];
            }
        }
    }
}

/// Transforms kFftBatch columns along y and stores them as coefficients.
void BandSignals::transform_columns(const Batch& batch, const SignalCells* cells, Work& work) {
    BandSector& pair = band_sectors_[batch.pair];
    SplineRows& map = pair.map[batch.map];
    const auto width = static_cast<std::size_t>(pair.side[0]);
    const auto height = static_cast<std::size_t>(pair.side[1]);
    const auto first = static_cast<std::size_t>(batch.first);
    const std::uint8_t* needed = nullptr;
    if (cells != nullptr) {
        const SignalCells::Pair& of = cells->pairs[batch.pair];
        if (of.columns[first] == 0) return;
        needed = of.rows.data() + first / kBatch * height;
    }
    if (work.samples.size() < height) work.samples.resize(height);
    float* const coefficients = map.values.data();
    pair.fft[1].transform(pair.rows[batch.map].data() + first / kBatch, width / kBatch,
                          {.work = work.samples.data(),
                           .needed = needed,
                           .numbers = coefficients + 2 * (kColumnsBefore + first),
                           .pitch = map.pitch});
    const auto copy = [&](std::size_t from, std::size_t to, std::size_t count) {
        for (std::size_t y = 0; y < height; ++y) {
            if (needed != nullptr && needed[y] == 0) continue;
            float* const row = coefficients + 2 * y * map.pitch;
            std::copy_n(row + 2 * from, 2 * count, row + 2 * to);
        }
    };
    if (first == 0) copy(kColumnsBefore, kColumnsBefore + width, kColumnsBeyond - kColumnsBefore);
    if (first + kBatch == width) copy(width, 0, kColumnsBefore);
}

SignalCells BandSignals::no_cells() const {
    SignalCells cells;
    for (const BandSector& pair : band_sectors_) {
        const auto width = static_cast<std::size_t>(pair.side[0]);
        const auto height = static_cast<std::size_t>(pair.side[1]);
        cells.pairs.push_back(
            {std::vector<std::uint8_t>(width), std::vector<std::uint8_t>(width / kBatch * height)});
    }
    return cells;
}

void BandSignals::add_cells(std::size_t index, std::size_t n, const double* x, const double* y,
                            SignalCells& cells) const {
    // The four columns and rows about a place, and one on each side: a place between two cells is
    // read in either.
    constexpr std::int64_t kBefore = 2, kBeyond = 3;
    const BandSector& of = band_sectors_[index];
    SignalCells::Pair& pair = cells.pairs[index];
    const auto cell = [&](double place, std::size_t axis) {
        return static_cast<std::int64_t>(std::floor(place * of.side[axis] / of.lattice.period));
    };
    const auto wrapped = [&](std::int64_t at, std::size_t axis) {
        return static_cast<std::size_t>(at & (of.side[axis] - 1));
    };
    const auto height = static_cast<std::size_t>(of.side[1]);
    for (std::size_t i = 0; i < n; ++i) {
        const std::int64_t column = cell(x[i], 0);
        const std::int64_t row = cell(y[i], 1);
        for (std::int64_t c = column - kBefore; c <= column + kBeyond; ++c) {
            const std::size_t batch = wrapped(c, 0) / kBatch;
            std::fill_n(pair.columns.begin() + static_cast<std::ptrdiff_t>(batch * kBatch), kBatch,
                        std::uint8_t{1});
            for (std::int64_t r = row - kBefore; r <= row + kBeyond; ++r) {
                pair.rows[batch * height + wrapped(r, 1)] = 1;
            }
        }
    }
}

ExactSignal BandSignals::exact(std::size_t index, double time, double x, double y) const {
    const BandLattice& lattice = band_sectors_[index].lattice;
    const double tau = clock_.tau(time);
    const double turns_x = x / lattice.period - std::floor(x / lattice.period);
    const double turns_y = y / lattice.period - std::floor(y / lattice.period);
    const double step = kTwoPi / lattice.period;
    ExactSignal sum;
    for (const BandMode& mode : lattice.modes) {
        const int n = mode.n + lattice.carrier[0];
        const int m = mode.m + lattice.carrier[1];
        const formula::SinCos place = formula::sin_cos_turns(n * turns_x + m * turns_y);
        const std::complex<double> wave = std::complex<double>(mode.amplitude) *
                                          phase_of(mode.rate, tau) *
                                          std::complex<double>(place.cosine, place.sine);
        const std::complex<double> turned(-wave.imag(), wave.real());  // times i
        sum.value += wave;
        sum.by_x += step * n * turned;
        sum.by_y += step * m * turned;
        sum.rate -= kTwoPi * clock_.rate_unit() * mode.rate * turned;
    }
    return sum;
}

std::uint64_t BandSignals::samples() const {
    std::uint64_t sum = 0;
    for (const BandSector& pair : band_sectors_) {
        sum += static_cast<std::uint64_t>(pair.side[0]) * static_cast<std::uint64_t>(pair.side[1]);
    }
    return sum;
}

std::uint64_t BandSignals::bytes() const {
    std::uint64_t sum = 0;
    for (const BandSector& pair : band_sectors_) {
        sum += pair.lattice.modes.size() * sizeof(BandMode);
        for (const BatchFft& fft : pair.fft) sum += fft.bytes();
        for (const std::vector<BatchRow>& rows : pair.rows) sum += rows.size() * sizeof(BatchRow);
        for (const SplineRows& map : pair.map) sum += map.values.size() * sizeof(float);
    }
    return sum;
}

}  // namespace ocean
