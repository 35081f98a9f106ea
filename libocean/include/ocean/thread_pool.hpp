// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A small blocking pool: fixed partition of the work, no spinning, no globals. Equal bits for any
// number of threads follow from the partition being over independent items.
#pragma once

#include <functional>
#include <memory>

namespace ocean {

/// One caller at a time. The caller's thread takes part in the work.
class ThreadPool {
  public:
    /// 0 = the cores this process may use.
    explicit ThreadPool(int threads = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int size() const;
    /// Calls body(first, last) on each thread's share of [0, count) and waits. The first exception
    /// of any share is thrown again here.
    void for_each_range(int count, const std::function<void(int first, int last)>& body);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ocean
