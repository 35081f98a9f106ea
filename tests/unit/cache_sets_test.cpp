// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The strides of the kernel against the sets of a cache: the lines of memory that one step of a
// pass touches together share no set with more lines than it has ways. Computed from the layout
// for every width, because neither valgrind nor every machine knows AVX-512.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "waves/kernel/frame_task.hpp"
#include "waves/kernel/layout.hpp"

namespace ocean {
namespace {

/// First caches of 32 KiB with 8 ways and of 48 KiB with 12 have 64 sets; second caches of 512 KiB
/// with 8 ways and of 2 MiB with 16 have 1024 and 2048. The smaller of each pair is the stricter.
constexpr std::size_t kFirstSets = 64;
constexpr std::size_t kSecondSets = 1024;
constexpr int kWays = 8;
constexpr auto kLineFloats = static_cast<std::size_t>(OCEAN_KERNEL::kLineFloats);

class Step {
  public:
    void touch(std::size_t first, int floats) {
        const std::size_t last = first + static_cast<std::size_t>(floats) - 1;
        for (std::size_t i = first / kLineFloats; i <= last / kLineFloats; ++i) lines_.insert(i);
    }
    /// Returns the largest number of lines that share one of the sets.
    int most(std::size_t sets) const {
        std::vector<int> count(sets);
        for (const std::size_t line : lines_) ++count[line % sets];
        return std::ranges::max(count);
    }
    /// Expects that all lines stay in both caches or, if they are more than the first cache has,
    /// that they are evenly spread over it.
    void expect_spread(int ways_of_first = kWays) const {
        const auto share = static_cast<int>((lines_.size() + kFirstSets - 1) / kFirstSets);
        EXPECT_LE(most(kFirstSets), std::max(ways_of_first, share));
        EXPECT_LE(most(kSecondSets), kWays);
    }

  private:
    std::set<std::size_t> lines_;
};

constexpr std::size_t times(int n, std::size_t step) {
    return static_cast<std::size_t>(n) * step;
}

template <int lanes, int A, int B>
struct Passes {
    static_assert(A == first_factor(A * B));
    using Layout = OCEAN_KERNEL::LayoutOf<lanes>;
    static constexpr std::size_t kLine = Layout::template Sweep<A>::kLine;
    static constexpr int kValue = Layout::kBlock;  // floats of a complex value of all lanes

    /// Touches what a codelet of a second sweep reads.
    static Step second_sweep() {
        Step step;
        for (int j = 0; j < B; ++j) step.touch(times(j, kLine), kValue);
        return step;
    }

    static void check_pass_one(const FrameTask& task) {
        Step codelet = second_sweep();
        const std::size_t tile = times(task.source_count * B, kLine);
        for (int m = 0; m < B; ++m) codelet.touch(tile + times(m, Layout::kTileStride), kValue);
        codelet.expect_spread();
        for (int block = 0; block < std::max(B / lanes, 1); ++block) {  // of ky; then j repeats
            for (int group = 0; group < A / lanes; ++group) check_stores(task, block, group);
        }
    }

    /// Checks the stores of the transposes, which are prefetched for a whole group.
    static void check_stores(const FrameTask& task, int block, int group) {
        using Intermediate = Layout::template Intermediate<B>;
        Step all;
        for (int m = 0; m < B; ++m) {
            const int to = Layout::template Sweep<A>::block_of(group, m);
            Step transpose;
            for (int lane = 0; lane < lanes; ++lane) {
                const std::size_t place = Intermediate::x_block(task, to) +
                                          Intermediate::place(task, 0, block * lanes + lane);
                transpose.touch(place, kValue);
                all.touch(place, kValue);
            }
            EXPECT_LE(transpose.most(kFirstSets), 2);
        }
        // Pairs of x blocks lie whole lines apart, but a value of four lanes is half a line: its
        // groups use every fourth set at this size.
        all.expect_spread(lanes == 4 && A * B == 4096 ? 16 : kWays);
    }

    static void check_pass_two() {
        Step first;  // both halves of a line, of all rows
        first.touch(0, A / 2 * Layout::kEntry);
        first.touch(times(A / 2, Layout::kEntry), A * kValue);
        first.expect_spread();
        Step second = second_sweep();
        second.touch(times(B, kLine), B * OCEAN_KERNEL::kItemWidth);
        second.expect_spread();
        // The rows that it writes lie in the caller's memory: with a pitch of N floats they all
        // share a set, where rows prefetched together would displace each other. Each is written
        // whole, once.
        Step rows;
        for (int l = 0; l < B; ++l) rows.touch(times(l * A, A * B), OCEAN_KERNEL::kItemWidth);
        EXPECT_EQ(rows.most(kFirstSets), B);
    }
};

template <int lanes, int A, int B>
void check_size() {
    for (const int sources : {3, 4, 5, 8}) {
        SCOPED_TRACE(testing::Message()
                     << lanes << " lanes, N = " << A * B << ", " << sources << " sources");
        FrameTask task{};
        task.size = A * B;
        task.columns = A * B / 2;
        task.source_count = sources;
        lay_out(task, lanes);
        Passes<lanes, A, B>::check_pass_one(task);
        Passes<lanes, A, B>::check_pass_two();
    }
}

template <int lanes>
void check_sizes() {
    check_size<lanes, 16, 16>();
    check_size<lanes, 32, 16>();
    check_size<lanes, 32, 32>();
    check_size<lanes, 64, 32>();
    check_size<lanes, 64, 64>();
}

TEST(CacheSets, HoldTheLinesOfEachStepOfTheKernel) {
    check_sizes<4>();
    check_sizes<8>();
    check_sizes<16>();
}

}  // namespace
}  // namespace ocean
