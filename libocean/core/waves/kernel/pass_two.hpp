// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pass two: for kItemWidth neighbouring x, the transform along y and the outputs.
//
// The line of one x is real: G(-ky) = conj(G(ky)). Two of them, x and x + kPartner, make one
// complex line Z = G0 + i G1, with Z(ky) = G0 + i G1 and Z(-ky) = conj(G0) + i conj(G1), whose
// transform has one line as its real part and the other as its imaginary part.
#pragma once

#include "codelets.hpp"
#include "frame_task.hpp"
#include "layout.hpp"
#include "next_item.hpp"
#include "rows.hpp"

namespace ocean::OCEAN_KERNEL {

/// A line of ky = j + B i, i < A, is stored in the intermediate as its half with ky > 0; the other
/// half is the mirror of a line. Lines j and B - j mirror each other: -(j + B i) = (B - j) + B (A -
/// 1 - i) mod N. Lines 0 and B / 2 mirror themselves: -B i = B (A - i) and -(B/2 + B i) = B/2 + B
/// (A - 1 - i). One function reads both: its code size matters more than its few additions.
enum class Line { paired, own };

/// Loads Z, or i ky Z, along one line. kCut: some rows are missing and count as 0.
template <int A, Line kLine, bool kDerived, bool kCut>
struct LineReader {
    const float* entries;  // of one j and source
    const float* ky;       // of lines j and B - j, or 0 and B / 2
    const float* other_ky;
    int B;
    int rows;
    int side;  // which of the two lines

    OCEAN_INLINE Complex operator()(int i) const {
        const Complex zero = {0.0f, 0.0f};
        const bool mirror = i >= A / 2;
        const int row = !mirror ? i : kLine == Line::own ? A - side - i : A - 1 - i;
        if (kCut && row >= rows) return zero;  // includes the Nyquist line, row A / 2
        const int from = kLine == Line::paired && mirror ? 1 - side : side;
        const float* entry = entries + row * kEntry + from * 2 * kBlock;
        const Complex g0 = load_complex(entry);
        const Complex g1 = load_complex(entry + 2 * kLanes);
        const Complex z =
            mirror ? Complex{g0.re + g1.im, g1.re - g0.im} : Complex{g0.re - g1.im, g0.im + g1.re};
        if constexpr (!kDerived) return z;
        const Vec k((from == 0 ? ky : other_ky)[B * row]);
        return mirror ? Complex{z.im * k, -z.re * k} : Complex{-z.im * k, z.re * k};
    }
};

/// Runs the first sweep of one field along one line: A points, twiddles.
template <int A, typename Reader>
void sweep_line_of(const FrameTask& task, const Reader& read, int line, float* out) {
    const float* twiddle = task.twiddle + 2 * line * A;
    Codelet<A>::run([=](int i) OCEAN_INLINE_LAMBDA { return read(i); },
                    [=](int k, Complex x) OCEAN_INLINE_LAMBDA {
                        store_complex(out + k * 2 * kLanes,
                                      turned(x, twiddle[2 * k], twiddle[2 * k + 1]));
                    });
}

/// Runs the first sweep of one field, or of its derived field, along both lines of j. to: the lines
/// in the scratch.
template <int A, bool kDerived>
void sweep_field(const FrameTask& task, int B, int rows, int j, const float* entries, float* to) {
    const int other = j == 0 ? B / 2 : B - j;
    const float* ky = task.wavenumber;
    float* out = to + j * Sweep<A>::kLine;
    float* other_out = to + other * Sweep<A>::kLine;
    const auto sweep = [&]<Line kLine, bool kCut>() {
        using Reader = LineReader<A, kLine, kDerived, kCut>;
        const Reader first{entries, ky + j, ky + other, B, rows, 0};
        const Reader second{entries, ky + j, ky + other, B, rows, 1};
        sweep_line_of<A>(task, first, j, out);
        sweep_line_of<A>(task, second, other, other_out);
    };
    if (j == 0) {
        sweep.template operator()<Line::own, true>();
    } else if (rows < A / 2) {
        sweep.template operator()<Line::paired, true>();
    } else {
        sweep.template operator()<Line::paired, false>();
    }
}

/// Runs the first sweep of all fields of one pair. scratch: [slot][j][k].
template <int A, int B>
void sweep_pair(const FrameTask& task, int pair, float* scratch) {
    const float* base = task.intermediate + static_cast<std::size_t>(pair) * task.pair_stride;
    const int rows = static_cast<int>(Intermediate<B>::rows(task));
    const auto lines_of = [&](int slot) { return scratch + slot * B * Sweep<A>::kLine; };
    for (int s = 0; s < task.source_count; ++s) {
        const Source& source = task.source[s];
        const float* entries = base + static_cast<std::size_t>(s) * task.source_stride;
        for (int j = 0; j < B / 2; ++j, entries += task.line_stride) {
            if (source.own >= 0) {
                sweep_field<A, false>(task, B, rows, j, entries, lines_of(source.own));
            }
            if (source.derived >= 0) {
                sweep_field<A, true>(task, B, rows, j, entries, lines_of(source.derived));
            }
        }
    }
}

/// Prefetches the data that pass two reads next. A codelet of slot s prefetches a share of source
/// ahead[s].
template <int A, int B>
class NextEntries {
  public:
    using Lines = NextItem<(kEntry > 64 ? kEntry / 64 : 1)>;

