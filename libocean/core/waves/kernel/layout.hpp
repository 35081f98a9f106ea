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

/// The positions for a kernel of `lanes` lanes: a parameter, so that cache_sets_test.cpp computes
/// those of every width.
template <int lanes>
struct LayoutOf {
    /// Pairs of blocks of `lanes` x in an item.
    static constexpr int kPairs = kPartner / lanes;
    /// Returns the item that reads a block of `lanes` x.
    static constexpr int item_of(int block) { return block / (2 * kPairs); }

    /// Between the sweeps: B lines of A complex values. Each line has one value more, so that a
    /// step from line to line is not a multiple of the cache's sets.
    template <int A>
    struct Sweep {
        static constexpr int kLine = (A + 1) * 2 * lanes;  // floats
        /// Returns the block of x = k + A m, with k in this group of `lanes`.
        static constexpr int block_of(int group, int m) { return A / lanes * m + group; }
    };

    /// A row of the tile for the transposition of a block; its length is odd in vectors, for the
    /// same reason.
    static constexpr int kTileStride = (lanes + 1) * 2 * lanes;

    /// Between the passes, in the order in which pass two reads: for each pair of x blocks, for
    /// each source, for each j < B / 2, for each i: ky = j' + B i for the two lines j' of j, and
    /// for each ky both blocks of x: [re | im].
    static constexpr int kBlock = 2 * lanes;       // [re | im]
    static constexpr int kEntry = 2 * 2 * kBlock;  // two ky, two blocks of x

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
        /// Returns the offset of a block of x: blocks 0 .. kPairs - 1 of an item are the first ones
        /// of its pairs.
        static std::size_t x_block(const FrameTask& task, int block) {
            const int within = block % (2 * kPairs);
            return static_cast<std::size_t>(item_of(block) * kPairs + within % kPairs) *
                       task.pair_stride +
                   static_cast<std::size_t>(within / kPairs) * kBlock;
        }
    };
};

using Layout = LayoutOf<kLanes>;
inline constexpr int kPairs = Layout::kPairs;
inline constexpr int kTileStride = Layout::kTileStride;
inline constexpr int kBlock = Layout::kBlock;
inline constexpr int kEntry = Layout::kEntry;
template <int A>
using Sweep = Layout::Sweep<A>;
template <int B>
using Intermediate = Layout::Intermediate<B>;

}  // namespace ocean::OCEAN_KERNEL
