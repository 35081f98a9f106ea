// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Pass one: modes -> coefficients -> transform along x -> transpose, for kLanes neighbouring ky.
#pragma once

#include "codelets.hpp"
#include "frame_task.hpp"
#include "layout.hpp"
#include "next_item.hpp"
#include "transpose.hpp"

namespace ocean::OCEAN_KERNEL {

/// h, u and their rates for the modes kx = j + B i (side 0) and their mirrors (side 1).
template <int A, bool kRates>
struct ModeLines {
    Complex h[2][A];
    Complex u[2][A];
    Complex h_rate[kRates ? 2 : 1][kRates ? A : 1];
    Complex u_rate[kRates ? 2 : 1][kRates ? A : 1];

    OCEAN_INLINE void set_zero(int side, int i) {
        const Complex zero = {0.0f, 0.0f};
        h[side][i] = zero;
        u[side][i] = zero;
        if constexpr (kRates) {
            h_rate[side][i] = zero;
            u_rate[side][i] = zero;
        }
    }
};

/// The part of the state that the two modes of a pair share, because they have one frequency.
struct ModePhase {
    Vec cosine;
    Vec sine;
    Vec omega;
    Vec displacement;
};

/// Returns the phase of modes. rates: rate_high, rate_low, displacement.
template <bool kRates>
OCEAN_INLINE ModePhase phase_of(const PhaseClock& clock, Vec rate_unit, const float* rates) {
    const Vec high = load(rates);
    const SinCosLanes phase = sin_cos(clock.turns(high, load(rates + kLanes)));
    return {phase.cosine, phase.sine, kRates ? high * rate_unit : Vec(0.0f),
            load(rates + 2 * kLanes)};
}

/// Sets h = P cos + Q sin and dh/dt = omega (Q cos - P sin) of a mode. amplitude: P, Q.
template <int A, bool kRates>
OCEAN_INLINE void set_mode(ModeLines<A, kRates>& lines, int side, int i, const float* amplitude,
                           const ModePhase& phase) {
    const Complex p = load_complex(amplitude);
    const Complex q = load_complex(amplitude + 2 * kLanes);
    const Complex h = {fma(q.re, phase.sine, p.re * phase.cosine),
                       fma(q.im, phase.sine, p.im * phase.cosine)};
    lines.h[side][i] = h;
    lines.u[side][i] = {h.re * phase.displacement, h.im * phase.displacement};
    if constexpr (kRates) {
        const Complex rate = {phase.omega * fnma(p.re, phase.sine, q.re * phase.cosine),
                              phase.omega * fnma(p.im, phase.sine, q.im * phase.cosine)};
        lines.h_rate[side][i] = rate;
        lines.u_rate[side][i] = {rate.re * phase.displacement, rate.im * phase.displacement};
    }
}

/// Floats by which packets are prefetched: 5.6 kB [measured].
inline constexpr int kPacketsAhead = 1408;

/// Writes the packets of a group with interpolated amplitudes, and without their rates.
template <int A>
void interpolate_group(const FrameTask& task, const ModeGroup& group, int packet_floats,
                       float* to) {
    constexpr int kAmplitudes = 8 * kLanes;
    const float* from = task.packets + group.first_packet;
    const float* toward = task.toward + group.first_packet;
    const Vec share(task.share);
    for (int i = 0; i < A; ++i) {
        if ((group.present >> i & 1) == 0) continue;
        for (int number = 0; number < kAmplitudes; number += kLanes) {
            if (number % kLineFloats == 0) __builtin_prefetch(toward + kPacketsAhead + number);
            const Vec first = load(from + number);
            store(to + number, fma(share, load(toward + number) - first, first));
        }
        from += packet_floats;
        toward += packet_floats;
        to += packet_floats;
    }
}

/// Computes the modes of one group: the lines j and B - j along kx, or 0 and B / 2.
/// packet: the first of the group; amplitude: the same, or as interpolate_group() writes it.
template <int A, bool kRates>
void read_modes(const FrameTask& task, const ModeGroup& group, const float* packet,
                const float* amplitude, bool singles, ModeLines<A, kRates>& lines) {
    constexpr int kAmplitude = 4 * kLanes;
    const PhaseClock clock(task.tau);
    const Vec rate_unit(task.rate_unit);
    for (int i = 0; i < A; ++i) {
        const int mirror = singles ? i : A - 1 - i;
        if ((group.present >> i & 1) == 0) {
            lines.set_zero(0, i);
            lines.set_zero(1, mirror);
            continue;
        }
        const float* rates = packet + 2 * kAmplitude;
        const ModePhase phase = phase_of<kRates>(clock, rate_unit, rates);
        set_mode(lines, 0, i, amplitude, phase);
        if (singles) {
            const ModePhase other = phase_of<kRates>(clock, rate_unit, rates + 3 * kLanes);
            set_mode(lines, 1, i, amplitude + kAmplitude, other);
            packet += kSinglesNumbers * kLanes;
            amplitude += kSinglesNumbers * kLanes;
        } else {
            for (int ahead = 0; ahead < kPairNumbers * kLanes; ahead += kLineFloats) {
                __builtin_prefetch(packet + kPacketsAhead + ahead);
            }
            set_mode(lines, 1, mirror, amplitude + kAmplitude, phase);
            packet += kPairNumbers * kLanes;
            amplitude += kPairNumbers * kLanes;
        }
    }
}

/// Runs the first sweep of one source along one line j: coefficients, A points, twiddles. kx:
/// wavenumbers of the line's modes, B apart. All sizes with one A share this code, because B is an
/// argument.
template <int A>
OCEAN_INLINE void sweep_line(SourceKind kind, const Complex* h, const Complex* u, const float* kx,
                             int B, Vec ky, const float* twiddle, float* out) {
    const auto twiddled = [=](int k, Complex x) OCEAN_INLINE_LAMBDA {
        store_complex(out + k * 2 * kLanes, turned(x, twiddle[2 * k], twiddle[2 * k + 1]));
    };
    switch (kind) {
        case SourceKind::plain:
            Codelet<A>::run([=](int i) OCEAN_INLINE_LAMBDA { return h[i]; }, twiddled);
            break;
        case SourceKind::along_x:
            Codelet<A>::run(
                [=](int i) OCEAN_INLINE_LAMBDA {
                    const Vec k(kx[i * B]);
                    return Complex{-h[i].im * k, h[i].re * k};
                },
                twiddled);
            break;
        case SourceKind::toward_x:
            Codelet<A>::run(
                [=](int i) OCEAN_INLINE_LAMBDA {
                    const Vec k(kx[i * B]);
                    return Complex{u[i].im * k, -u[i].re * k};
                },
                twiddled);
            break;
        case SourceKind::toward_y:
            Codelet<A>::run(
                [=](int i) OCEAN_INLINE_LAMBDA {
                    return Complex{u[i].im * ky, -u[i].re * ky};
                },
                twiddled);
            break;
        case SourceKind::gradient_xx:
            Codelet<A>::run(
                [=](int i) OCEAN_INLINE_LAMBDA {
                    const Vec k(kx[i * B] * kx[i * B]);
                    return Complex{u[i].re * k, u[i].im * k};
                },
                twiddled);
            break;
    }
}

/// The two lines of a group: h, u and, where a source reads them, their rates.
struct GroupLines {
    const Complex* h[2];
    const Complex* u[2];
    const Complex* h_rate[2];
    const Complex* u_rate[2];
};
template <int A, bool kRates>
OCEAN_INLINE GroupLines group_lines(const ModeLines<A, kRates>& lines) {
    constexpr int kOther = kRates ? 1 : 0;
    return {{lines.h[0], lines.h[1]},
            {lines.u[0], lines.u[1]},
            {lines.h_rate[0], lines.h_rate[kOther]},
            {lines.u_rate[0], lines.u_rate[kOther]}};
}

/// Runs the first sweep of all sources along both lines of a group.
template <int A>
void sweep_group(const FrameTask& task, int B, int j, Vec ky, const GroupLines& lines,
                 float* scratch) {
    for (int side = 0; side < 2; ++side) {
        const int line = side == 0 ? j : j == 0 ? B / 2 : B - j;
        for (int s = 0; s < task.source_count; ++s) {
            const Source& source = task.source[s];
            const Complex* h = source.rate ? lines.h_rate[side] : lines.h[side];
            const Complex* u = source.rate ? lines.u_rate[side] : lines.u[side];
            sweep_line<A>(source.kind, h, u, task.wavenumber + line, B, ky,
                          task.twiddle + 2 * line * A, scratch + (s * B + line) * Sweep<A>::kLine);
        }
    }
}

/// The packets of the next block.
using NextPackets = NextItem<(kLanes > 8 ? kLanes / 8 : 1)>;

template <int B>
OCEAN_INLINE NextPackets next_packets(const FrameTask& task, int block, const float* nowhere) {
    if ((block + 1) * kLanes >= task.columns) return {nowhere, 0, nowhere};
    const std::uint64_t here = task.groups[block * (B / 2)].first_packet;
    const std::uint64_t first = task.groups[(block + 1) * (B / 2)].first_packet;
    // Assumes that the next item has the size of this one: neighbouring blocks differ little.
    return {task.packets + first, first - here, nowhere};
}

/// Runs the second sweep of one source, kLanes of its A transforms at a time. Transposes each block
/// of a wanted strip and stores it at the position from which pass two reads it.
template <int A, int B, bool kStream>
void sweep_and_transpose(const FrameTask& task, int block, int source, const float* lines,
                         float* tile, const NextPackets& next) {
    std::size_t place[kLanes];  // offset of each ky
    for (int l = 0; l < kLanes; ++l) {
        place[l] = Intermediate<B>::place(task, source, block * kLanes + l);
    }
    const std::uint8_t* strips = task.strips;
    for (int group = 0; group < A / kLanes; ++group) {
        const auto block_of = [=](int m)
                                  OCEAN_INLINE_LAMBDA { return Sweep<A>::block_of(group, m); };
        const auto target = [&](int m) OCEAN_INLINE_LAMBDA {
            return task.intermediate + Intermediate<B>::x_block(task, block_of(m));
        };
        const auto is_wanted = [=](int m) OCEAN_INLINE_LAMBDA {
            return strips == nullptr || strips[Layout::item_of(block_of(m))] != 0;
        };
        for (int k = 0; k < kLanes; ++k) {
            const float* in = lines + (group * kLanes + k) * 2 * kLanes;
            float* out = tile + k * 2 * kLanes;
            if constexpr (!kStream) prefetch_targets<B>(target, is_wanted, place, k);
            const float* ahead = next.share(source * A + group * kLanes + k, B);
            Codelet<B>::run(
                [=](int j) OCEAN_INLINE_LAMBDA {
                    NextPackets::ask(ahead, j);
                    return load_complex(in + j * Sweep<A>::kLine);
                },
                [=](int m, Complex x)
                    OCEAN_INLINE_LAMBDA { store_complex(out + m * kTileStride, x); });
        }
        const auto store_block = [&](int m) OCEAN_INLINE_LAMBDA {
            transpose<kStream>(tile + m * kTileStride, target(m), place);
        };
        if (strips == nullptr) {  // a frame: no test of each block
            for (int m = 0; m < B; ++m) store_block(m);
        } else {
            for (int m = 0; m < B; ++m) {
                if (is_wanted(m)) store_block(m);
            }
        }
    }
}

template <int A, int B, bool kRates>
void pass_one(const FrameTask& task, int block, float* scratch) {
    ModeLines<A, kRates> lines;
    alignas(64) float between[A * kSinglesNumbers * kLanes];
    const Vec ky = load(task.wavenumber + block * kLanes);
    for (int j = 0; j < B / 2; ++j) {
        const ModeGroup& group = task.groups[block * (B / 2) + j];
        const float* packet = task.packets + group.first_packet;
        const float* amplitude = packet;
        if (task.toward != nullptr) {
            const int numbers = j == 0 ? kSinglesNumbers : kPairNumbers;
            interpolate_group<A>(task, group, numbers * kLanes, between);
            amplitude = between;
        }
        read_modes(task, group, packet, amplitude, j == 0, lines);
        sweep_group<A>(task, B, j, ky, group_lines(lines), scratch);
    }
    const NextPackets next = next_packets<B>(task, block, scratch);
    float* tile = scratch + task.source_count * B * Sweep<A>::kLine;
    for (int s = 0; s < task.source_count; ++s) {
        const float* swept = scratch + s * B * Sweep<A>::kLine;
        if (task.stream_intermediate) {
            sweep_and_transpose<A, B, true>(task, block, s, swept, tile, next);
        } else {
            sweep_and_transpose<A, B, false>(task, block, s, swept, tile, next);
        }
    }
    finish_streams();
}

}  // namespace ocean::OCEAN_KERNEL
