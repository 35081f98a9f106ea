// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the transform of sixteen columns: plain data, so that the files compiled for one
// instruction set need nothing of the standard library.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/simd/simd_level.hpp"

namespace ocean {

inline constexpr int kFftBatch = 16;

/// One complex number of each of kFftBatch columns.
struct BatchRow {
    alignas(64) float re[kFftBatch];
    float im[kFftBatch];
};

/// The place of the sums of a transform.
struct BatchOutput {
    BatchRow* work;  // size rows, which hold the sums unless `numbers` does
    /// A flag for each row; rows of 0 may be left unmade. nullptr: all are made.
    const std::uint8_t* needed = nullptr;
    /// Complex numbers, the columns side by side, in rows of `pitch` numbers; or nullptr.
    float* numbers = nullptr;
    std::size_t pitch = 0;
};

struct BatchFftTask {
    int size;
    int reach;
    int group;                 // samples of a group that has one input
    const int* wave_of_group;  // beyond reach: none
    const float* cosine;       // of 2 pi k / size, k < size / 2
    const float* sine;
    const BatchRow* spectrum;
    std::size_t stride;
    BatchOutput out;
};

using BatchFftLoop = void (*)(const BatchFftTask&);

/// Returns the transform of an instruction set that is compiled in. All give the same bits.
BatchFftLoop batch_fft_loop(SimdLevel level);

}  // namespace ocean
