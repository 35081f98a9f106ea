// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How fast a coast is shaped: an island on cells of 8 m, maps included; and how fast the sea over a
// bed is shown. Run as ocean_coast_bench [--benchmark_...]; `side` and `threads` are in the names.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "ocean/internal/modes.hpp"
#include "ocean/internal/shoreline_profile.hpp"
#include "ocean/ocean.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/terrain.hpp"

namespace {

void shape_island(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    ocean::ThreadPool pool(static_cast<int>(state.range(1)));
    ocean::TerrainModel terrain;
    terrain.resolution = 512;
    terrain.patch_size = 8.0 * side;
    terrain.beta = 2.2;
    terrain.outer_scale = 6000.0;
    terrain.rms = 160.0;
    terrain.seed = 3;
    ocean::Terrain land(terrain);
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
        benchmark::DoNotOptimize(ocean::shape_shoreline(shaped, domain, {}, pool));
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t{side} * side);
}
BENCHMARK(shape_island)
    ->ArgNames({"side", "threads"})
    ->ArgsProduct({{1024, 2048, 4096}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Waves of 12 m/s over 150 km on 4 km2 of a wavy beach that rises 1:40 to the east: still water
/// ends at x = 1500 m.
ocean::Parameters sea_over_bed() {
    ocean::Parameters sea;
    sea.grid.resolution = 512;
    sea.grid.patch_size = 1024.0;
    ocean::WaveSystem& waves = sea.waves.front();
    waves.spectrum = ocean::SpectrumKind::jonswap;
    waves.wind_speed = 12.0;
    waves.fetch = 150000.0;
    sea.water.depth = 40.0;
    ocean::GivenBed bed;
    bed.grid = {{0.0, 0.0}, {2000.0, 2000.0}, {501, 501}, false};
    for (int j = 0; j < 501; ++j) {
        for (int i = 0; i < 501; ++i) {
            const double wave = 2.0 * std::sin(0.05 * i) * std::cos(0.04 * j);
            bed.heights.push_back(static_cast<float>((4.0 * i - 1500.0) / 40.0 + wave));
        }
    }
    sea.water.bed = ocean::make_sea_bed(std::move(bed), sea.water);
    return sea;
}

enum RegionKind { position, normals, velocity, foam };

ocean::ChannelSet channels_of(RegionKind kind) {
    using ocean::Channel;
    switch (kind) {
        case position:
            return {Channel::dx, Channel::dy, Channel::height};
        case normals:
            return {Channel::dx, Channel::dy, Channel::height,
                    Channel::nx, Channel::ny, Channel::nz};
        case velocity:
            return {Channel::dx, Channel::dy, Channel::height,
                    Channel::vx, Channel::vy, Channel::vz};
        case foam:
            return Channel::foam;
    }
    return {};
}

/// Shows frames of side x side labels at 1 m, from 12 m of depth into the surf. A side of 2
/// measures what a frame costs beside its labels.
void show_region(benchmark::State& state, RegionKind kind) {
    const int side = static_cast<int>(state.range(0));
    ocean::Ocean ocean(sea_over_bed(), {.threads = static_cast<int>(state.range(1))});
    const double size = side - 1.0;
    const ocean::Domain domain{{1000.0, 300.0}, {size, size}, {side, side}, false};
    double time = 3.0;
    ocean.region(time, domain, channels_of(kind));  // statics, and the foam of the past
    for (auto _ : state) {
        time += 0.04;
        benchmark::DoNotOptimize(ocean.region(time, domain, channels_of(kind)));
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t{side} * side);
}
void show_region_options(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"side", "threads"})
        ->ArgsProduct({{2, 500}, {1, 2}})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}
BENCHMARK_CAPTURE(show_region, position, position)->Apply(show_region_options);
BENCHMARK_CAPTURE(show_region, normals, normals)->Apply(show_region_options);
BENCHMARK_CAPTURE(show_region, velocity, velocity)->Apply(show_region_options);
BENCHMARK_CAPTURE(show_region, foam, foam)->Apply(show_region_options);

/// Computes where the waves go over the 4 km2 of the bed: delays and energy.
void make_statics(benchmark::State& state) {
    const ocean::Parameters sea = sea_over_bed();
    for (auto _ : state) {
        state.PauseTiming();
        ocean::Ocean ocean(sea, {.threads = static_cast<int>(state.range(0))});
        ocean.modes();
        state.ResumeTiming();
        ocean.prepare_coast();
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(sea.water.bed->domain.count()));
}
BENCHMARK(make_statics)
    ->ArgName("threads")
    ->DenseRange(1, 2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Shows the first frame with foam, which follows the past of the foam, statics apart.
void show_first_foam(benchmark::State& state) {
    const ocean::Domain domain{{1000.0, 300.0}, {499.0, 499.0}, {500, 500}, false};
    for (auto _ : state) {
        state.PauseTiming();
        ocean::Ocean ocean(sea_over_bed(), {.threads = static_cast<int>(state.range(0))});
        ocean.prepare_coast();
        state.ResumeTiming();
        benchmark::DoNotOptimize(ocean.region(3.0, domain, ocean::Channel::foam));
    }
}
BENCHMARK(show_first_foam)
    ->ArgName("threads")
    ->DenseRange(1, 2)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
