// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Figures of our own kernel: against the machine, through the C API, beside other work, and of
// frames that no rival makes.
#include <benchmark/benchmark.h>
#include <libocean.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <cstring>
#include <limits>
#include <string>

#include "frame_maps.hpp"
#include "machine_speed.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/ocean.hpp"
#include "subject_ours.hpp"
#include "table.hpp"

namespace ocean::bench {

namespace {

std::string simd_text(const TableOptions& options) {
    return std::string(simd_name(options.level));
}

/// Displacement and normal, three components each, as the C API gives them.
std::vector<MapOutput> product_outputs(const HugeArray<float>& displacement,
                                       const HugeArray<float>& normal) {
    MapOutput first{displacement.data(), 3, {}};
    first.component[0].quantity = Channel::dx;
    first.component[1].quantity = Channel::dy;
    first.component[2].quantity = Channel::height;
    MapOutput second{normal.data(), 3, {}};
    second.component[0].quantity = Channel::nx;
    second.component[1].quantity = Channel::ny;
    second.component[2].quantity = Channel::nz;
    return {first, second};
}

MapOutput plane_output(const HugeArray<float>& plane, Channel channel) {
    MapOutput output{plane.data(), 1, {}};
    output.component[0].quantity = channel;
    return output;
}

/// A child that does nothing but use a processor.
class Spinner {
  public:
    Spinner() : child_(fork()) {
        if (child_ != 0) return;
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (;;) asm volatile("");
    }
    ~Spinner() {
        if (child_ < 0) return;
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
    }
    Spinner(const Spinner&) = delete;
    Spinner& operator=(const Spinner&) = delete;
    bool runs() const { return child_ > 0; }

  private:
    pid_t child_;
};

void require_ok(ocean_result result) {
    if (result != OCEAN_OK) throw Error(ErrorKind::invalid_value, ocean_last_error());
}

/// A sea behind the C API, with maps like those of product_outputs.
class CApiFrame {
  public:
    CApiFrame(const Sea& sea, int threads)
        : displacement(3 * sea.modes.lattice.size()), normal(3 * sea.modes.lattice.size()) {
        const std::string text =
            "libocean = 1\n[grid]\nresolution = " + std::to_string(sea.modes.lattice.resolution) +
            "\npatch_size = " + std::to_string(sea.modes.lattice.period) +
            "\n[water]\ndepth = 200.0\nsurface_tension = 0.0\n";
        ocean_options options{};
        options.struct_size = sizeof(options);
        options.threads = threads;
        require_ok(ocean_parse(text.data(), text.size(), nullptr, &options, &sea_));
        const std::size_t count = 3 * sea.modes.lattice.size();
        outputs_[0] = vector_output(displacement.data(), count, OCEAN_DX);
        outputs_[1] = vector_output(normal.data(), count, OCEAN_NX);
    }
    ~CApiFrame() { ocean_free(sea_); }
    CApiFrame(const CApiFrame&) = delete;
    CApiFrame& operator=(const CApiFrame&) = delete;

    static ocean_output vector_output(float* data, std::size_t count, std::int32_t first) {
        ocean_output output{};
        output.data = data;
        output.count = count;
        output.channels = 3;
        for (std::int32_t c = 0; c < 3; ++c) output.channel[c] = first + c;
        return output;
    }

    void run(double time) const {
        ocean_request request{};
        request.struct_size = sizeof(request);
        request.time = time;
        request.outputs = outputs_;
        request.output_count = 2;
        require_ok(ocean_evaluate(sea_, &request));
    }

    HugeArray<float> displacement, normal;

