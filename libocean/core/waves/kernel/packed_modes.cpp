// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Gathers the modes of all cascades into the packets of their map.
#include "packed_modes.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "ocean/thread_pool.hpp"

namespace ocean {

namespace {

/// Rows of numbers of one block of ky, [kx][lane] each.
enum Number { kPRe, kPIm, kQRe, kQIm, kRateHigh, kRateLow, kDisplacement, kNumbers };

int whole_columns(const MapModes& modes, int second_factor) {
    const int unit = std::max(second_factor, 16);
    return std::min((modes.half_band() + unit - 1) / unit * unit, modes.resolution / 2);
}

}  // namespace

/// Packs block after block of `lanes` neighbouring ky.
class PackedModes::Packing {
  public:
    Packing(const MapModes& modes, const ModeFactor& factor, int lanes)
        : modes_(modes),
          factor_(factor),
          lanes_(lanes),
          size_(modes.resolution),
          first_(first_factor(size_)),
          second_(size_ / first_) {}

    /// Assigns the positions of the packets by the lattices of the cascades alone, so that a change
    /// of the spectrum moves none. Returns the floats of all packets.
    std::uint64_t lay_out(int blocks, std::vector<ModeGroup>& groups) const {
        std::uint64_t floats = 0;
        std::vector<char> occupied(static_cast<std::size_t>(size_));
        for (int block = 0; block < blocks; ++block) {
            mark_occupied(block, occupied);
            for (int j = 0; j < second_ / 2; ++j) {
                ModeGroup group{0, floats};
                for (int i = 0; i < first_; ++i) {
                    const auto kx = kx_of(j, i);
                    if (occupied[kx.first] != 0 || occupied[kx.second] != 0) {
                        group.present |= std::uint64_t{1} << i;
                        floats += packet_floats(j);
                    }
                }
                groups.push_back(group);
            }
        }
        return floats;
    }

    /// Returns the numbers of a block, [number][kx][lane], zero where no cascade has a mode.
    std::vector<float> dense_block() const {
        return std::vector<float>(static_cast<std::size_t>(kNumbers * size_ * lanes_));
    }

    /// Packs a block. `dense`: from dense_block or from another block.
    void pack(int block, const ModeGroup* groups, Numbers numbers, std::vector<float>& dense,
              float* packets) const {
        // A single cascade has the same positions in every block and overwrites them.
        if (modes_.cascades.size() > 1) std::fill(dense.begin(), dense.end(), 0.0f);
        for (std::size_t c = 0; c < modes_.cascades.size(); ++c) gather(c, block, numbers, dense);
        const auto row = [&](Number number, std::size_t kx) {
            return dense.data() +
                   (static_cast<std::size_t>(number) * static_cast<std::size_t>(size_) + kx) *
                       static_cast<std::size_t>(lanes_);
        };
        for (int j = 0; j < second_ / 2; ++j) {
            float* to = packets + groups[j].first_packet;
            const auto append = [&](Number first, Number last, std::size_t kx) {
                for (int number = first; number <= last; ++number) {
                    to = std::copy_n(row(static_cast<Number>(number), kx), lanes_, to);
                }
            };
            for (int i = 0; i < first_; ++i) {
                if ((groups[j].present >> i & 1) == 0) continue;
                const auto kx = kx_of(j, i);
                append(kPRe, kQIm, kx.first);
                append(kPRe, kQIm, kx.second);
                if (numbers == Numbers::amplitudes) {
                    to += (j == 0 ? 2 : 1) * (kNumbers - kRateHigh) * lanes_;
                    continue;
                }
                // Either mode of a pair may be missing on a lattice, but a missing mode has no
                // energy.
                append(kRateHigh, kDisplacement, kx.first);
                if (j == 0) append(kRateHigh, kDisplacement, kx.second);
            }
        }
    }

    /// Returns true if the modes of a row stand side by side on the map, as h0 has them.
    bool is_plain() const {
        return modes_.cascades.size() == 1 && modes_.stride(modes_.cascades[0]) == 1 && !factor_;
    }

