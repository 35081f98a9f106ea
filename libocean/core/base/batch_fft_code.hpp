// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform of sixteen columns for one instruction set; see batch_fft.hpp. Each sum has the
// same order in all sets, and no product is fused with it. The build compiles it once for each
// instruction set (core/CMakeLists.txt).
#pragma once

#include "base/batch_fft_task.hpp"
#include "base/simd/simd.hpp"

namespace ocean::OCEAN_KERNEL {

constexpr int kBlockRows = 128;  // of 16 KiB, which stay in the first cache

OCEAN_INLINE Complex load_row(const BatchRow& row, int lane) {
    return {load(row.re + lane), load(row.im + lane)};
}
/// Returns a (c + i s), with each product rounded.
OCEAN_INLINE Complex rotated(Complex a, float c, float s) {
    return {a.re * Vec(c) - a.im * Vec(s), a.re * Vec(s) + a.im * Vec(c)};
}

struct ToRows {
    BatchRow* rows;
    const std::uint8_t* needed;

    OCEAN_INLINE bool needs(int row) const { return needed == nullptr || needed[row] != 0; }
    OCEAN_INLINE void put(int row, int lane, Complex x) const {
        store(rows[row].re + lane, x.re);
        store(rows[row].im + lane, x.im);
    }
};

struct ToNumbers {
    const BatchOutput& out;

    OCEAN_INLINE bool needs(int row) const { return out.needed == nullptr || out.needed[row] != 0; }
    OCEAN_INLINE void put(int row, int lane, Complex x) const {
        if (!needs(row)) return;
        Vec pair[2] = {x.re, x.im};
#if defined(__AVX512F__)
        interleave_lanes(pair);
#else
        pair[0] = unpack_low(x.re, x.im);
        pair[1] = unpack_high(x.re, x.im);
        interleave_quads(pair);
#endif
        float* const to = out.numbers + 2 * (static_cast<std::size_t>(row) * out.pitch) + 2 * lane;
        store_unaligned(to, pair[0]);
        store_unaligned(to + kLanes, pair[1]);
    }
};

/// Writes the rows of the groups from `first` on. The inputs of a group are every groups-th wave.
/// Within -reach .. reach that is one wave: k itself, the first input, or k < 0, the last input.
/// The group therefore has one wave, of frequency 0 or -1.
OCEAN_INLINE void spread(const BatchFftTask& task, int first, int count) {
    const int group = task.group;
    for (int start = first; start < first + count; start += group) {
        const ToRows to{task.out.work + start, nullptr};
        const int wave = task.wave_of_group[start / group];
        for (int lane = 0; lane < kFftBatch; lane += kLanes) {
            if (wave > task.reach) {
                for (int j = 0; j < group; ++j) to.put(j, lane, {Vec(0.0f), Vec(0.0f)});
                continue;
            }
            const auto at = static_cast<std::size_t>(wave + task.reach) * task.stride;
            const Complex input = load_row(task.spectrum[at], lane);
            to.put(0, lane, input);
            for (int j = 1; j < group; ++j) {
                if (wave >= 0) {
                    to.put(j, lane, input);
                    continue;
                }
                // e^(-2 pi i j / group); beyond half a turn, minus the root half a turn before.
                const bool far = 2 * j >= group;
                const int root = (far ? j - group / 2 : j) * (task.size / group);
                const float c = far ? -task.cosine[root] : task.cosine[root];
                const float s = far ? task.sine[root] : -task.sine[root];
                to.put(j, lane, rotated(input, c, s));
            }
        }
    }
}

template <typename Output>
OCEAN_INLINE void step(const BatchFftTask& task, int half, const BatchRow* rows, Output to) {
    const int turn = task.size / (2 * half);
    for (int k = 0; k < half; ++k) {
        if (!to.needs(k) && !to.needs(k + half)) continue;
        const float c = task.cosine[k * turn];
        const float s = task.sine[k * turn];
        for (int lane = 0; lane < kFftBatch; lane += kLanes) {
            const Complex a = load_row(rows[k], lane);
            const Complex b = rotated(load_row(rows[k + half], lane), c, s);
            to.put(k, lane, a + b);
            to.put(k + half, lane, a - b);
        }
    }
}

/// step(half) and step(2 half) in one pass over the memory.
template <typename Output>
OCEAN_INLINE void double_step(const BatchFftTask& task, int half, const BatchRow* rows, Output to) {
    const int turn = task.size / (4 * half);
    for (int k = 0; k < half; ++k) {
        if (!to.needs(k) && !to.needs(k + half) && !to.needs(k + 2 * half) &&
            !to.needs(k + 3 * half)) {
            continue;
        }
        const float c1 = task.cosine[2 * k * turn];
        const float s1 = task.sine[2 * k * turn];
        const float c2 = task.cosine[k * turn];
        const float s2 = task.sine[k * turn];
        for (int lane = 0; lane < kFftBatch; lane += kLanes) {
            const Complex a = load_row(rows[k], lane);
            const Complex b = rotated(load_row(rows[k + half], lane), c1, s1);
            const Complex c = load_row(rows[k + 2 * half], lane);
            const Complex d = rotated(load_row(rows[k + 3 * half], lane), c1, s1);
            const Complex even = rotated(c + d, c2, s2);
            const Complex odd = rotated(c - d, c2, s2);
            const Complex sum = a + b;
            const Complex difference = a - b;
            to.put(k, lane, sum + even);
            to.put(k + 2 * half, lane, sum - even);
            // In the second half, the root has turned by a further quarter: times i.
            to.put(k + half, lane, {difference.re - odd.im, difference.im + odd.re});
            to.put(k + 3 * half, lane, {difference.re + odd.im, difference.im - odd.re});
        }
    }
}

/// Makes the sums of the needed rows from rows of groups of `half`, which are the whole, a half or
/// a quarter of all.
template <typename Output>
OCEAN_INLINE void end_transform(const BatchFftTask& task, int half, Output to) {
    if (4 * half == task.size) return double_step(task, half, task.out.work, to);
    if (2 * half == task.size) return step(task, half, task.out.work, to);
    for (int row = 0; row < task.size; ++row) {
        for (int lane = 0; lane < kFftBatch; lane += kLanes) {
            to.put(row, lane, load_row(task.out.work[row], lane));
        }
    }
}

static void run_batch_fft(const BatchFftTask& task) {
    const auto double_steps = [&](int half, int first, int count) OCEAN_INLINE_LAMBDA {
        for (int start = first; start < first + count; start += 4 * half) {
            BatchRow* const rows = task.out.work + start;
            double_step(task, half, rows, ToRows{rows, nullptr});
        }
    };
    int block = task.group;
    while (4 * block < task.size && 4 * block <= kBlockRows) block *= 4;
    for (int first = 0; first < task.size; first += block) {
        spread(task, first, block);
        for (int half = task.group; half < block; half *= 4) double_steps(half, first, block);
    }
    int half = block;
    for (; 4 * half < task.size; half *= 4) double_steps(half, 0, task.size);
    if (task.out.numbers != nullptr) {
        end_transform(task, half, ToNumbers{task.out});
    } else {
        end_transform(task, half, ToRows{task.out.work, task.out.needed});
    }
}

extern const BatchFftLoop kBatchFftLoop;
constexpr BatchFftLoop kBatchFftLoop = run_batch_fft;

}  // namespace ocean::OCEAN_KERNEL
