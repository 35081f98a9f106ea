// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The measuring loop.
#include "measure.hpp"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <random>
#include <string>
#include <utility>

namespace ocean::bench {

namespace {

constexpr double kStart = 12.34;  // s
constexpr double kStep = 0.04;
constexpr int kWarm = 3;

double read_clock(clockid_t id) {
    timespec now{};
    clock_gettime(id, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds that all processors together were busy since the machine's start, what the host took
/// from a virtual machine included. Counted in ticks of 10 ms. 0 where there is no /proc.
double machine_busy() {
    std::ifstream stat("/proc/stat");
    std::string cpu;
    double user = 0, nice = 0, system = 0, idle = 0, wait = 0, irq = 0, soft = 0, steal = 0;
    stat >> cpu >> user >> nice >> system >> idle >> wait >> irq >> soft >> steal;
    return (user + nice + system + irq + soft + steal) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Processors that others kept busy since the object was made.
class ForeignLoad {
  public:
    double elapsed() const { return seconds(Clock::wall) - wall_; }
    double processors() const {
        return (machine_busy() - busy_ - (seconds(Clock::cpu) - own_)) / elapsed();
    }

  private:
    double busy_ = machine_busy();
    double own_ = seconds(Clock::cpu);
    double wall_ = seconds(Clock::wall);
};

void one_round(std::span<const Frame> frames, const RoundPlan& plan, int round, Rounds& rounds) {
    const double time = kStart + kStep * round;
    std::vector<std::size_t> order(frames.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Nobody always comes after the same subject.
    std::shuffle(order.begin(), order.end(), std::minstd_rand(static_cast<unsigned>(round + 1)));
    for (const std::size_t subject : order) {
        if (plan.state == State::hot) {
            for (int warm = kWarm; warm > 0; --warm) frames[subject](time - 0.01 * warm);
        }
        const double before = seconds(plan.clock);
        frames[subject](time);
        rounds.seconds[subject].push_back(seconds(plan.clock) - before);
    }
}

}  // namespace

double seconds(Clock clock) {
    return read_clock(clock == Clock::cpu ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC);
}

const char* state_name(State state) {
    return state == State::hot ? "hot" : "cold";
}

namespace {

/// Rounds in a row with the load that they had. A tick of /proc/stat is 10 ms: 0.2 s are enough to
/// tell.
struct Batch {
    static constexpr double kSeconds = 0.2;

    int first;
    int count;
    double load;  // processors

    bool quiet() const { return load <= 0.1; }
};

/// All batches that are quiet; where those are too few, the least loaded quarter of all.
Rounds choose(std::vector<Batch> batches, const Rounds& all, const RoundPlan& plan) {
    std::sort(batches.begin(), batches.end(),
              [](const Batch& a, const Batch& b) { return a.load < b.load; });
    int total = 0;
    for (const Batch& batch : batches) total += batch.count;
    const int needed = std::max(plan.least, total / 4);
    Rounds chosen;
    chosen.seconds.resize(all.seconds.size());
    for (const Batch& batch : batches) {
        const bool quiet = plan.any_load || batch.quiet();
        if (!quiet && chosen.kept >= needed) {
            chosen.dropped += batch.count;
            continue;
        }
        chosen.kept += batch.count;
        if (!quiet) chosen.loaded += batch.count;
        for (std::size_t i = 0; i < all.seconds.size(); ++i) {
            const auto first = all.seconds[i].begin() + batch.first;
            chosen.seconds[i].insert(chosen.seconds[i].end(), first, first + batch.count);
        }
    }
    return chosen;
}

}  // namespace

Rounds measure(std::span<const Frame> frames, const RoundPlan& plan) {
    Rounds all;
    all.seconds.resize(frames.size());
    std::vector<Batch> batches;
    int quiet = 0;  // rounds
    int rounds = 0;
    const double start = seconds(Clock::wall);
    const auto finished = [&] {
        const double elapsed = seconds(Clock::wall) - start;
        if (quiet >= plan.most) return true;
        // Quiet rounds are waited for, but not for ever.
        return elapsed > (quiet >= plan.least ? 1.0 : 4.0) * plan.budget && rounds >= plan.least;
    };
    for (const Frame& frame : frames) frame(kStart);
    while (!finished()) {
        const ForeignLoad load;
        Batch batch{rounds, 0, 0.0};
        do {
            one_round(frames, plan, rounds, all);
            ++rounds;
        } while (load.elapsed() < Batch::kSeconds);
        batch.count = rounds - batch.first;
        batch.load = load.processors();
        if (plan.any_load || batch.quiet()) quiet += batch.count;
        batches.push_back(batch);
    }
    return choose(std::move(batches), all, plan);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double median_ratio(const Rounds& rounds, std::size_t a, std::size_t b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < rounds.seconds[a].size(); ++i) {
        ratios.push_back(rounds.seconds[a][i] / rounds.seconds[b][i]);
    }
    return median(std::move(ratios));
}

}  // namespace ocean::bench