  private:
    ocean_sea* sea_ = nullptr;
    ocean_output outputs_[2] = {};
};

/// Reads every number of a map once, as a caller does that copies it on.
void read_back(const HugeArray<float>& map, std::size_t count) {
    std::uint32_t sum = 0;  // of integers, whose order the compiler may change
    for (std::size_t i = 0; i < count; ++i) sum += std::bit_cast<std::uint32_t>(map.data()[i]);
    benchmark::DoNotOptimize(sum);
}

/// The frame of vertices alone, in milliseconds; ours has no rivals here.
Rounds measure_vertices(const Sea& sea, int threads, const TableOptions& options) {
    OurFrame frame(sea, threads, options.level);
    const VertexMaps maps(sea.modes.lattice.resolution);
    const auto outputs = maps.outputs();
    frame.show({outputs.begin(), outputs.end()}, VertexMaps::settings());
    const Frame frames[] = {[&](double time) { frame.run(time); }};
    return measure(frames, options.rounds(State::hot, threads));
}

}  // namespace

void machine_figures(const TableOptions& options, Report& report) {
    const std::string simd = simd_text(options);
    for (const int threads : {1, 2}) {
        const MachineSpeed speed = measure_machine(options.level, threads);
        report.figure("copy, non-temporal, read and written", simd, threads, 1e-9 * speed.copy,
                      "GB/s");
        report.figure("store, non-temporal", simd, threads, 1e-9 * speed.write, "GB/s");
        report.figure("read", simd, threads, 1e-9 * speed.read, "GB/s");
        report.figure("multiply and add", simd, threads, 1e-9 * speed.fma, "GFLOP/s");
    }
}

bool c_api_figures(int n, const TableOptions& options, Report& report) {
    ThreadPool pool;
    const Sea sea(n, pool);
    bool same = true;
    for (const int threads : {1, 2}) {
        const HugeArray<float> displacement(3 * sea.modes.lattice.size());
        const HugeArray<float> normal(3 * sea.modes.lattice.size());
        OurFrame kernel(sea, threads, simd_level());
        kernel.show(product_outputs(displacement, normal), sea.parameters.surface);
        const CApiFrame c_api(sea, threads);
        const Frame frames[] = {[&](double time) { c_api.run(time); },
                                [&](double time) { kernel.run(time); }};
        const Rounds rounds = measure(frames, options.rounds(State::hot, threads));
        report.figure("ocean_evaluate / kernel, N = " + std::to_string(n),
                      std::string(simd_name(simd_level())), threads, median_ratio(rounds, 0, 1),
                      "");
        for (const Frame& frame : frames) frame(1.0);
        const auto same_bits = [&](const HugeArray<float>& a, const HugeArray<float>& b,
                                   const char* name) {
            if (std::memcmp(a.data(), b.data(), 3 * sizeof(float) * sea.modes.lattice.size()) ==
                0) {
                return true;
            }
            std::fprintf(stderr, "WRONG: ocean_evaluate and the kernel differ in the %s\n", name);
            return false;
        };
        same &= same_bits(displacement, c_api.displacement, "displacement");
        same &= same_bits(normal, c_api.normal, "normal");
    }
    return same;
}

void read_back_figures(int n, const TableOptions& options, Report& report) {
    ThreadPool pool;
    const Sea sea(n, pool);
    const std::size_t count = 3 * sea.modes.lattice.size();
    const HugeArray<float> displacement(count), normal(count);
    const CacheSizes here = cache_sizes();
    CacheSizes endless = here, none = here;
    endless.shared = std::numeric_limits<std::size_t>::max();
    none.shared = 0;
    std::vector<std::unique_ptr<OurFrame>> kernels;
    for (const CacheSizes& caches : {here, endless, none}) {
        kernels.push_back(std::make_unique<OurFrame>(sea, 1, options.level, caches));
        kernels.back()->show(product_outputs(displacement, normal), sea.parameters.surface);
    }
    std::vector<Frame> frames = {[&](double time) { kernels.front()->run(time); }};
    for (const auto& kernel : kernels) {
        frames.push_back([&, frame = kernel.get()](double time) {
            frame->run(time);
            read_back(displacement, count);
            read_back(normal, count);
        });
    }
    const Rounds rounds = measure(frames, options.rounds(State::hot, 1));
    const auto figure = [&](const std::string& what, std::size_t a, std::size_t b) {
        report.figure(what + ", N = " + std::to_string(n), simd_text(options), 1,
                      median_ratio(rounds, a, b), "");
    };
    figure("displacement and normal, then read / not read", 1, 0);
    figure("through the caches / as chosen, both then read", 2, 1);
    figure("past the caches / as chosen, both then read", 3, 1);
}

void busy_figures(int n, const TableOptions& options, Report& report) {
    ThreadPool pool;
    const Sea sea(n, pool);
    const VertexMaps maps(n);
    const auto outputs = maps.outputs();
    OurFrame one(sea, 1, options.level);
    OurFrame two(sea, 2, options.level);
    for (OurFrame* frame : {&one, &two}) {
        frame->show({outputs.begin(), outputs.end()}, VertexMaps::settings());
    }
    const Frame frames[] = {[&](double time) { two.run(time); },
                            [&](double time) { one.run(time); }};
    RoundPlan plan = options.rounds(State::hot, 2);
    const Rounds quiet = measure(frames, plan);
    report.figure("time of 2 threads / of 1, N = " + std::to_string(n), simd_text(options), 2,
                  median_ratio(quiet, 0, 1), "");
    plan.any_load = true;
    const Spinner spinner;
    if (!spinner.runs()) return;
    const Rounds busy = measure(frames, plan);
    report.figure("time of 2 threads / of 1 beside a busy process, N = " + std::to_string(n),
                  simd_text(options), 2, median_ratio(busy, 0, 1), "");
}

void rebuild_figures(int n, const TableOptions& options, Report& report) {
    constexpr int kThreads = 2;
    ThreadPool pool;
    const Sea sea(n, pool);
    const double frame = median(measure_vertices(sea, kThreads, options).seconds[0]);
    OceanOptions ocean_options;
    ocean_options.threads = kThreads;
    Ocean ocean(sea.parameters, ocean_options);
    ocean.modes();
    int moves = 0;
    const Frame frames[] = {[&](double) {
        ocean.set("wind_speed", ++moves % 2 == 0 ? "10" : "11");
        ocean.modes();
    }};
    RoundPlan plan = options.rounds(State::hot, kThreads);
    plan.most = 9;
    const int runs_before = ocean.stage_runs().modes;
    const double rebuild = median(measure(frames, plan).seconds[0]);
    if (ocean.stage_runs().modes - runs_before != moves) {
        throw Error(ErrorKind::invalid_value, "a moved wind_speed did not rebuild the modes");
    }
    const MapModes request = map_modes(sea.modes, 0.0, n);
    ThreadPool pack_pool(kThreads);
    const Frame packs[] = {[&](double) { pack_modes(request, pack_pool, options.level); }};
    const double packing = median(measure(packs, plan).seconds[0]);
    const std::string name = ", N = " + std::to_string(n);
    report.figure("packing of modes" + name, simd_text(options), kThreads, 1e3 * packing, "ms");
    report.figure("rebuild of spectrum and modes" + name, simd_text(options), kThreads,
                  1e3 * rebuild, "ms");
    report.figure("rebuild / frame" + name, simd_text(options), kThreads, rebuild / frame, "");
}

void product_figures(int n, const TableOptions& options, Report& report) {
    ThreadPool pool;
    const Sea sea(n, pool);
    const SurfaceSettings settings = with_threshold(sea.parameters.surface, sea.modes, n);
    const std::size_t size = sea.modes.lattice.size();
    const HugeArray<float> displacement(3 * size);
    const HugeArray<float> normal(3 * size);
    const HugeArray<float> whitecap(size);
    const HugeArray<float> foam(size);
    for (const int threads : {1, 2}) {
        OurFrame product(sea, threads, options.level);
        std::vector<MapOutput> outputs = product_outputs(displacement, normal);
        outputs.push_back(plane_output(whitecap, Channel::whitecap));
        product.show(outputs, settings);
        OurFrame tick(sea, threads, options.level);
        tick.show({plane_output(foam, Channel::foam)}, settings,
                  {foam.data(), 0.9876f, 1.0f / 512.0f});
        const Frame frames[] = {[&](double time) { product.run(time); },
                                [&](double time) { tick.run(time); }};
        const Rounds rounds = measure(frames, options.rounds(State::hot, threads));
        const std::string name = ", N = " + std::to_string(n);
        report.figure("displacement, normal and whitecap" + name, simd_text(options), threads,
                      1e3 * median(rounds.seconds[0]), "ms");
        report.figure("foam tick" + name, simd_text(options), threads,
                      1e3 * median(rounds.seconds[1]), "ms");
    }
}

void large_figures(const TableOptions& options, Report& report) {
    double at_1024 = 0.0;
    for (const int n : {1024, 4096, 8192}) {
        TableOptions few = options;
        few.quick = true;
        ThreadPool pool;
        const Sea sea(n, pool);
        const double seconds = median(measure_vertices(sea, 1, few).seconds[0]);
        const double nanoseconds = 1e9 * seconds / (static_cast<double>(n) * n);
        if (n == 1024) at_1024 = nanoseconds;
        const std::string name = ", N = " + std::to_string(n);
        report.figure("a vertex" + name, simd_text(options), 1, nanoseconds, "ns");
        if (n != 1024) {
            report.figure("a vertex / a vertex of N = 1024" + name, simd_text(options), 1,
                          nanoseconds / at_1024, "");
        }
    }
}

}  // namespace ocean::bench
