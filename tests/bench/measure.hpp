// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rounds: all subjects in turn, so that whatever the machine does meanwhile it does to all. What
// counts are ratios within a round.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace ocean::bench {

/// Of this process's threads together, or on the wall.
enum class Clock { cpu, wall };
double seconds(Clock clock);

/// hot: three untimed frames of the same subject before each timed one. cold: one frame of each,
/// all the others' in between.
enum class State { hot, cold };
const char* state_name(State state);

struct RoundPlan {
    State state = State::hot;
    Clock clock = Clock::cpu;
    double budget = 3.0;  // s, about
    int least = 7;
    int most = 101;
    bool any_load = false;  // drop no rounds because other processes run
};

struct Rounds {
    std::vector<std::vector<double>> seconds;  // [subject][round]
    int kept = 0;
    int dropped = 0;  // because other processes used the machine
    int loaded = 0;   // of those kept: no quieter ones came in time
};

/// One call of frames[i](time) is one frame of subject i.
using Frame = std::function<void(double time)>;
Rounds measure(std::span<const Frame> frames, const RoundPlan& plan);

double median(std::vector<double> values);
/// Median over the rounds of subject a / subject b.
double median_ratio(const Rounds& rounds, std::size_t a, std::size_t b);

}  // namespace ocean::bench
