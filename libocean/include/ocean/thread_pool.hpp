// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A small blocking pool without spinning and without globals. It cuts the work the same way for any
// number of threads; as the items are independent, so are the bits of the result. Where other
// processes compete for the cores, it uses fewer threads (core/base/thread_throttle.hpp).
//
//     ThreadPool pool;  // the cores that this process may use
//     pool.for_each_range(rows, [&](int first, int last) {
//         for (int row = first; row < last; ++row) shade(row);
//     });
//     pool.set_interrupt([] { if (stopped) throw Error(ErrorKind::interrupted, "stopped"); });
#pragma once

#include <functional>
#include <memory>

namespace ocean {

/// One caller at a time; the calling thread takes part in the work. In a child process after
/// fork(), which does not inherit threads, the pool starts new ones when it is next used.
class ThreadPool {
  public:
    /// Runs job(0) .. job(count - 1), in any order, on any threads, and returns when all are done.
    using RunJobs = std::function<void(int count, const std::function<void(int)>& job)>;

    /// Starts the threads. threads: 0 = the cores this process may use. With run_jobs the pool has
    /// no threads of its own and runs at most `threads` jobs at once on the host's; one of these
    /// then calls the interrupt.
    explicit ThreadPool(int threads = 0, RunJobs run_jobs = {});
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int size() const;
    /// Sets a function that the calling thread calls about 100 times a second while a call works.
    /// If it throws, the call ends with that exception and skips the items that have not begun.
    /// Empty: none.
    void set_interrupt(std::function<void()> interrupt);
    /// Calls body(first, last) on shares of [0, count), one share for each thread or, if an
    /// interrupt is set, smaller shares, and waits. Rethrows the first exception of any share.
    void for_each_range(int count, const std::function<void(int first, int last)>& body);
    /// Calls body(item, thread) for each item of [0, count), thread < size(), and waits. A thread
    /// processes neighbouring items in order and then helps the others, so that a delayed thread
    /// does not delay the rest. Rethrows the first exception. Allocates nothing.
    void for_each_item(int count, const std::function<void(int item, int thread)>& body);

  private:
    struct Impl;
    void leave_to_the_parent();

    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean
