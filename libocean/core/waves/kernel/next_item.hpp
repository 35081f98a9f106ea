// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Prefetching of the next item of a pass while this one is computed: a few cache lines with each
// value that a codelet loads, so that reading and arithmetic overlap. If all lines were prefetched
// at once, the reads would wait for each other. [measured, N = 1024 with AVX-512: 6.6 to 4.9 ms a
// frame of vertices]
#pragma once

#include <cstddef>

#include "base/simd/simd.hpp"

namespace ocean::OCEAN_KERNEL {

/// kLines: cache lines prefetched per loaded value.
template <int kLines>
class NextItem {
  public:
    static constexpr int kFloats = kLines * 16;

    /// Takes an item's floats. nowhere: an address in the cache, prefetched when nothing is left to
    /// prefetch.
    OCEAN_INLINE NextItem(const float* first, std::size_t count, const float* nowhere)
        : first_(first), count_(count), nowhere_(nowhere) {}

    /// Returns the share to be prefetched with codelet `number` of this item, of `points` values.
    OCEAN_INLINE const float* share(int number, int points) const {
        const std::size_t place =
            static_cast<std::size_t>(number) * static_cast<std::size_t>(points * kFloats);
        return place < count_ ? first_ + place : nowhere_;
    }

    /// Prefetches the lines that belong to value j of a share.
    OCEAN_INLINE static void ask(const float* share, int j) {
        for (int line = j * kLines; line < (j + 1) * kLines; ++line) {
            __builtin_prefetch(share + line * 16, 0, 2);  // to the second cache
        }
    }

  private:
    const float* first_;
    std::size_t count_;  // floats
    const float* nowhere_;
};

}  // namespace ocean::OCEAN_KERNEL
