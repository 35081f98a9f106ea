// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The pool covers the work once, waits, and passes on exceptions.
#include "ocean/thread_pool.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "ocean/internal/platform.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

struct Stopped {};

TEST(ThreadPool, EveryItemOnceForAnyCount) {
    for (const int threads : {1, 2, 7}) {
        ThreadPool pool(threads);
        for (const int count : {0, 1, 5, 1000}) {
            std::vector<std::atomic<int>> hits(static_cast<std::size_t>(count));
            pool.for_each_range(count, [&](int first, int last) {
                for (int i = first; i < last; ++i) ++hits[static_cast<std::size_t>(i)];
            });
            for (const auto& hit : hits) EXPECT_EQ(hit.load(), 1);
        }
    }
}

TEST(ThreadPool, AnExceptionReachesTheCallerAndThePoolLivesOn) {
    ThreadPool pool(4);
    for (int round = 0; round < 50; ++round) {
        EXPECT_THROW(pool.for_each_range(100,
                                         [](int, int last) {
                                             if (last == 100) throw std::runtime_error("x");
                                         }),
                     std::runtime_error);
        std::atomic<int> sum = 0;
        pool.for_each_range(100, [&](int first, int last) { sum += last - first; });
        EXPECT_EQ(sum.load(), 100);
    }
}

TEST(ThreadPool, ManyShortCallsDoNotDeadlock) {
    ThreadPool pool(3);
    std::atomic<int> sum = 0;
    for (int round = 0; round < 5000; ++round) {
        pool.for_each_range(3, [&](int first, int last) { sum += last - first; });
    }
    EXPECT_EQ(sum.load(), 15000);
}

TEST(ThreadPool, OneThreadTakesItsItemsInOrder) {
    ThreadPool pool(1);
    std::vector<int> seen;
    pool.for_each_item(5, [&](int item, int) { seen.push_back(item); });
    EXPECT_EQ(seen, (std::vector{0, 1, 2, 3, 4}));
}

TEST(ThreadPool, AThreadThatIsHeldUpDoesNotHoldUpTheRest) {
    for (const int held : {0, 31, 63}) {  // at the ends and in the middle of the threads' shares
        ThreadPool pool(3);
        std::atomic<int> finished = 0;
        pool.for_each_item(64, [&](int item, int) {
            // Waits for all others, those of its own thread's share among them.
            if (item == held) {
                while (finished < 63) std::this_thread::yield();
            }
            ++finished;
        });
        EXPECT_EQ(finished.load(), 64);
    }
}

TEST(ThreadPool, JobsOfAHostDoAllItemsOnceWhateverItRuns) {
    using Job = std::function<void(int)>;
    const ThreadPool::RunJobs hosts[] = {
        [](int count, const Job& job) {
            std::vector<std::thread> threads;
            for (int i = 0; i < count; ++i) threads.emplace_back(job, i);
            for (std::thread& thread : threads) thread.join();
        },
        [](int count, const Job& job) {
            for (int i = count - 1; i >= 0; --i) job(i);
        },
        [](int, const Job& job) { job(1); },  // runs fewer jobs than requested
        [](int, const Job&) {},
    };
    for (const ThreadPool::RunJobs& host : hosts) {
        ThreadPool pool(3, host);
        EXPECT_EQ(pool.size(), 3);
        std::vector<std::atomic<int>> hits(100);
        pool.for_each_item(100, [&](int item, int thread) {
            ++hits[static_cast<std::size_t>(item)];
            EXPECT_TRUE(thread >= 0 && thread < 3);
        });
        for (const auto& hit : hits) EXPECT_EQ(hit.load(), 1);
        EXPECT_THROW(
            pool.for_each_item(10, [](int item, int) { item == 7 ? throw Stopped() : void(); }),
            Stopped);
        pool.set_interrupt([] { throw Stopped(); });
        EXPECT_THROW(pool.for_each_item(10, [](int, int) {}), Stopped);
    }
}

TEST(ThreadPool, MoreThreadsThanItemsIsFine) {
    ThreadPool pool(64);
    std::atomic<int> sum = 0;
    pool.for_each_range(5, [&](int first, int last) { sum += last - first; });
    EXPECT_EQ(sum.load(), 5);
}

TEST(ThreadPool, DefaultIsTheCoresOfTheProcess) {
    EXPECT_EQ(ThreadPool().size(), available_cores());
    EXPECT_GE(available_cores(), 1);
    EXPECT_GT(available_memory(), 1u << 20);
}

}  // namespace
}  // namespace ocean
