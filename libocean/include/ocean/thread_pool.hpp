// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A small blocking pool: the work is cut the same way for any number of threads, no spinning, no
// globals. Equal bits for any number of threads follow from the items being independent. Where
// other processes want the cores too, it gets by with fewer threads (core/base/crew_size.hpp).
#pragma once

#include <functional>
#include <memory>

namespace ocean {

/// One caller at a time. The caller's thread takes part in the work. In a child process after
/// fork(), where threads do not go along, the pool has new ones when it is next used.
class ThreadPool {
  public:
    /// Runs job(0) .. job(count - 1), in any order, on any threads, and returns when all are done.
    using RunJobs = std::function<void(int count, const std::function<void(int)>& job)>;

    /// 0 = the cores this process may use. With run_jobs on the threads of a host, at most so many
    /// jobs at once; an interrupt is then called by one of these.
    explicit ThreadPool(int threads = 0, RunJobs run_jobs = {});
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int size() const;
    /// Called by the caller's thread about a hundred times a second while a call works; what it
    /// throws ends the call, and items that nobody has begun are left out. Empty: none.
    void set_interrupt(std::function<void()> interrupt);
    /// Calls body(first, last) on shares of [0, count), one for each thread or, where an interrupt
    /// may come between, smaller ones, and waits. The first exception of any share is thrown again
    /// here.
    void for_each_range(int count, const std::function<void(int first, int last)>& body);
    /// Calls body(item, thread) for each item of [0, count) and waits; thread < size(). A thread
    /// goes through neighbouring items in order and then helps the others, so that one that is held
    /// up does not hold up the rest.
    /// Exceptions as above. Allocates nothing.
    void for_each_item(int count, const std::function<void(int item, int thread)>& body);

  private:
    struct State;
    void leave_to_the_parent();

    std::unique_ptr<State> state_;
};

}  // namespace ocean