    OCEAN_INLINE NextEntries(const FrameTask& task, int item, const float* nowhere)
        : task_(task),
          first_(task.intermediate +
                 static_cast<std::size_t>((item + task.ahead_items) * kPairs) * task.pair_stride),
          count_((item + task.ahead_items) * kItemWidth < task.size ? task.ahead_count : 0),
          nowhere_(nowhere) {}

    /// Returns the share for the sweep over the samples k of the field in `slot` of a pair.
    OCEAN_INLINE const float* share(int k, int slot, int pair) const {
        const auto place = static_cast<std::size_t>(k * B * Lines::kFloats);
        if (slot >= count_ || place >= task_.source_stride) return nowhere_;
        return first_ + static_cast<std::size_t>(pair) * task_.pair_stride +
               static_cast<std::size_t>(task_.ahead[slot]) * task_.source_stride + place;
    }

  private:
    const FrameTask& task_;
    const float* first_;
    int count_;
    const float* nowhere_;
};

/// Runs the second sweep of one field for the samples y = k + A l, all l.
template <int A, int B, typename Store>
OCEAN_INLINE void sweep_samples(const float* field, int k, const float* next, const Store& store) {
    const float* in = field + k * 2 * kLanes;
    Codelet<B>::run(
        [=](int j) OCEAN_INLINE_LAMBDA {
            NextEntries<A, B>::Lines::ask(next, j);
            return load_complex(in + j * Sweep<A>::kLine);
        },
        store);
}

/// Writes an output that is a plane of one field: whole rows of an item at once, which are full
/// cache lines. One plane after the other: the rows of one k lie in few sets of the caches, and
/// those of several planes together would drive each other out. [measured, Zen 5, eight planes:
/// N = 256 with AVX-512 0.25 to 0.17 ms a frame, N = 1024 with AVX2 6.2 to 5.8 ms]
template <int A, int B>
void write_direct_plane(const DirectPlane& plane, bool streams, int x0, const float* scratch,
                        std::size_t pair_floats, const NextEntries<A, B>& next) {
    const float* field = scratch + plane.slot * B * Sweep<A>::kLine;
    const std::size_t step = A * plane.row_pitch;
    const Vec factor(plane.factor);
    const auto put = [streams](float* to, Vec x) OCEAN_INLINE_LAMBDA {
        if (streams) {
            stream(to, x);
        } else {
            store(to, x);
        }
    };
    for (int k = 0; k < A; ++k) {
        float* out = plane.data + static_cast<std::size_t>(k) * plane.row_pitch + x0;
        if constexpr (kPairs == 1) {
            const float* ahead = next.share(k, plane.slot, 0);
            sweep_samples<A, B>(field, k, ahead, [=](int l, Complex x) OCEAN_INLINE_LAMBDA {
                float* row = out + static_cast<std::size_t>(l) * step;
                put(row, x.re * factor);
                put(row + kPartner, x.im * factor);
            });
        } else {
            Complex samples[kPairs][B];
            for (int p = 0; p < kPairs; ++p) {
                Complex* to = samples[p];
                sweep_samples<A, B>(field + static_cast<std::size_t>(p) * pair_floats, k,
                                    next.share(k, plane.slot, p),
                                    [=](int l, Complex x) OCEAN_INLINE_LAMBDA { to[l] = x; });
            }
            for (int l = 0; l < B; ++l) {
                float* row = out + static_cast<std::size_t>(l) * step;
                for (int p = 0; p < kPairs; ++p) put(row + p * kLanes, samples[p][l].re * factor);
                row += kPartner;
                for (int p = 0; p < kPairs; ++p) put(row + p * kLanes, samples[p][l].im * factor);
            }
        }
    }
}

/// All other outputs: computes the samples of their fields, in the order of the rows of an item,
/// and row by row the channels. On large maps rows of y = k + A l are written while the samples of
/// k + 1 are computed, a few with each codelet: memory accepts a steady stream of stores while the
/// core computes, but a burst of stores stalls the core. [measured, AVX2: 3 % of a frame at N =
/// 1024, nothing at 512; at 256 it would lose 7 %]
template <int A, int B>
class CombinedOutputs {
  public:
    /// samples: kSlotFloats for each slot.
    OCEAN_INLINE CombinedOutputs(const FrameTask& task, int x0, float* samples)
        : task_(task), x0_(x0), samples_(samples) {}

