// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C. A thread waits for SIGINT, SIGTERM and SIGHUP, so that ordinary code instead of a signal
// handler reacts to them: it lets the current files be completed and no other be started, calls the
// farewell and ends the process with kInterruptedExit. Computations can be cut off anywhere,
// because they leave nothing behind.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace ocean::app {

inline constexpr int kInterruptedExit = 130;

class InterruptWatch {
  public:
    /// Must be constructed before other threads: it blocks the signals in all threads started
    /// later.
    explicit InterruptWatch(std::function<void()> farewell);
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// Keeps the process from ending as long as it lives. Any thread may have one, but not two,
    /// which could wait for each other.
    class Hold {
      public:
        explicit Hold(InterruptWatch& watch);
        ~Hold();
        Hold(const Hold&) = delete;
        Hold& operator=(const Hold&) = delete;

      private:
        InterruptWatch& watch_;
    };
    /// Returns a Hold; after a signal it blocks forever.
    [[nodiscard]] Hold hold() { return Hold(*this); }

    /// A function that is called before the farewell, when no Hold exists, as long as this object
    /// lives. It must not call hold().
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
    [[noreturn]] void end_process();

    std::mutex mutex_;
    std::condition_variable changed_;
    int holds_ = 0;
    bool ending_ = false;
    std::function<void()> last_act_;
    std::function<void()> farewell_;
    struct Signals;  // of the system
    std::unique_ptr<Signals> signals_;
};

/// Calls io::write_output with a Hold.
void write_output(InterruptWatch& interrupts, const std::string& path, std::string_view bytes);

}  // namespace ocean::app
