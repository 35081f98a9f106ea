// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the loops over a row of modes: plain data, so that the files compiled for one
// instruction set need nothing of the standard library.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/simd/simd_level.hpp"

namespace ocean {

/// The table of a DirectionalSpectrum that is not flat, and an index of its rows.
struct QuadrantTable {
    const double* omega;        // of each row [rad/s]
    const double* inverse_gap;  // 1 / (omega of the next row - omega)
    double lowest, highest;     // omega of the first and of the last row
    double directions;
    const double* density;  // as it is in memory
    std::size_t row_size;
    std::uint64_t first_bucket;
    const std::uint32_t* row_of_bucket;  // a row at or before the bucket's first row

    // The leading bits of a positive double rise with it, 1024 steps to the octave: about as close
    // as the closest rows of a table.
    static constexpr int kDroppedBits = 42;
};

/// Cells in the first quadrant, one after another, and the points in them.
struct QuadrantCells {
    std::size_t count;
    const std::uint32_t* points_of;  // of each cell; null: one each
    std::size_t points;
    const double* omega;      // of each point [rad/s]
    const double* direction;  // turns, 0 .. 1/4
    const double* weight;
};

/// Variances of modes that lie side by side, and their displacements [m].
struct RowShells {
    const double* variance[4];  // as QuadrantVariances
    const float* displacement;
    double step;      // of the wavenumber [rad/m]
    int row;          // m
    std::size_t end;  // of n
};
inline constexpr std::size_t kShellSums = 5;  // of aa, bb, ab, ac, bc

struct ModeRowLoops {
    /// Writes for each cell the sums of weight times density, in the order of QuadrantVariances.
    void (*variances)(const QuadrantTable&, const QuadrantCells&, double* const* variances);
    /// Writes h0 of `count` modes: their noise times the amplitude sqrt(variance) / 2 of the real
    /// and of the imaginary part. `step` is 1, or -1 to read the variances backwards.
    void (*waves)(const double* variance, std::ptrdiff_t step, const float* noise,
                  std::size_t count, float* h0);
    /// Adds what each mode adds to the covariance of the gradients to the sums of its shell
    /// max(n, m); `sums` begin with shell `first`.
    void (*shells)(const RowShells&, std::size_t first, double* const* sums);
};

/// Returns the loops of an instruction set that is compiled in. All give the same bits.
const ModeRowLoops& mode_row_loops(SimdLevel level);

}  // namespace ocean
