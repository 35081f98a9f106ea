// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One of each kind of work on one thread, for callgrind to count: tests/bench/instructions.py. Each
// part of the output is named after what ran since the last; lines on standard output say how many
// lines of memory a frame must read and write.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <string_view>
#include <vector>

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/ocean.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"
#include "pass_traffic.hpp"
#include "waves/kernel/map_kernel.hpp"
#include "waves/kernel/packed_modes.hpp"
#include "waves/modes/mode_lattice.hpp"

namespace {

using namespace ocean;
using enum Channel;

constexpr int kSmall = 256;
/// Beside the small map as large as 512 KiB and 8 MiB are beside one of 1024 x 1024 samples.
constexpr CacheSizes kSmallCaches{std::size_t{32} << 10, std::size_t{512} << 10};
constexpr int kLarge = 512;
constexpr CacheSizes kLargeCaches{std::size_t{2} << 20, std::size_t{32} << 20};
constexpr int kLineBytes = 64;

class Maps {
  public:
    explicit Maps(std::size_t samples) : samples_(samples) {}
    /// A map for all these, interleaved.
    void add(std::initializer_list<Quantity> quantities, float factor = 1.0f) {
        auto& data = data_.emplace_back(samples_ * quantities.size());
        MapOutput output{data.data(), static_cast<int>(quantities.size()), {}};
        std::size_t c = 0;
        for (const Quantity& quantity : quantities) output.component[c++] = {quantity, factor};
        outputs_.push_back(output);
    }
    std::span<const MapOutput> outputs() const { return outputs_; }

  private:
    std::size_t samples_;
    std::vector<PageVector<float>> data_;  // aligned, as fast buffers are
    std::vector<MapOutput> outputs_;
};

/// Counts the second of two calls: the first makes what is made once.
template <typename Body>
void count(const char* name, const Body& body) {
    body();
    CALLGRIND_ZERO_STATS;
    CALLGRIND_TOGGLE_COLLECT;
    body();
    CALLGRIND_TOGGLE_COLLECT;
    CALLGRIND_DUMP_STATS_AT(name);
}

/// The frames of one sea, on one thread.
class Frames {
  public:
    Frames(const Parameters& parameters, const CacheSizes& caches, ThreadPool& pool)
        : pool_(pool),
          modes_(make_modes(make_directional_spectrum(parameters), parameters, pool)),
          kernel_(pack_modes(map_modes(modes_, 0.0, resolution()), pool), caches),
          choppy_(with_threshold(parameters.surface, modes_, resolution())) {}

    int resolution() const { return modes_.lattice.resolution; }
    std::size_t samples() const { return modes_.lattice.size(); }
    SurfaceSettings flat() const {
        SurfaceSettings settings = choppy_;
        settings.choppiness = 0.0;
        return settings;
    }

    void count_frame(const char* name, const Maps& maps, const SurfaceSettings& settings,
                     int sources, const FoamLayer& foam = {}) {
        count(name, [&] {
            kernel_.run({modes_.tau(12.34), settings, maps.outputs(), foam}, pool_);
        });
        int floats = foam.kept != nullptr ? 2 : 0;  // the foam before, and what is kept
        for (const MapOutput& output : maps.outputs()) floats += output.components;
        const bench::PassTraffic traffic = bench::pass_traffic(resolution(), sources, floats);
        std::printf("%s %.0f\n", name, (traffic.one + traffic.two) / kLineBytes);
    }

    /// Counts the frames whose data between the passes is largest.
    void count_flat_frames(const char* vertices_name, const char* planar_name) {
        using enum Linear;
        Maps vertices(samples());
        vertices.add({displacement_x, displacement_y, Linear::height}, -1.0f);
        vertices.add({nx, ny, nz});
        Maps planar(samples());
        for (const Linear field : {Linear::height, displacement_x, displacement_y, Linear::slope_x,
                                   Linear::slope_y, gradient_xx, gradient_yy, gradient_xy}) {
            planar.add({field});
        }
        count_frame(vertices_name, vertices, flat(), 4);
        count_frame(planar_name, planar, flat(), 5);
    }

    void count_choppy_frames() {
        Maps map(samples());
        map.add({dx, dy, Channel::height});
        Maps tick(samples());
        tick.add({foam});
        Maps product(samples());
        product.add({dx, dy, Channel::height});
        product.add({nx, ny, nz});
        product.add({whitecap});
        count_frame("product", product, choppy_, 5);
        count_frame("map", map, choppy_, 3);
        PageVector<float> before(samples(), 0.5f), kept(samples());
        FoamLayer layer{.map = before.data(), .fade = 0.99f, .cutoff = 1.0f / 512.0f};
        layer.kept = kept.data();
        count_frame("tick", tick, choppy_, 3, layer);
    }

  private:
    ThreadPool& pool_;
    Modes modes_;
    MapKernel kernel_;
    SurfaceSettings choppy_;
};

/// Counts the modes of a sea, and a performed change: other waves of the same lattice, packed for
/// the same map.
void count_modes(const Parameters& parameters, ThreadPool& pool) {
    count("rebuild", [&] { make_modes(make_directional_spectrum(parameters), parameters, pool); });
    const ModeLattice lattice(parameters, ModeLattice::Memory::keep, pool);
    Modes live = lattice.still_modes(pool);
    live.lattice_revision = Revision::begin();
    const int resolution = parameters.grid.resolution;
    PackedModes packed(map_modes(live, 0.0, resolution), pool, simd_level());
    Parameters windy = parameters;
    count("change", [&] {
        windy.waves.front().wind_speed = windy.waves.front().wind() + 0.1;
        lattice.set_waves(make_directional_spectrum(windy, pool), windy.waves.front().wind(), pool,
                          live);
        packed.refill(map_modes(live, 0.0, resolution), pool);
    });
}

/// Counts a map of a sea whose wind glides, between two steps of it.
void count_passage(const Parameters& parameters) {
    Sea sea{parameters};
    sea.parameters.waves.front().wind_speed = 10.0;
    sea.take.events = {{0.0, find_parameter("wind_speed"), 10.1}};
    Ocean ocean(std::move(sea), {.threads = 1});
    Maps map(parameters.grid.resolution * static_cast<std::size_t>(parameters.grid.resolution));
    map.add({dx, dy, Channel::height});
    double time = 0.0;
    count("passage", [&] { ocean.evaluate_into(time += 1.0 / 60.0, map.outputs()); });
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view argument = argc == 2 ? argv[1] : "";
    if (argument == "--build") {
        std::puts(OCEAN_BENCH_BUILD);
        return 0;
    }
    ThreadPool pool(1);
    Parameters parameters;
    if (argument == "large") {
        parameters.grid.resolution = kLarge;
        Frames(parameters, kLargeCaches, pool).count_flat_frames("vertices_512", "planar_512");
        return 0;
    }
    parameters.grid.resolution = kSmall;
    count_modes(parameters, pool);
    Frames frames(parameters, kSmallCaches, pool);
    frames.count_flat_frames("vertices", "planar");
    frames.count_choppy_frames();
    count_passage(parameters);
}
