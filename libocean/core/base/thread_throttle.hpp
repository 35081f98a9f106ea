// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The number of a pool's threads that is worth using. Beside other busy processes, threads wait for
// each other's cores in time slices as long as a frame, so two of them may take longer than one. If
// the threads of a call get less than kMinGain of a core more than they would without the last of
// them, the last one pauses. After the pause it is tried again; each failure doubles the pause.
#pragma once

#include <algorithm>
#include <chrono>

#include "ocean/internal/platform.hpp"

namespace ocean {

class ThreadThrottle {
  public:
    using Clock = std::chrono::steady_clock;
    static constexpr Clock::duration kShortestPause = std::chrono::milliseconds(16);
    static constexpr Clock::duration kLongestPause = std::chrono::seconds(1);
    static constexpr double kMinGain = 0.25;  // min gain of the last thread [cores]

    explicit ThreadThrottle(int max_threads) : max_(max_threads), threads_(max_threads) {}

    /// Returns the threads of a call that begins now, 1 .. max_threads.
    int choose(Clock::time_point now) {
        if (threads_ < max_ && now >= retry_) {
            ++threads_;
            retry_ = now + kShortestPause;
        }
        return threads_;
    }

    /// Returns true if the usage of the call's threads should be measured. That takes a
    /// microsecond, and short calls rarely meet the end of a time slice.
    bool wants_usage() const { return threads_ > 1 && last_ >= kShortCall; }

    /// Learns from a call that has ended. `used`: the usage of its threads, 0 if not measured.
    void ended(Clock::time_point began, Clock::time_point now, const ThreadUsage& used) {
        last_ = now - began;
        const std::chrono::duration<double> wall = last_;
        const double worth_it = (threads_ - 1 + kMinGain) * wall.count();
        if (threads_ > 1 && used.preemptions > 0 && used.seconds < worth_it) {
            --threads_;
            crowded_ = now;
            retry_ = now + pause_;
            pause_ = std::min(2 * pause_, kLongestPause);
        } else if (now - crowded_ > 2 * pause_) {
            pause_ = kShortestPause;  // reset: a retry has succeeded since
        }
    }

  private:
    static constexpr Clock::duration kShortCall = std::chrono::microseconds(500);

    int max_, threads_;
    Clock::duration last_{};                  // duration of the last call
    Clock::duration pause_ = kShortestPause;  // pause after the next crowded call
    Clock::time_point retry_{}, crowded_{};
};

}  // namespace ocean
