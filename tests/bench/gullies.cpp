// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the gullies of a point cost on one thread, by octaves and masks. The base is given.
// OCEAN_SIMD chooses the instruction set. usage: ocean_gullies_bench [--benchmark_...]
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "ocean/internal/gullies.hpp"

namespace {

constexpr std::size_t kSide = 256;

/// A chunk of land, 10 m between its points, on a smooth base.
struct Chunk {
    std::vector<double> x, y;
    std::vector<float> height, slope_x, slope_y, wear, gully, ridge;

    Chunk() {
        for (std::size_t p = 0; p < kSide * kSide; ++p) {
            x.push_back(412000.0 + 10.0 * static_cast<double>(p % kSide));
            y.push_back(-93000.0 + 10.0 * static_cast<double>(p / kSide));
            height.push_back(0.0f);
            slope_x.push_back(static_cast<float>(0.3 * std::sin(1e-3 * x[p])));
            slope_y.push_back(static_cast<float>(0.3 * std::cos(1e-3 * y[p])));
        }
        wear = gully = ridge = height;
    }
};

/// Counts points as items. Each round begins with the same base.
void gullies(benchmark::State& state) {
    const ocean::GullyFilter filter({.octaves = static_cast<int>(state.range(0))});
    const bool masks = state.range(1) != 0;
    const Chunk before;
    Chunk chunk;
    for (auto _ : state) {
        state.PauseTiming();
        chunk = before;
        state.ResumeTiming();
        ocean::GullyPoints points{chunk.x,       chunk.y, chunk.height, chunk.slope_x,
                                  chunk.slope_y, {},      {},           {}};
        if (masks) {
            points.wear = chunk.wear;
            points.gully = chunk.gully;
            points.ridge = chunk.ridge;
        }
        filter.apply(points, 0.0);
        benchmark::DoNotOptimize(chunk.height.data());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSide * kSide));
}
BENCHMARK(gullies)->ArgNames({"octaves", "masks"})->Args({6, 0})->Args({6, 1})->Args({1, 1});

}  // namespace

BENCHMARK_MAIN();