    /// Computes the samples of k, and writes the rows of k or of k - 1.
    OCEAN_INLINE void advance(int k, const float* scratch, std::size_t pair_floats,
                              const NextEntries<A, B>& next) {
        if (kBeside) begin_rows(k - 1);
        const int codelets = task_.used_count * kPairs;
        int done = 0;
        for (int u = 0; u < task_.used_count; ++u) {
            const int slot = task_.used[u];
            float* to = samples_of(k, slot);
            const float* field = scratch + slot * B * Sweep<A>::kLine;
            for (int p = 0; p < kPairs; ++p, to += kLanes, field += pair_floats) {
                sweep_samples<A, B>(field, k, next.share(k, slot, p),
                                    [=](int l, Complex x) OCEAN_INLINE_LAMBDA {
                                        store(to + l * kItemWidth, x.re);
                                        store(to + l * kItemWidth + kPartner, x.im);
                                    });
                if (kBeside && k > 0) write_until(B * ++done / codelets);
            }
        }
        if (!kBeside) begin_rows(k);
        if (!kBeside || k > 0) write_until(B);
    }
    /// Writes the remaining rows.
    OCEAN_INLINE void finish() {
        if (!kBeside) return;
        begin_rows(A - 1);
        write_until(B);
    }

    static constexpr bool kBeside = A * B >= 1024;
    static constexpr int kSlotFloats = (kBeside ? 2 : 1) * B * kItemWidth;

  private:
    OCEAN_INLINE float* samples_of(int k, int slot) const {
        return samples_ + slot * kSlotFloats + (kBeside ? (k & 1) * B * kItemWidth : 0);
    }
    OCEAN_INLINE void begin_rows(int k) {
        row_k_ = k;
        row_l_ = 0;
    }
    OCEAN_INLINE void write_until(int end) {
        Rows rows{x0_, row_k_ + A * row_l_, A, end - row_l_, {}};
        for (int u = 0; u < task_.used_count; ++u) {
            rows.slot[task_.used[u]] = samples_of(row_k_, task_.used[u]) + row_l_ * kItemWidth;
        }
        write_outputs(task_, rows);
        row_l_ = end;
    }

    const FrameTask& task_;
    int x0_;
    float* samples_;
    int row_k_ = 0;
    int row_l_ = 0;
};

template <int A, int B>
void pass_two(const FrameTask& task, int item, float* scratch) {
    const auto pair_floats = static_cast<std::size_t>(task.slots) * B * Sweep<A>::kLine;
    for (int p = 0; p < kPairs; ++p) {
        sweep_pair<A, B>(task, item * kPairs + p,
                         scratch + static_cast<std::size_t>(p) * pair_floats);
    }
    const NextEntries<A, B> next(task, item, scratch);
    const int x0 = item * kItemWidth;
    CombinedOutputs<A, B> combined(task, x0, scratch + kPairs * pair_floats);
    for (int d = 0; d < task.direct_count; ++d) {
        write_direct_plane<A, B>(task.direct[d], task.stream_outputs, x0, scratch, pair_floats,
                                 next);
    }
    if (task.output_count > 0) {
        for (int k = 0; k < A; ++k) combined.advance(k, scratch, pair_floats, next);
        combined.finish();
    }
    finish_streams();
}

}  // namespace ocean::OCEAN_KERNEL
