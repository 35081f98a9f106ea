// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C. A thread waits for SIGINT, SIGTERM and SIGHUP, so that what happens then is ordinary code
// and not a signal handler: it lets the files in hand become whole, begins no other, says farewell
// and ends the process with kInterruptedExit. Computing needs no care, since it leaves nothing
// behind.
#pragma once

#include <condition_variable>
#include <csignal>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace ocean::app {

inline constexpr int kInterruptedExit = 130;

class InterruptWatch {
  public:
    /// Make it before any other thread: the signals are blocked in all threads started later.
    explicit InterruptWatch(std::function<void()> farewell);
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// While any of these lives the process does not end. Any thread, one at a time for each: two
    /// in one thread could wait for each other.
    class Hold {
      public:
        explicit Hold(InterruptWatch& watch);
        ~Hold();
        Hold(const Hold&) = delete;
        Hold& operator=(const Hold&) = delete;

      private:
        InterruptWatch& watch_;
    };
    /// After a signal it does not return any more.
    [[nodiscard]] Hold hold() { return Hold(*this); }

    /// What is to be done last of all, before the farewell and when no Hold lives, as long as this
    /// object does. It must not take a Hold.
    class LastAct {
      public:
        LastAct(InterruptWatch& watch, std::function<void()> act);
        ~LastAct();
        LastAct(const LastAct&) = delete;
        LastAct& operator=(const LastAct&) = delete;

      private:
        InterruptWatch& watch_;
    };

  private:
    void end_process();

    std::mutex mutex_;
    std::condition_variable changed_;
    int holds_ = 0;
    bool ending_ = false;
    std::function<void()> last_act_;
    std::function<void()> farewell_;
    sigset_t signals_;
    std::thread thread_;
};

/// io::write_output, during which the process does not end.
void write_output(InterruptWatch& interrupts, const std::string& path, std::string_view bytes);

}  // namespace ocean::app
