// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Work on many cells that reports its progress and can be stopped, in serial and in parallel loops.
#pragma once

#include <chrono>
#include <functional>

#include "land/streams/stream_grid.hpp"
#include "ocean/internal/stream_power.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

class StreamWork {
  public:
    /// total: the work of all passes, a rough measure; this class measures work in [ns of one
    /// thread].
    StreamWork(ThreadPool& pool, const StreamProgress& progress, double total)
        : pool_(pool), progress_(progress), total_(total) {}

    /// Adds finished work, and calls progress if its last call was long ago. Called by the calling
    /// thread after at most 0.1 s of work.
    void add(double work);
    /// Calls body(item) for items of about `work` each on all threads, with calls of progress
    /// between batches. The items must be independent: any thread may run any item.
    void each(int count, double work, const std::function<void(int item)>& body);
    /// Calls body(first, last) for blocks of rows of a grid; `cost` is the work of a cell.
    void rows(const StreamGrid& grid, double cost,
              const std::function<void(int first, int last)>& body);

  private:
    using Clock = std::chrono::steady_clock;

    ThreadPool& pool_;
    const StreamProgress& progress_;
    double total_;
    double done_ = 0.0;
    Clock::time_point next_{};
};

}  // namespace ocean