    /// Packs the amplitudes of a block again; is_plain() must hold. to(kx): the place of kx, an FFT
    /// index of the map, in the packets of the block.
    template <typename To>
    void pack_amplitudes(int block, const To& to) const {
        // So many modes of each row at a time that rows and packets, whose strides are multiples of
        // a cache's sets, stay in L1.
        constexpr int kTile = 16;
        const int half = modes_.half(modes_.cascades[0]);
        for (int first = -half; first < half; first += kTile) {
            float* target[kTile];
            for (int i = 0; i < kTile; ++i) {
                target[i] = first + i > -half ? to(fft_index(first + i, size_)) : nullptr;
            }
            for (int lane = 0; lane < lanes_ && block * lanes_ + lane < half; lane += kSquare) {
                for (int i = 0; i < kTile; i += kSquare) {
                    pack_square(first + i, block * lanes_ + lane, lane, target + i);
                }
            }
        }
    }

  private:
    /// Modes along each side of a square that is turned in registers.
    static constexpr int kSquare = 4;
    using Four = float __attribute__((vector_size(kSquare * sizeof(float))));
    struct FourModes {
        Four re;
        Four im;
    };

    static Four load_four(const std::complex<float>* first) {
        Four four;
        std::memcpy(&four, first, sizeof(four));
        return four;
    }
    static FourModes four_modes(const std::complex<float>* first) {
        const Four low = load_four(first);
        const Four high = load_four(first + 2);
        return {__builtin_shufflevector(low, high, 0, 2, 4, 6),
                __builtin_shufflevector(low, high, 1, 3, 5, 7)};
    }
    /// Returns the modes at n, n - 1, n - 2, n - 3 of a row.
    static FourModes four_modes_back(const std::complex<float>* row, int n, int width) {
        std::complex<float> around[kSquare];
        const std::complex<float>* first = around;
        if (n == 0) {
            std::copy_n(row + width - 3, 3, around);
            around[3] = row[0];
        } else {
            first = row + fft_index(n, width) - 3;
        }
        const Four low = load_four(first);
        const Four high = load_four(first + 2);
        return {__builtin_shufflevector(low, high, 6, 4, 2, 0),
                __builtin_shufflevector(low, high, 7, 5, 3, 1)};
    }

    /// Packs the amplitudes of the modes n .. n + 3 of the rows ky .. ky + 3. target: of each n;
    /// null: the map does not hold it.
    void pack_square(int n, int ky, int lane, float* const* target) const {
        const CascadeModes& cascade = modes_.cascades[0];
        const int width = cascade.lattice.resolution;
        const auto row = [&](int m) {
            return &cascade.h0[static_cast<std::size_t>(fft_index(m, width)) *
                               static_cast<std::size_t>(width)];
        };
        Four numbers[kRateHigh][kSquare];  // of the modes of each row
        for (int i = 0; i < kSquare; ++i) {
            const FourModes a = four_modes(row(ky + i) + fft_index(n, width));
            const FourModes b = four_modes_back(row(-ky - i), -n, width);
            numbers[kPRe][i] = a.re + b.re;
            numbers[kPIm][i] = a.im - b.im;
            numbers[kQRe][i] = a.im + b.im;
            numbers[kQIm][i] = b.re - a.re;
        }
        for (int number = 0; number < kRateHigh; ++number) {
            const Four(&in)[kSquare] = numbers[number];
            const Four low01 = __builtin_shufflevector(in[0], in[1], 0, 4, 1, 5);
            const Four high01 = __builtin_shufflevector(in[0], in[1], 2, 6, 3, 7);
            const Four low23 = __builtin_shufflevector(in[2], in[3], 0, 4, 1, 5);
            const Four high23 = __builtin_shufflevector(in[2], in[3], 2, 6, 3, 7);
            const Four out[kSquare] = {__builtin_shufflevector(low01, low23, 0, 1, 4, 5),
                                       __builtin_shufflevector(low01, low23, 2, 3, 6, 7),
                                       __builtin_shufflevector(high01, high23, 0, 1, 4, 5),
                                       __builtin_shufflevector(high01, high23, 2, 3, 6, 7)};
            for (int i = 0; i < kSquare; ++i) {
                if (target[i] == nullptr) continue;
                std::memcpy(target[i] + number * lanes_ + lane, &out[i], sizeof(out[i]));
            }
        }
    }

