// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Threads that wait for each other's cores are used less, and used again when they do not.
#include "base/crew_size.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace ocean {
namespace {

using std::chrono::milliseconds;

/// Calls of 2 ms, one after another, of threads that share the free cores.
struct Machine {
    CrewSize crew;
    CrewSize::Clock::time_point now = CrewSize::Clock::now();
    int crowded = 0;

    void call(int free_cores) {
        const int threads = crew.choose(now);
        const bool wait = threads > free_cores;
        const auto began = now;
        now += milliseconds(2);
        crew.ended(began, now, {wait ? 1 : 0, 0.002 * (wait ? free_cores : threads)});
        crowded += wait ? 1 : 0;
    }

    void run(milliseconds time, int free_cores) {
        crowded = 0;
        for (const auto end = now + time; now < end;) call(free_cores);
    }
};

TEST(CrewSize, IsAllThreadsOnAQuietMachine) {
    Machine machine{CrewSize(4)};
    machine.run(milliseconds(5000), 4);
    EXPECT_EQ(machine.crowded, 0);
    EXPECT_EQ(machine.crew.choose(machine.now), 4);
}

TEST(CrewSize, TriesAThreadMoreOnceASecondBesideABusyProcess) {
    Machine machine{CrewSize(2)};
    machine.run(milliseconds(3000), 1);
    EXPECT_LE(machine.crowded, 10);  // 16 + 32 + .. + 1000 ms
    machine.run(milliseconds(10000), 1);
    EXPECT_GE(machine.crowded, 9);
    EXPECT_LE(machine.crowded, 10);
}

TEST(CrewSize, LeavesOneCoreOfSixteenToOthers) {
    Machine machine{CrewSize(16)};
    machine.run(milliseconds(3000), 13);
    machine.run(milliseconds(10000), 13);
    EXPECT_LE(machine.crowded, 10);
    EXPECT_GE(machine.crew.choose(machine.now), 13);
}

TEST(CrewSize, TakesAllThreadsAgainWithinASecondAndAHalf) {
    Machine machine{CrewSize(16)};
    machine.run(milliseconds(10000), 2);
    machine.run(milliseconds(1500), 16);
    EXPECT_EQ(machine.crew.choose(machine.now), 16);
}

TEST(CrewSize, ASingleMishapCostsAThreadForAPauseOfSixteenMilliseconds) {
    Machine machine{CrewSize(2)};
    for (int mishap = 0; mishap < 5; ++mishap) {
        machine.run(milliseconds(500), 2);
        machine.call(1);
        EXPECT_EQ(machine.crew.choose(machine.now + milliseconds(15)), 1);
        EXPECT_EQ(machine.crew.choose(machine.now + milliseconds(17)), 2);
    }
}

TEST(CrewSize, IsAtLeastOne) {
    Machine machine{CrewSize(3)};
    for (int call = 0; call < 5; ++call) machine.call(0);
    EXPECT_EQ(machine.crew.choose(machine.now), 1);
}

TEST(CrewSize, ThreadsThatWaitForTheirOwnItemsAreKept) {
    CrewSize crew(4);
    const auto began = CrewSize::Clock::now();
    crew.ended(began, began + milliseconds(2), {0, 0.002});   // nobody took their cores
    crew.ended(began, began + milliseconds(2), {3, 0.0066});  // taken for a moment
    EXPECT_EQ(crew.choose(began + milliseconds(3)), 4);
    crew.ended(began, began + milliseconds(2), {3, 0.0064});
    EXPECT_EQ(crew.choose(began + milliseconds(3)), 3);
}

}  // namespace
}  // namespace ocean
