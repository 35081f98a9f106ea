// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: frames finish in any order and are delivered in their own, for any number of workers.
#include "frame_baker.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "testing.hpp"

namespace ocean {
namespace {

/// A job with a duration of its own, so that jobs end in another order than they start.
void sleep_a_little(int seed) {
    std::minstd_rand random(static_cast<unsigned>(seed) + 1);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 200));
}

std::vector<int> first(int count) {
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

TEST(FrameWorkers, DeliverEachJobOnceAndInOrder) {
    for (const int workers : {1, 2, 3, 8}) {
        std::vector<int> delivered;
        std::vector<std::atomic<int>> done(300);
        run_in_order(
            300, workers,
            [&](int worker, int index) {
                EXPECT_TRUE(worker >= 0 && worker < workers);
                sleep_a_little(index);
                ++done[static_cast<std::size_t>(index)];
                return true;
            },
            [&](int index) {
                EXPECT_EQ(done[static_cast<std::size_t>(index)], 1);
                delivered.push_back(index);
            });
        EXPECT_EQ(delivered, first(300)) << workers;
    }
}

TEST(FrameWorkers, StayCloseToDelivery) {
    std::atomic<int> begun = 0;
    run_in_order(
        60, 4, [&](int, int) { return ++begun, true; },
        [&](int index) {
            const int limit = std::min(60, index + 2 * 4);
            while (begun < limit) std::this_thread::yield();  // until the limit is reached
            EXPECT_LE(begun, index + 2 * 4) << "finished frames would pile up in memory";
        });
    EXPECT_EQ(begun, 60);
}

TEST(FrameWorkers, StartNoJobAfterOneThatReturnsFalse) {
    for (int repeat = 0; repeat < 50; ++repeat) {
        std::atomic<int> begun = 0;
        std::vector<int> delivered;
        run_in_order(
            100, 3,
            [&](int, int index) {
                ++begun;
                sleep_a_little(index + 100 * repeat);
                return index != 20;
            },
            [&](int index) { delivered.push_back(index); });
        EXPECT_EQ(delivered, first(begun)) << "what was begun is delivered";
        EXPECT_GE(begun, 21);
        EXPECT_LE(begun, 21 + 2 * 3);
    }
}

TEST(FrameWorkers, EndWhenDeliverThrows) {
    std::atomic<int> begun = 0;
    std::atomic<int> in_hand = 0;
    EXPECT_THROW(run_in_order(
                     1000, 3,
                     [&](int, int index) {
                         ++begun;
                         ++in_hand;
                         sleep_a_little(index);
                         --in_hand;
                         return true;
                     },
                     [&](int index) {
                         if (index == 5) throw std::runtime_error("standard output is gone");
                     }),
                 std::runtime_error);
    EXPECT_EQ(in_hand, 0) << "no job outlives the call";
    EXPECT_LE(begun, 6 + 2 * 3);
}

TEST(FrameWorkers, AcceptNoFrames) {
    run_in_order(
        0, 2, [](int, int) { return ADD_FAILURE(), true; }, [](int) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace ocean