    std::size_t packet_floats(int j) const {
        return static_cast<std::size_t>((j == 0 ? kSinglesNumbers : kPairNumbers) * lanes_);
    }

    /// Returns the two kx of packet i of group j.
    std::pair<std::size_t, std::size_t> kx_of(int j, int i) const {
        const int kx = j + second_ * i;
        const int other = j == 0 ? second_ / 2 + second_ * i : size_ - kx;
        return {static_cast<std::size_t>(kx), static_cast<std::size_t>(other)};
    }

    /// The lanes of a block that are rows of the cascade, and those rows.
    struct LaneRow {
        int lane;
        int row;
    };
    std::vector<LaneRow> rows_in(const CascadeModes& cascade, int block) const {
        const int stride = modes_.stride(cascade);
        std::vector<LaneRow> rows;
        for (int lane = 0; lane < lanes_; ++lane) {
            const int ky = block * lanes_ + lane;
            if (ky % stride == 0 && ky / stride < modes_.half(cascade)) {
                rows.push_back({lane, ky / stride});
            }
        }
        return rows;
    }

    void mark_occupied(int block, std::vector<char>& occupied) const {
        std::fill(occupied.begin(), occupied.end(), char{0});
        for (const CascadeModes& cascade : modes_.cascades) {
            if (rows_in(cascade, block).empty()) continue;
            const int half = modes_.half(cascade);
            for (int n = -half + 1; n < half; ++n) {
                const int kx = fft_index(n * modes_.stride(cascade), size_);
                occupied[static_cast<std::size_t>(kx)] = 1;
            }
        }
    }

    /// Writes the modes of one cascade to their positions, in tiles that stay in L1 while all lanes
    /// write.
    void gather(std::size_t number, int block, Numbers numbers, std::vector<float>& dense) const {
        constexpr int kTile = 64;
        const CascadeModes& cascade = modes_.cascades[number];
        const int half = modes_.half(cascade);
        const std::vector<LaneRow> rows = rows_in(cascade, block);
        for (int n = -half + 1; n < half; n += kTile) {
            for (const LaneRow& row : rows) {
                gather_row(number, row, n, std::min(n + kTile, half), numbers, dense);
            }
        }
    }

    /// Gathers kx = first .. last - 1 of one lane.
    void gather_row(std::size_t number, const LaneRow& lane_row, int first, int last,
                    Numbers numbers, std::vector<float>& dense) const {
        const CascadeModes& cascade = modes_.cascades[number];
        const int width = cascade.lattice.resolution;
        const int stride = modes_.stride(cascade);
        const bool alone = modes_.cascades.size() == 1;
        const auto lanes = static_cast<std::size_t>(lanes_);
        const std::size_t plane = static_cast<std::size_t>(size_) * lanes;
        for (int n = first; n < last; ++n) {
            const std::size_t at = mode_index(n, lane_row.row, width);
            std::complex<float> a = cascade.h0[at];
            std::complex<float> b = cascade.h0[mode_index(-n, -lane_row.row, width)];
            ModeScale scale;
            if (factor_) {
                scale = factor_(number, n, lane_row.row);
                a *= scale.amplitude;
                b *= scale.amplitude;
            }
            float* to = dense.data() +
                        static_cast<std::size_t>(fft_index(n * stride, size_)) * lanes +
                        static_cast<std::size_t>(lane_row.lane);
            if (numbers == Numbers::all) {
                to[kRateHigh * plane] = cascade.rate_high[at];
                to[kRateLow * plane] = cascade.rate_low[at];
                to[kDisplacement * plane] = scale.displacement * cascade.displacement[at];
            }
            // The bands are disjoint: of the cascades that contain this mode, one has its energy.
            if (!alone && a == 0.0f && b == 0.0f) continue;
            to[kPRe * plane] = a.real() + b.real();
            to[kPIm * plane] = a.imag() - b.imag();
            to[kQRe * plane] = a.imag() + b.imag();
            to[kQIm * plane] = b.real() - a.real();
        }
    }

