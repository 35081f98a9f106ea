// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Each pass of a frame beside the least time that its bytes take on this machine.
#include <string>
#include <vector>

#include "frame_maps.hpp"
#include "machine_speed.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/page_vector.hpp"
#include "pass_traffic.hpp"
#include "table.hpp"

namespace ocean::bench {

namespace {

/// Describes a frame by what it writes.
struct TrafficFrame {
    const char* name;
    std::vector<MapOutput> outputs;
    SurfaceSettings settings;
    int sources;  // halves of spectra between the passes, for each field that is not made of
                  // another
    int floats;   // of a sample
};

/// Displacement with the Jacobian, normal with the whitecap: four components, eight fields.
std::vector<MapOutput> rgba_outputs(int n, const HugeArray<float>& maps) {
    using enum Channel;
    MapOutput first{maps.data(), 4, {}};
    MapOutput second{
        maps.data() + 4 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 4, {}};
    std::size_t c = 0;
    for (const Channel channel : {dx, dy, height, jacobian}) first.component[c++] = {channel, 1.0f};
    c = 0;
    for (const Channel channel : {nx, ny, nz, whitecap}) second.component[c++] = {channel, 1.0f};
    return {first, second};
}

/// The two passes of one frame in turn, with threads of their own.
class Passes {
  public:
    Passes(const Sea& sea, const TrafficFrame& frame, int threads, SimdLevel level)
        : modes_(sea.modes),
          pool_(threads),
          kernel_(
              pack_modes(map_modes(sea.modes, 0.0, sea.modes.lattice.resolution), pool_, level)),
          scratch_(static_cast<std::size_t>(threads)) {
        frame_.settings = frame.settings;
        frame_.outputs = frame.outputs;
    }

    void one(double time) {
        frame_.tau = modes_.tau(time);
        kernel_.begin(frame_, pool_);
        kernel_.sweep({}, &pool_);
    }
    void two() {
        for (PageVector<float>& floats : scratch_) {
            if (floats.size() < kernel_.scratch_floats()) {
                floats = PageVector<float>(kernel_.scratch_floats());
            }
        }
        const int strips = modes_.lattice.resolution / kernel_.strip_width();
        pool_.for_each_item(strips, [this](int strip, int thread) {
            kernel_.write_strip(strip, scratch_[static_cast<std::size_t>(thread)].data());
        });
    }

  private:
    const Modes& modes_;
    ThreadPool pool_;
    MapKernel kernel_;
    std::vector<PageVector<float>> scratch_;
    KernelFrame frame_;
};

}  // namespace

void traffic_figures(const TableOptions& options, Report& report) {
    for (const int threads : {1, 2}) {
        const MachineSpeed speed = measure_machine(options.level, threads);
        for (const int n : options.sizes) {
            ThreadPool pool;
            const Sea sea(n, pool);
            const VertexMaps vertices(n);
            const auto interleaved = vertices.outputs();
            const std::vector<Linear> fields = fields_of(FrameKind::planar);
            const PlanarMaps planes(n, fields);
            const HugeArray<float> rgba(8 * sea.modes.lattice.size());
            const TrafficFrame frames[] = {
                {"vertices",
                 {interleaved.begin(), interleaved.end()},
                 VertexMaps::settings(),
                 4,
                 6},
                {"planar", planes.outputs(), VertexMaps::settings(), 5, 8},
                {"RGBA", rgba_outputs(n, rgba), sea.parameters.surface, 5, 8}};
            for (const TrafficFrame& frame : frames) {
                Passes passes(sea, frame, threads, options.level);
                passes.one(0.0);
                passes.two();
                const Frame both[] = {[&](double time) { passes.one(time); },
                                      [&](double) { passes.two(); }};
                RoundPlan plan = options.rounds(State::cold, threads);
                plan.budget = options.quick ? 0.3 : 1.5;
                const Rounds rounds = measure(both, plan);
                const PassTraffic traffic = pass_traffic(n, frame.sources, frame.floats);
                report.add(TrafficResult{
                    frame.name,
                    n,
                    threads,
                    std::string(simd_name(options.level)),
                    {1e3 * median(rounds.seconds[0]), 1e3 * median(rounds.seconds[1])},
                    {1e3 * traffic.one / speed.copy, 1e3 * traffic.two / speed.copy}});
            }
        }
    }
}

}  // namespace ocean::bench
