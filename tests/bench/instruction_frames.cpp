// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One of each kind of work on one thread, for callgrind to count: tests/bench/instructions.py. Each
// part of the output is named after what ran since the last; lines on standard output say how many
// lines of memory a frame must read and write.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstring>
#include <vector>

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"
#include "pass_traffic.hpp"
#include "waves/kernel/map_kernel.hpp"
#include "waves/kernel/packed_modes.hpp"
#include "waves/modes/mode_lattice.hpp"

namespace {

using namespace ocean;
using enum Channel;

constexpr int kResolution = 256;
/// Beside this map as large as 512 KiB and 8 MiB are beside one of 1024 x 1024 samples.
constexpr CacheSizes kCaches{std::size_t{32} << 10, std::size_t{512} << 10};
constexpr int kLineBytes = 64;

class Maps {
  public:
    /// A map for all these, interleaved.
    void add(std::initializer_list<Quantity> quantities, float factor = 1.0f) {
        auto& data = data_.emplace_back(std::size_t{kResolution} * kResolution * quantities.size());
        MapOutput output{data.data(), static_cast<int>(quantities.size()), {}};
        std::size_t c = 0;
        for (const Quantity& quantity : quantities) output.component[c++] = {quantity, factor};
        outputs_.push_back(output);
    }
    std::span<const MapOutput> outputs() const { return outputs_; }

  private:
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

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "--build") == 0) {
        std::puts(OCEAN_BENCH_BUILD);
        return 0;
    }
    Parameters parameters;
    parameters.grid.resolution = kResolution;
    ThreadPool pool(1);
    Modes modes;
    count("rebuild",
          [&] { modes = make_modes(make_directional_spectrum(parameters), parameters, pool); });

    // A performed change: other waves of the same lattice, packed for the same map.
    const ModeLattice lattice(parameters, ModeLattice::Memory::keep, pool);
    Modes live = lattice.still_modes(pool);
    live.lattice_revision = Revision::begin();
    PackedModes packed(map_modes(live, 0.0, kResolution), pool, simd_level());
    Parameters windy = parameters;
    count("change", [&] {
        windy.waves.front().wind_speed = windy.waves.front().wind() + 0.1;
        lattice.set_waves(make_directional_spectrum(windy, pool), windy.waves.front().wind(), pool,
                          live);
        packed.refill(map_modes(live, 0.0, kResolution), pool);
    });

    using enum Linear;
    const std::vector<Linear> fields = {Linear::height,  displacement_x,  displacement_y,
                                        Linear::slope_x, Linear::slope_y, gradient_xx,
                                        gradient_yy,     gradient_xy};
    MapKernel kernel(pack_modes(map_modes(modes, 0.0, kResolution), pool), kCaches);
    const SurfaceSettings choppy = with_threshold(parameters.surface, modes, kResolution);
    SurfaceSettings flat = choppy;
    flat.choppiness = 0.0;

    Maps vertices;
    vertices.add({displacement_x, displacement_y, Linear::height}, -1.0f);
    vertices.add({nx, ny, nz});
    Maps planar;
    for (const Linear field : fields) planar.add({field});
    Maps map;
    map.add({dx, dy, Channel::height});
    Maps tick;
    tick.add({foam});
    PageVector<float> before(modes.lattice.size(), 0.5f), kept(modes.lattice.size());
    Maps product;
    product.add({dx, dy, Channel::height});
    product.add({nx, ny, nz});
    product.add({whitecap});
    const auto frame = [&](const char* name, const Maps& maps, const SurfaceSettings& settings,
                           int sources, const FoamLayer& foam = {}) {
        count(name, [&] { kernel.run({modes.tau(12.34), settings, maps.outputs(), foam}, pool); });
        int floats = foam.kept != nullptr ? 2 : 0;  // the foam before, and what is kept
        for (const MapOutput& output : maps.outputs()) floats += output.components;
        const bench::PassTraffic traffic = bench::pass_traffic(kResolution, sources, floats);
        std::printf("%s %.0f\n", name, (traffic.one + traffic.two) / kLineBytes);
    };
    frame("vertices", vertices, flat, 4);
    frame("planar", planar, flat, 5);
    frame("product", product, choppy, 5);
    frame("map", map, choppy, 3);
    FoamLayer layer{.map = before.data(), .fade = 0.99f, .cutoff = 1.0f / 512.0f};
    layer.kept = kept.data();
    frame("tick", tick, choppy, 3, layer);
}
