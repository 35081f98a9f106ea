// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How many threads of a pool it pays to use. Beside other processes, threads wait for each other's
// cores, in time slices that are as long as a frame: two of them then take longer than one. Where
// the threads of a call did not get one core more than without the last of them, there is one fewer
// for a while; after it one more is tried, and the while doubles as long as that goes wrong.
#pragma once

#include <algorithm>
#include <chrono>

#include "ocean/internal/platform.hpp"

namespace ocean {

class CrewSize {
  public:
    using Clock = std::chrono::steady_clock;
    static constexpr Clock::duration kShortestPause = std::chrono::milliseconds(16);
    static constexpr Clock::duration kLongestPause = std::chrono::seconds(1);
    static constexpr double kLeastGain = 0.25;  // cores that the last thread must bring

    explicit CrewSize(int most) : most_(most), crew_(most) {}

    /// Threads of a call that begins now, 1 .. most.
    int choose(Clock::time_point now) {
        if (crew_ < most_ && now >= retry_) {
            ++crew_;
            retry_ = now + kShortestPause;
        }
        return crew_;
    }

    /// Is it to be measured what its threads use? That takes a microsecond, and short calls rarely
    /// meet the end of a time slice.
    bool asks_for_usage() const { return crew_ > 1 && last_ >= kShortCall; }

    /// That call is over, for which its threads used so much (nothing if it was not measured).
    void ended(Clock::time_point began, Clock::time_point now, const ThreadUsage& used) {
        last_ = now - began;
        const std::chrono::duration<double> wall = last_;
        const double worth_it = (crew_ - 1 + kLeastGain) * wall.count();
        if (crew_ > 1 && used.preemptions > 0 && used.seconds < worth_it) {
            --crew_;
            crowded_ = now;
            retry_ = now + pause_;
            pause_ = std::min(2 * pause_, kLongestPause);
        } else if (now - crowded_ > 2 * pause_) {
            pause_ = kShortestPause;  // a retry, half of that ago, went well since
        }
    }

  private:
    static constexpr Clock::duration kShortCall = std::chrono::microseconds(500);

    int most_, crew_;
    Clock::duration last_{};                  // how long the last call took
    Clock::duration pause_ = kShortestPause;  // after the next call that is crowded
    Clock::time_point retry_{}, crowded_{};
};

}  // namespace ocean
