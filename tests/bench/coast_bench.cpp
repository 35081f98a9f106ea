// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How fast a coast is shaped: an island on cells of 8 m, maps included. Run as
// ocean_coast_bench [--benchmark_...]; `side` and `threads` are in the names.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ocean/coast_profile.hpp"
#include "ocean/land.hpp"

namespace {

void shape_island(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    ocean::ThreadPool pool(static_cast<int>(state.range(1)));
    ocean::Terrain terrain;
    terrain.resolution = 512;
    terrain.patch_size = 8.0 * side;
    terrain.beta = 2.2;
    terrain.outer_scale = 6000.0;
    terrain.rms = 160.0;
    terrain.seed = 3;
    ocean::Land land(terrain);
    const ocean::Surface waves = land.surface({ocean::Channel::height}, side);
    const auto heights = waves.channel(ocean::Channel::height);
    std::vector<float> island(heights.begin(), heights.end());
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const double x = 2.0 * i / side - 1.0, y = 2.0 * j / side - 1.0;
            island[static_cast<std::size_t>(j) * static_cast<std::size_t>(side) +
                   static_cast<std::size_t>(i)] +=
                static_cast<float>(250.0 - 900.0 * (x * x + y * y));
        }
    }
    const ocean::Domain domain{.origin = {},
                               .size = {8.0 * (side - 1), 8.0 * (side - 1)},
                               .samples = {side, side},
                               .wraps = false};
    for (auto _ : state) {
        state.PauseTiming();
        std::vector<float> shaped = island;
        state.ResumeTiming();
        benchmark::DoNotOptimize(ocean::shape_coast(shaped, domain, {}, pool));
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t{side} * side);
}
BENCHMARK(shape_island)
    ->ArgNames({"side", "threads"})
    ->ArgsProduct({{1024, 2048, 4096}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
