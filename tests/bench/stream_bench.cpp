// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_stream_bench: the time to carve the island of the unit tests, and to set its age; the
// island itself is made before. The greatest distance between two calls of progress is the time
// that a user waits for a cancel.
//   ocean_stream_bench [--benchmark_filter=REGEX] [--benchmark_...]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "ocean/internal/stream_power.hpp"
#include "unit/stream_island.hpp"

namespace ocean::bench {
namespace {

using Clock = std::chrono::steady_clock;

const StreamLevel& level_of(int n) {
    static std::map<int, StreamLevel> levels;
    const auto found = levels.find(n);
    return found != levels.end() ? found->second
                                 : levels.emplace(n, test::StreamIsland().level(n)).first->second;
}

StreamLand carved(int n, ThreadPool& pool, const StreamProgress& progress = {}) {
    return carve(
        StreamSettings(), n, n, test::StreamIsland::kSide / n,
        [](int columns, int, double) { return level_of(columns); }, pool, progress);
}

void carve_island(benchmark::State& state) {
    const auto n = static_cast<int>(state.range(0));
    ThreadPool pool(static_cast<int>(state.range(1)));
    for (int side = n; side >= 64; side /= 2) level_of(side);
    double wait = 0.0;
    for ([[maybe_unused]] const auto iteration : state) {
        Clock::time_point last = Clock::now();
        benchmark::DoNotOptimize(carved(n, pool, [&](double) {
            const Clock::time_point now = Clock::now();
            wait = std::max(wait, std::chrono::duration<double, std::milli>(now - last).count());
            last = now;
        }));
    }
    state.counters["wait_ms"] = wait;
}

void set_age_of_island(benchmark::State& state) {
    const auto n = static_cast<int>(state.range(0));
    ThreadPool pool(static_cast<int>(state.range(1)));
    StreamLand land = carved(n, pool);
    double age = 0.3;
    for ([[maybe_unused]] const auto iteration : state) {
        set_age(land, age, pool);
        age = 1.0 - age;
    }
}

BENCHMARK(carve_island)
    ->ArgsProduct({{512, 1024, 2048, 4096}, {1, 2}})
    ->ArgNames({"side", "threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(set_age_of_island)
    ->ArgsProduct({{512, 1024, 2048}, {1, 2}})
    ->ArgNames({"side", "threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ocean::bench

BENCHMARK_MAIN();
