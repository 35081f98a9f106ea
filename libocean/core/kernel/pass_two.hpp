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
#include "outputs.hpp"

namespace ocean::OCEAN_KERNEL {

/// Lines ky = j + B i of a field and of the one derived from it, for the two lines of a j.
template <int A>
struct PairedLines {
    Complex own[2][A];
    Complex derived[2][A];
};

/// Z at ky and at -ky from G0 and G1, [re | im] each.
struct MirroredPair {
    Complex at;
    Complex mirror;
};
OCEAN_INLINE MirroredPair pair_up(Complex g0, Complex g1) {
    return {{g0.re - g1.im, g0.im + g1.re}, {g0.re + g1.im, g1.re - g0.im}};
}

/// i ky Z: the mirror has -ky.
OCEAN_INLINE MirroredPair derive(MirroredPair z, Vec ky) {
    return {{-z.at.im * ky, z.at.re * ky}, {z.mirror.im * ky, -z.mirror.re * ky}};
}

/// Puts one ky of line `side` in place, and its mirror, which is on line `mirror_side`.
template <int A, bool kWithOwn, bool kWithDerived>
OCEAN_INLINE void place_pair(PairedLines<A>& lines, const float* entry, float ky, int side, int i,
                             int mirror_side, int mirror_i) {
    const MirroredPair z = pair_up(load_complex(entry), load_complex(entry + 2 * kLanes));
    if constexpr (kWithOwn) {
        lines.own[side][i] = z.at;
        lines.own[mirror_side][mirror_i] = z.mirror;
    }
    if constexpr (kWithDerived) {
        const MirroredPair d = derive(z, ky);
        lines.derived[side][i] = d.at;
        lines.derived[mirror_side][mirror_i] = d.mirror;
    }
}

template <int A>
OCEAN_INLINE void clear_rows(PairedLines<A>& lines, int side, int first, int last) {
    for (int i = first; i < last; ++i) {
        lines.own[side][i] = {0.0f, 0.0f};
        lines.derived[side][i] = {0.0f, 0.0f};
    }
}

/// Lines j and B - j: each is the other's mirror, -(j + B i) = (B - j) + B (A - 1 - i) mod N.
/// Lines 0 and B / 2 (j = 0) are their own mirrors, -B i = B (A - i) and
/// -(B/2 + B i) = B/2 + B (A - 1 - i).
template <int A, int B, bool kWithOwn, bool kWithDerived>
void combine_lines(const FrameTask& task, int j, const float* entries, PairedLines<A>& lines) {
    using Layout = Intermediate<A, B>;
    constexpr int kPrefetch = 1024;  // floats ahead: 4 kB [measured]
    constexpr int kSecond = 2 * Layout::kBlock;
    const int rows = static_cast<int>(Layout::rows(task));
    const int other = j == 0 ? B / 2 : B - j;
    const float* ky = task.wavenumber;
    const float* entry = entries;
    for (int i = 0; i < rows; ++i, entry += Layout::kEntry) {
        for (int ahead = 0; ahead < Layout::kEntry; ahead += 16) {
            __builtin_prefetch(entry + kPrefetch + ahead);
        }
        const float k0 = ky[j + B * i];
        const float k1 = ky[other + B * i];
        if (j != 0) {
            place_pair<A, kWithOwn, kWithDerived>(lines, entry, k0, 0, i, 1, A - 1 - i);
            place_pair<A, kWithOwn, kWithDerived>(lines, entry + kSecond, k1, 1, i, 0, A - 1 - i);
        } else {
            // ky = 0 is its own mirror; what it puts in place 1 is overwritten or cleared.
            place_pair<A, kWithOwn, kWithDerived>(lines, entry, k0, 0, i, 0, i == 0 ? 1 : A - i);
            place_pair<A, kWithOwn, kWithDerived>(lines, entry + kSecond, k1, 1, i, 1, A - 1 - i);
        }
    }
    // What no mode reaches: the Nyquist line, and all beyond the columns there are.
    if (j == 0) {
        const int first = rows < A / 2 ? rows : A / 2;
        clear_rows(lines, 0, first, A - first + 1);
        clear_rows(lines, 1, rows, A - rows);
    } else {
        clear_rows(lines, 0, rows, A - rows);
        clear_rows(lines, 1, rows, A - rows);
    }
}

/// First sweep of one field along one line: A points, twiddles.
template <int A, int B>
OCEAN_INLINE void sweep_field(const FrameTask& task, const Complex* line, int j, float* out) {
    const float* twiddle = task.twiddle + 2 * j * A;
    Codelet<A>::run([=](int i) OCEAN_INLINE_LAMBDA { return line[i]; },
                    [=](int k, Complex x) OCEAN_INLINE_LAMBDA {
                        store_complex(out + k * 2 * kLanes,
                                      turned(x, twiddle[2 * k], twiddle[2 * k + 1]));
                    });
}

/// First sweep of all fields of one pair. scratch: [slot][j][k].
template <int A, int B>
void sweep_pair(const FrameTask& task, int pair, float* scratch) {
    using Layout = Intermediate<A, B>;
    alignas(64) PairedLines<A> lines;
    const float* base = task.intermediate + static_cast<std::size_t>(pair) * task.pair_stride;
    for (int j = 0; j < B / 2; ++j) {
        const int line[2] = {j, j == 0 ? B / 2 : B - j};
        for (int s = 0; s < task.source_count; ++s) {
            const Source& source = task.source[s];
            const float* entries =
                base + static_cast<std::size_t>(j) * task.line_stride +
                static_cast<std::size_t>(s) * Layout::rows(task) * Layout::kEntry;
            if (source.derived < 0) {
                combine_lines<A, B, true, false>(task, j, entries, lines);
            } else if (source.own < 0) {
                combine_lines<A, B, false, true>(task, j, entries, lines);
            } else {
                combine_lines<A, B, true, true>(task, j, entries, lines);
            }
            for (int side = 0; side < 2; ++side) {
                const auto to = [&](int slot) {
                    return scratch + (slot * B + line[side]) * Sweep<A, B>::kLine;
                };
                if (source.own >= 0) {
                    sweep_field<A, B>(task, lines.own[side], line[side], to(source.own));
                }
                if (source.derived >= 0) {
                    sweep_field<A, B>(task, lines.derived[side], line[side], to(source.derived));
                }
            }
        }
    }
}

/// Second sweep of one field for the samples y = k + A l, all l.
template <int A, int B, typename Store>
OCEAN_INLINE void sweep_samples(const float* field, int k, const Store& store) {
    const float* in = field + k * 2 * kLanes;
    Codelet<B>::run([=](int j)
                        OCEAN_INLINE_LAMBDA { return load_complex(in + j * Sweep<A, B>::kLine); },
                    store);
}

/// Planes that are one field each: whole rows of an item at once, which are full lines of the
/// cache.
template <int A, int B>
void write_direct_planes(const FrameTask& task, int k, int x0, const float* scratch,
                         std::size_t pair_floats) {
    const auto size = static_cast<std::size_t>(task.size);
    for (int d = 0; d < task.direct_count; ++d) {
        const DirectPlane& plane = task.direct[d];
        const float* field = scratch + plane.slot * B * Sweep<A, B>::kLine;
        float* out = plane.data + static_cast<std::size_t>(k) * size + x0;
        const Vec factor(plane.factor);
        if constexpr (kPairs == 1) {
            sweep_samples<A, B>(field, k, [=](int l, Complex x) OCEAN_INLINE_LAMBDA {
                float* row = out + static_cast<std::size_t>(l) * A * size;
                stream(row, x.re * factor);
                stream(row + kPartner, x.im * factor);
            });
        } else {
            Complex samples[kPairs][B];
            for (int p = 0; p < kPairs; ++p) {
                Complex* to = samples[p];
                sweep_samples<A, B>(field + static_cast<std::size_t>(p) * pair_floats, k,
                                    [=](int l, Complex x) OCEAN_INLINE_LAMBDA { to[l] = x; });
            }
            for (int l = 0; l < B; ++l) {
                float* row = out + static_cast<std::size_t>(l) * A * size;
                for (int p = 0; p < kPairs; ++p)
                    stream(row + p * kLanes, samples[p][l].re * factor);
                row += kPartner;
                for (int p = 0; p < kPairs; ++p)
                    stream(row + p * kLanes, samples[p][l].im * factor);
            }
        }
    }
}

/// All other outputs for y = k + A l: the samples of the fields they use, in the order of the rows
/// of an item, then row by row what is made of them.
template <int A, int B>
void write_combined(const FrameTask& task, int k, int x0, const float* scratch,
                    std::size_t pair_floats, float* samples) {
    alignas(64) float derived[kChannelCount * kItemWidth];
    RowSamples row = row_samples(task, derived);
    for (int u = 0; u < task.used_count; ++u) {
        const int slot = task.used[u];
        float* to = samples + slot * B * kItemWidth;
        row.slot[slot] = to;
        for (int p = 0; p < kPairs; ++p, to += kLanes) {
            const float* field =
                scratch + static_cast<std::size_t>(p) * pair_floats + slot * B * Sweep<A, B>::kLine;
            sweep_samples<A, B>(field, k, [=](int l, Complex x) OCEAN_INLINE_LAMBDA {
                store(to + l * kItemWidth, x.re);
                store(to + l * kItemWidth + kPartner, x.im);
            });
        }
    }
    for (int l = 0; l < B; ++l) {
        write_outputs(task, row,
                      static_cast<std::size_t>(k + A * l) * static_cast<std::size_t>(task.size) +
                          static_cast<std::size_t>(x0));
        for (int u = 0; u < task.used_count; ++u) row.slot[task.used[u]] += kItemWidth;
    }
}

template <int A, int B>
void pass_two(const FrameTask& task, int item, float* scratch) {
    const auto pair_floats = static_cast<std::size_t>(task.slots) * B * Sweep<A, B>::kLine;
    for (int p = 0; p < kPairs; ++p) {
        sweep_pair<A, B>(task, item * kPairs + p,
                         scratch + static_cast<std::size_t>(p) * pair_floats);
    }
    float* samples = scratch + kPairs * pair_floats;
    for (int k = 0; k < A; ++k) {
        const int x0 = item * kItemWidth;
        write_direct_planes<A, B>(task, k, x0, scratch, pair_floats);
        if (task.output_count > 0) {
            write_combined<A, B>(task, k, x0, scratch, pair_floats, samples);
        }
    }
    finish_streams();
}

}  // namespace ocean::OCEAN_KERNEL
