// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the speeds of memory and multipliers.
#include "machine_speed.hpp"

#include <omp.h>

#include <algorithm>
#include <vector>

#include "huge_array.hpp"
#include "measure.hpp"

namespace ocean::bench {

MachineSpeed measure_machine(SimdLevel level, int threads) {
    constexpr std::size_t kFloats = std::size_t{1} << 26;  // 256 MB
    constexpr std::size_t kChains = std::size_t{1} << 22;
    const MachineLoops& loops = machine_loops(level);
    const HugeArray<float> from(kFloats);
    const HugeArray<float> to(kFloats);
    // Not zeros: there are processors that store those three times as fast.
    for (std::size_t i = 0; i < kFloats; ++i) from[i] = to[i] = static_cast<float>(i % 1009 + 1);

    const std::size_t share = kFloats / static_cast<std::size_t>(threads);
    std::vector<float> results(static_cast<std::size_t>(threads));  // or nothing would be computed
    const auto on_each_thread = [&](const auto& body) -> Frame {
        return [&results, share, threads, body](double) {
#pragma omp parallel num_threads(threads)
            {
                const auto thread = static_cast<std::size_t>(omp_get_thread_num());
                results[thread] = body(share * thread);
            }
        };
    };
    const Frame frames[] = {
        on_each_thread([&](std::size_t first) {
            loops.copy(from.data() + first, to.data() + first, share);
            return 0.0f;
        }),
        on_each_thread([&](std::size_t first) {
            loops.fill(to.data() + first, share);
            return 0.0f;
        }),
        on_each_thread([&](std::size_t first) { return loops.sum(from.data() + first, share); }),
        on_each_thread([&](std::size_t) { return loops.fma(kChains); })};
    RoundPlan plan;
    plan.state = State::cold;
    plan.clock = Clock::wall;
    plan.budget = 1.0;
    const Rounds rounds = measure(frames, plan);
    const auto best = [&](std::size_t i) {
        return *std::min_element(rounds.seconds[i].begin(), rounds.seconds[i].end());
    };
    constexpr double kBytes = sizeof(float) * static_cast<double>(kFloats);
    return {2.0 * kBytes / best(0), kBytes / best(1), kBytes / best(2),
            threads * loops.fma_flops * static_cast<double>(kChains) / best(3)};
}

}  // namespace ocean::bench
