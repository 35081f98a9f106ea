// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The loops over a row of modes, for one instruction set; the build compiles them once for each
// (core/CMakeLists.txt). All in double: a live tool repeats them while a user changes the wind.
#pragma once

#include "base/simd/simd.hpp"
#include "waves/modes/mode_rows_task.hpp"

namespace ocean::OCEAN_KERNEL {

/// The place of a point in the table.
struct TablePlace {
    const double* at;  // null: outside
    double u, v;       // how far towards the next direction and row
};

/// Finds the places of `count` points, and prefetches what is read there: the table is larger than
/// a core's caches, and a read that begins to wait is a wait for each point.
static void find_places(const QuadrantTable& table, const double* omega, const double* direction,
                        std::size_t count, TablePlace* places) {
    for (std::size_t i = 0; i < count; ++i) {
        const double w = omega[i];
        if (!(w >= table.lowest && w < table.highest)) {
            places[i].at = nullptr;
            continue;
        }
        std::uint64_t bucket;
        __builtin_memcpy(&bucket, &w, sizeof(bucket));
        bucket = (bucket >> QuadrantTable::kDroppedBits) - table.first_bucket;
        std::size_t row = table.row_of_bucket[bucket];
        while (w >= table.omega[row + 1]) ++row;
        const double column = direction[i] * table.directions;
        const auto j = static_cast<std::int64_t>(column);
        const double* const at = table.density + row * table.row_size + 4 * j;
        __builtin_prefetch(at);
        __builtin_prefetch(at + 7);
        __builtin_prefetch(at + table.row_size);
        __builtin_prefetch(at + table.row_size + 7);
        places[i] = {at, column - static_cast<double>(j),
                     (w - table.omega[row]) * table.inverse_gap[row]};
    }
}

static void run_variances(const QuadrantTable& table, const QuadrantCells& cells,
                          double* const* variances) {
    using Four = double __attribute__((vector_size(4 * sizeof(double))));
    using Eight = double __attribute__((vector_size(8 * sizeof(double))));
    constexpr std::size_t kBlock = 32;
    TablePlace places[kBlock];
    std::size_t point = 0;
    for (std::size_t cell = 0; cell < cells.count; ++cell) {
        Four sum = {};
        const std::size_t end = point + (cells.points_of != nullptr ? cells.points_of[cell] : 1);
        for (; point < end; ++point) {
            if (point % kBlock == 0) {
                const std::size_t left = cells.points - point;
                find_places(table, cells.omega + point, cells.direction + point,
                            left < kBlock ? left : kBlock, places);
            }
            const TablePlace place = places[point % kBlock];
            if (place.at == nullptr) continue;
            // Two directions side by side, each with its mirror images.
            Eight low, high;
            __builtin_memcpy(&low, place.at, sizeof(low));
            __builtin_memcpy(&high, place.at + table.row_size, sizeof(high));
            const Eight both = low + place.v * (high - low);
            const Four here = __builtin_shufflevector(both, both, 0, 1, 2, 3);
            const Four next = __builtin_shufflevector(both, both, 4, 5, 6, 7);
            sum += cells.weight[point] * (here + place.u * (next - here));
        }
        for (int quarter = 0; quarter < 4; ++quarter) variances[quarter][cell] = sum[quarter];
    }
}

static void run_waves(const double* variance, std::ptrdiff_t step, const float* noise,
                      std::size_t count, float* h0) {
    constexpr std::size_t kPart = 64;
    double amplitude[kPart];
    for (std::size_t first = 0; first < count; first += kPart) {
        const std::size_t part = count - first < kPart ? count - first : kPart;
        if (step > 0) {
            const double* const from = variance + first;
            for (std::size_t i = 0; i < part; ++i) amplitude[i] = 0.5 * __builtin_sqrt(from[i]);
        } else {
            const double* const from = variance - first;
            for (std::size_t i = 0; i < part; ++i) {
                amplitude[i] = 0.5 * __builtin_sqrt(*(from - i));
            }
        }
        const float* const from = noise + 2 * first;
        float* const to = h0 + 2 * first;
        for (std::size_t i = 0; i < part; ++i) {
            // Adding 0 turns minus zero into zero, for modes without waves.
            const double re = amplitude[i] * static_cast<double>(from[2 * i]);
            const double im = amplitude[i] * static_cast<double>(from[2 * i + 1]);
            to[2 * i] = static_cast<float>(re) + 0.0f;
            to[2 * i + 1] = static_cast<float>(im) + 0.0f;
        }
    }
}

static void run_shells(const RowShells& shells, std::size_t first, double* const* sums) {
    constexpr std::size_t kPart = 64;
    const double ky = shells.step * shells.row;
    const double yy = ky * ky;
    double term[kShellSums][kPart];
    const auto set_terms = [&](std::size_t from, std::size_t count) OCEAN_INLINE_LAMBDA {
        const double* const v0 = shells.variance[0] + from;
        const double* const v1 = shells.variance[1] + from;
        const double* const v2 = shells.variance[2] + from;
        const double* const v3 = shells.variance[3] + from;
        const float* const displacement = shells.displacement + from;
        const int n = static_cast<int>(from);
        for (std::size_t i = 0; i < count; ++i) {
            const double kx = shells.step * static_cast<double>(n + static_cast<int>(i));
            const double xx = kx * kx;
            const double d = displacement[i];
            const double square = d * d;
            const double all = square * (v0[i] + v1[i] + v2[i] + v3[i]);
            const double skew = square * (v0[i] - v1[i] + v2[i] - v3[i]) * kx * ky;
            term[0][i] = all * xx * xx;
            term[1][i] = all * yy * yy;
            term[2][i] = all * xx * yy;
            term[3][i] = skew * xx;
            term[4][i] = skew * yy;
        }
    };
    const auto row = static_cast<std::size_t>(shells.row);
    const std::size_t inner = shells.end < row + 1 ? shells.end : row + 1;
    double own[kShellSums] = {};
    for (std::size_t n = 0; n < inner; n += kPart) {
        const std::size_t count = inner - n < kPart ? inner - n : kPart;
        set_terms(n, count);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t s = 0; s < kShellSums; ++s) own[s] += term[s][i];
        }
    }
    for (std::size_t s = 0; s < kShellSums; ++s) sums[s][row - first] += own[s];
    for (std::size_t n = row + 1; n < shells.end; n += kPart) {
        const std::size_t count = shells.end - n < kPart ? shells.end - n : kPart;
        set_terms(n, count);
        for (std::size_t s = 0; s < kShellSums; ++s) {
            double* const sum = sums[s] + (n - first);
            for (std::size_t i = 0; i < count; ++i) sum[i] += term[s][i];
        }
    }
}

extern const ModeRowLoops kModeRowLoops;
constexpr ModeRowLoops kModeRowLoops = {run_variances, run_waves, run_shells};

}  // namespace ocean::OCEAN_KERNEL
