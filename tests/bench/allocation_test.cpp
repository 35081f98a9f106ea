// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A frame allocates nothing. This program has the C library's allocation functions pass through
// counters, operator new among them, so that whatever a frame asks for is seen.
#include <atomic>
#include <cstddef>

#include "ocean/internal/cascade_map.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/ocean.hpp"
#include "ocean/thread_pool.hpp"
#include "testing.hpp"
#include "waves/kernel/map_kernel.hpp"
#include "waves/surface/map_writer.hpp"

// The sanitizers have these functions for themselves; other C libraries name theirs otherwise.
#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define OCEAN_COUNTS_ALLOCATIONS 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define OCEAN_COUNTS_ALLOCATIONS 0
#endif
#endif
#ifndef OCEAN_COUNTS_ALLOCATIONS
#define OCEAN_COUNTS_ALLOCATIONS 1
#endif

namespace {

std::atomic<long> allocations = 0;

}  // namespace

#if OCEAN_COUNTS_ALLOCATIONS
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
    ++allocations;
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
    ++allocations;
    return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
    ++allocations;
    return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
    ++allocations;
    return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    ++allocations;
    *memory = __libc_memalign(alignment, size);
    return *memory == nullptr ? 12 : 0;  // ENOMEM
}

}  // extern "C"
#endif

namespace ocean {
namespace {

constexpr int kResolution = 256;

MapOutput output(std::vector<float>& data, std::initializer_list<Channel> channels) {
    MapOutput result;
    result.data = data.data();
    result.components = static_cast<int>(channels.size());
    std::size_t c = 0;
    for (const Channel channel : channels) result.component[c++].quantity = channel;
    return result;
}

/// Allocations of the frames after the first of each kind, which may make the arrays in between.
long allocations_of_frames(int threads) {
    using enum Channel;
    Parameters parameters;
    parameters.grid.resolution = kResolution;
    ThreadPool pool(threads);
    const Modes modes = make_modes(make_directional_spectrum(parameters), parameters, pool);
    const SurfaceSettings settings = with_threshold(parameters.surface, modes, kResolution);
    MapKernel kernel(pack_modes(map_modes(modes, 0.0, kResolution), pool));

    const std::size_t size = modes.lattice.size();
    std::vector<float> displacement(3 * size), normal(3 * size), whitecaps(size), foams(size);
    const MapOutput product[] = {output(displacement, {dx, dy, height}),
                                 output(normal, {nx, ny, nz}), output(whitecaps, {whitecap})};
    const MapOutput tick[] = {output(foams, {foam})};
    const auto frames = [&](double time) {
        kernel.run({modes.tau(time), settings, product, {}}, pool);
        kernel.run({modes.tau(time), settings, tick, {foams.data(), 0.98f, 1.0f / 512.0f}}, pool);
    };
    frames(0.0);
    const long before = allocations;
    for (int frame = 1; frame <= 5; ++frame) frames(0.04 * frame);
    return allocations - before;
}

/// The same of a cascade's small map, which real-time hosts draw.
long allocations_of_cascade_maps(int threads) {
    Parameters parameters;
    parameters.grid = {128, 500.0, 2, {}};
    Ocean sea(parameters, {.threads = threads});
    ThreadPool pool(threads);
    CascadeMap map(1, kResolution);
    const auto frame = [&](double time) {
        map.planes(sea.modes(), time, fields_of({Channel::dx, Channel::dy, Channel::nz}), pool);
    };
    frame(0.0);
    const long before = allocations;
    for (int i = 1; i <= 5; ++i) frame(0.04 * i);
    return allocations - before;
}

/// And of maps with a channel of the host's among them.
long allocations_of_further_channels(int threads) {
    static constexpr ChannelInfo kFurther[] = {
        {"steepness", "", {Linear::slope_x}, {Linear::slope_x}, [](const auto& point) {
             return point[Linear::slope_x] * point[Linear::slope_x];
         }}};
    Parameters parameters;
    parameters.grid.resolution = kResolution;
    Ocean sea(parameters, {.threads = threads});
    ThreadPool pool(threads);
    MapWriter writer(Backend::cpu, kFurther);
    const Modes& modes = sea.modes();
    const SurfaceSettings settings = with_threshold(parameters.surface, modes, kResolution);
    std::vector<float> displacement(3 * modes.lattice.size()), steepness(2 * modes.lattice.size());
    const MapOutput outputs[] = {
        output(displacement, {Channel::dx, Channel::dy, Channel::height}),
        output(steepness, {static_cast<Channel>(kChannelCount), Channel::whitecap})};
    const auto frame = [&](double time) {
        writer.write({map_modes(modes, time, kResolution), settings, outputs, {}}, pool);
    };
    frame(0.0);
    const long before = allocations;
    for (int i = 1; i <= 5; ++i) frame(0.04 * i);
    return allocations - before;
}

TEST(Allocations, AreCounted) {
    if (!OCEAN_COUNTS_ALLOCATIONS) GTEST_SKIP() << "not with this C library or sanitizer";
    const long before = allocations;
    std::vector<float> some(1000);
    some.data()[0] = 1.0f;
    // The optimiser may not leave it out: its address escapes.
    asm volatile("" : : "r"(some.data()) : "memory");
    EXPECT_EQ(allocations - before, 1);
}

TEST(Allocations, AFrameMakesNoneOnOneThreadOrTwo) {
    if (!OCEAN_COUNTS_ALLOCATIONS) GTEST_SKIP() << "not with this C library or sanitizer";
    EXPECT_EQ(allocations_of_frames(1), 0);
    EXPECT_EQ(allocations_of_frames(2), 0);
    EXPECT_EQ(allocations_of_cascade_maps(1), 0);
    EXPECT_EQ(allocations_of_cascade_maps(2), 0);
    EXPECT_EQ(allocations_of_further_channels(1), 0);
    EXPECT_EQ(allocations_of_further_channels(2), 0);
}

}  // namespace
}  // namespace ocean
