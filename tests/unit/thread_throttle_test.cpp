// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Threads that wait for each other's cores pause, and are used again once the cores are free.
#include "base/thread_throttle.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace ocean {
namespace {

using std::chrono::milliseconds;

/// Calls of 2 ms, one after another, of threads that share the free cores.
struct Machine {
    ThreadThrottle throttle;
    ThreadThrottle::Clock::time_point now = ThreadThrottle::Clock::now();
    int crowded = 0;

    void call(int free_cores) {
        const int threads = throttle.choose(now);
        const bool wait = threads > free_cores;
        const auto began = now;
        now += milliseconds(2);
        throttle.ended(began, now, {wait ? 1 : 0, 0.002 * (wait ? free_cores : threads)});
        crowded += wait ? 1 : 0;
    }

    void run(milliseconds time, int free_cores) {
        crowded = 0;
        for (const auto end = now + time; now < end;) call(free_cores);
    }
};

TEST(ThreadThrottle, IsAllThreadsOnAQuietMachine) {
    Machine machine{ThreadThrottle(4)};
    machine.run(milliseconds(5000), 4);
    EXPECT_EQ(machine.crowded, 0);
    EXPECT_EQ(machine.throttle.choose(machine.now), 4);
}

TEST(ThreadThrottle, TriesAThreadMoreOnceASecondBesideABusyProcess) {
    Machine machine{ThreadThrottle(2)};
    machine.run(milliseconds(3000), 1);
    EXPECT_LE(machine.crowded, 10);  // 16 + 32 + .. + 1000 ms
    machine.run(milliseconds(10000), 1);
    EXPECT_GE(machine.crowded, 9);
    EXPECT_LE(machine.crowded, 10);
}

TEST(ThreadThrottle, LeavesOneCoreOfSixteenToOthers) {
    Machine machine{ThreadThrottle(16)};
    machine.run(milliseconds(3000), 13);
    machine.run(milliseconds(10000), 13);
    EXPECT_LE(machine.crowded, 10);
    EXPECT_GE(machine.throttle.choose(machine.now), 13);
}

TEST(ThreadThrottle, TakesAllThreadsAgainWithinASecondAndAHalf) {
    Machine machine{ThreadThrottle(16)};
    machine.run(milliseconds(10000), 2);
    machine.run(milliseconds(1500), 16);
    EXPECT_EQ(machine.throttle.choose(machine.now), 16);
}

TEST(ThreadThrottle, ASingleMishapCostsAThreadForAPauseOfSixteenMilliseconds) {
    Machine machine{ThreadThrottle(2)};
    for (int mishap = 0; mishap < 5; ++mishap) {
        machine.run(milliseconds(500), 2);
        machine.call(1);
        EXPECT_EQ(machine.throttle.choose(machine.now + milliseconds(15)), 1);
        EXPECT_EQ(machine.throttle.choose(machine.now + milliseconds(17)), 2);
    }
}

TEST(ThreadThrottle, IsAtLeastOne) {
    Machine machine{ThreadThrottle(3)};
    for (int call = 0; call < 5; ++call) machine.call(0);
    EXPECT_EQ(machine.throttle.choose(machine.now), 1);
}

TEST(ThreadThrottle, ThreadsThatWaitForTheirOwnItemsAreKept) {
    ThreadThrottle throttle(4);
    const auto began = ThreadThrottle::Clock::now();
    throttle.ended(began, began + milliseconds(2), {0, 0.002});   // no core was taken away
    throttle.ended(began, began + milliseconds(2), {3, 0.0066});  // taken away for a moment
    EXPECT_EQ(throttle.choose(began + milliseconds(3)), 4);
    throttle.ended(began, began + milliseconds(2), {3, 0.0064});
    EXPECT_EQ(throttle.choose(began + milliseconds(3)), 3);
}

}  // namespace
}  // namespace ocean