    const MapModes& modes_;
    const ModeFactor& factor_;
    int lanes_;
    int size_;
    int first_;
    int second_;
};

PackedModes::PackedModes(const MapModes& modes, ThreadPool& pool, SimdLevel level,
                         const ModeFactor& factor)
    : level_(level),
      size_(modes.resolution),
      columns_(whole_columns(modes, size_ / first_factor(size_))),
      rate_unit_(modes.rate_unit),
      wavenumber_step_(modes.wavenumber_step()) {
    const int lanes = kernel_code(level).lanes;
    const Packing packing(modes, factor, lanes);
    packets_ = PageVector<float>(packing.lay_out(columns_ / lanes, groups_));
    if (!factor) lattice_revision_ = modes.lattice_revision;
    pack_all(packing, Numbers::all, pool);
}

bool PackedModes::refill(const MapModes& modes, ThreadPool& pool, const ModeFactor& factor) {
    if (modes.resolution != size_ ||
        whole_columns(modes, size_ / first_factor(size_)) != columns_) {
        return false;
    }
    const int lanes = kernel_code(level_).lanes;
    const Packing packing(modes, factor, lanes);
    std::vector<ModeGroup> groups;
    packing.lay_out(columns_ / lanes, groups);
    if (groups != groups_) return false;
    rate_unit_ = modes.rate_unit;
    wavenumber_step_ = modes.wavenumber_step();
    const bool same_lattice = !factor && modes.lattice_revision == lattice_revision_;
    lattice_revision_ = factor ? Revision() : modes.lattice_revision;
    pack_all(packing, same_lattice ? Numbers::amplitudes : Numbers::all, pool);
    return true;
}

void PackedModes::pack_all(const Packing& packing, Numbers numbers, ThreadPool& pool) {
    if (numbers == Numbers::amplitudes && packing.is_plain()) {
        pool.for_each_item(columns_ / kernel_code(level_).lanes, [&](int block, int) {
            packing.pack_amplitudes(block,
                                    [&](int kx) { return packets_.data() + place(kx, block); });
        });
        return;
    }
    const auto groups_per_block = static_cast<std::size_t>(size_ / first_factor(size_) / 2);
    std::vector<std::vector<float>> dense(static_cast<std::size_t>(pool.size()));
    pool.for_each_item(columns_ / kernel_code(level_).lanes, [&](int block, int thread) {
        std::vector<float>& mine = dense[static_cast<std::size_t>(thread)];
        if (mine.empty()) mine = packing.dense_block();
        packing.pack(block, groups_.data() + static_cast<std::size_t>(block) * groups_per_block,
                     numbers, mine, packets_.data());
    });
}

std::size_t PackedModes::place(int kx, int block) const {
    const int lanes = kernel_code(level_).lanes;
    const int second = size_ / first_factor(size_);
    // Lines j and B - j are pairs; 0 and B / 2 hold two singles.
    const int line = kx % second;
    const bool mirrored = line > second / 2;
    const bool is_other = mirrored || line == second / 2;
    const int from = mirrored ? size_ - kx : kx;
    const int j = line == second / 2 ? 0 : from % second;
    const ModeGroup& group = groups_[static_cast<std::size_t>(block * (second / 2) + j)];
    const auto before = group.present & ((std::uint64_t{1} << (from / second)) - 1);
    const int numbers = j == 0 ? kSinglesNumbers : kPairNumbers;
    return group.first_packet +
           static_cast<std::size_t>((std::popcount(before) * numbers + (is_other ? 4 : 0)) * lanes);
}

std::shared_ptr<const PackedModes> pack_modes(const MapModes& modes, ThreadPool& pool,
                                              SimdLevel level) {
    return std::make_shared<const PackedModes>(modes, pool, level);
}

}  // namespace ocean
