// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C. A thread waits for SIGINT, SIGTERM and SIGHUP, so that what happens then is ordinary code
// and not a signal handler: it lets the file in hand become whole, says farewell and ends the
// process with 130. Computing needs no care, since it leaves nothing behind.
#pragma once

#include <csignal>
#include <functional>
#include <mutex>
#include <thread>

namespace ocean::app {

class InterruptWatch {
  public:
    /// Make it before any other thread: the signals are blocked in all threads started later.
    explicit InterruptWatch(std::function<void()> farewell);
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// While the lock is held the process does not end.
    [[nodiscard]] std::unique_lock<std::mutex> hold() { return std::unique_lock(mutex_); }

  private:
    std::mutex mutex_;
    sigset_t signals_;
    std::thread thread_;
};

}  // namespace ocean::app
