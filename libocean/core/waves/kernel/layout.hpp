// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The positions of values between the sweeps and between the passes.
#pragma once

#include "base/simd/simd.hpp"
#include "frame_task.hpp"

namespace ocean::OCEAN_KERNEL {

inline constexpr int kLineFloats = 16;  // floats of a cache line

/// Lines are paired over this distance of x for every width: the rounding of a line depends on its
/// partner, and the bits must not depend on the width. An item of pass two is twice as wide.
inline constexpr int kPartner = 16;
inline constexpr int kItemWidth = 2 * kPartner;
/// Pairs of blocks of kLanes in an item.
inline constexpr int kPairs = kPartner / kLanes;
/// Returns the item that reads a block of kLanes x.
constexpr int item_of(int block) {
    return block / (2 * kPairs);
}

/// Between the sweeps: B lines of A complex values. Each line has one value more, so that a step
/// from line to line is not a multiple of the cache's sets.
template <int A>
struct Sweep {
    static constexpr int kLine = (A + 1) * 2 * kLanes;  // floats
};

/// A row of the tile for the transposition of a block; its length is odd in vectors, for the same
/// reason.
inline constexpr int kTileStride = (kLanes + 1) * 2 * kLanes;

/// Between the passes, in the order in which pass two reads: for each pair of x blocks, for each
/// source, for each j < B / 2, for each i: ky = j' + B i for the two lines j' of j, and for each ky
/// both blocks of x: [re | im].
inline constexpr int kBlock = 2 * kLanes;      // [re | im]
inline constexpr int kEntry = 2 * 2 * kBlock;  // two ky, two blocks of x

template <int B>
struct Intermediate {
    static std::size_t rows(const FrameTask& task) {
        return static_cast<std::size_t>(task.columns / B);
    }
    /// Returns the offset of one ky within a pair of x blocks.
    static std::size_t place(const FrameTask& task, int source, int ky) {
        const int j = ky % B;
        const bool mirrored = j >= B / 2;  // lines j and B - j, or 0 and B / 2
        const int line = j == B / 2 ? 0 : mirrored ? B - j : j;
        return static_cast<std::size_t>(source) * task.source_stride +
               static_cast<std::size_t>(line) * task.line_stride +
               static_cast<std::size_t>(ky / B) * kEntry + (mirrored ? 2 * kBlock : 0);
    }
    /// Returns the offset of a block of x: blocks 0 .. kPairs - 1 of an item are the first ones of
    /// its pairs.
    static std::size_t x_block(const FrameTask& task, int block) {
        const int within = block % (2 * kPairs);
        return static_cast<std::size_t>(item_of(block) * kPairs + within % kPairs) *
                   task.pair_stride +
               static_cast<std::size_t>(within / kPairs) * kBlock;
    }
};

}  // namespace ocean::OCEAN_KERNEL
