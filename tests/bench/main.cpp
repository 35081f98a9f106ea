// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_bench: frames of an ocean, ours and the strongest that others' transforms give.
//   ocean_bench --table [...]            ratios, interleaved in one process: what scripts/bench
//   runs ocean_bench --benchmark_filter=...   Google Benchmark's milliseconds, one subject at a
//   time
#include <benchmark/benchmark.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include "ocean/error.hpp"
#include "table.hpp"
#include "transforms.hpp"

namespace ocean::bench {
namespace {

constexpr const char* kUsage =
    "usage: ocean_bench --table [--sizes 256,512] [--only PART[,PART]] [--simd avx2|avx512]\n"
    "                   [--quick] [--all-variants] [--ordinary-pages] [--json FILE]\n"
    "       ocean_bench [--benchmark_filter=REGEX] [--benchmark_...]\n"
    "parts: vertices planar peers machine traffic readback capi busy rebuild product hosts large\n";

struct Arguments {
    TableOptions table;
    std::vector<std::string> only;
    std::string json;

    bool wants(const char* part) const {
        return only.empty() || std::find(only.begin(), only.end(), part) != only.end();
    }
};

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
    return words;
}

Arguments parse(int count, char** values) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string name = values[i];
        const auto value = [&]() -> std::string {
            if (++i == count) throw Error(ErrorKind::invalid_value, name + " wants a value");
            return values[i];
        };
        if (name == "--table" || name == "--ordinary-pages") continue;
        if (name == "--quick") {
            arguments.table.quick = true;
        } else if (name == "--all-variants") {
            arguments.table.all_variants = true;
        } else if (name == "--json") {
            arguments.json = value();
        } else if (name == "--only") {
            arguments.only = split(value());
        } else if (name == "--simd") {
            value();  // seen by prepare_environment
        } else if (name == "--sizes") {
            arguments.table.sizes.clear();
            for (const std::string& size : split(value())) {
                arguments.table.sizes.push_back(std::stoi(size));
            }
        } else {
            throw Error(ErrorKind::invalid_value, "unknown argument '" + name + "'\n" + kUsage);
        }
    }
    return arguments;
}

/// What libraries read when they are loaded, so the program starts anew with it: libgomp's threads
/// must sleep, not spin, between regions (they would take the others' processors), and our kernel,
/// the one in libocean.so too, is not to use more than --simd.
void prepare_environment(int count, char** values) {
    const char* simd = nullptr;
    for (int i = 1; i < count; ++i) {
        if (std::strcmp(values[i], "--simd") == 0 && i + 1 < count) simd = values[i + 1];
        // Whoever asks for huge pages, ours and rivals, gets none.
        if (std::strcmp(values[i], "--ordinary-pages") == 0) prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
    }
    const char* const now = std::getenv("OCEAN_SIMD");
    const bool simd_set = simd == nullptr || (now != nullptr && std::strcmp(now, simd) == 0);
    if (simd_set && std::getenv("OMP_WAIT_POLICY") != nullptr) return;
    setenv("OMP_WAIT_POLICY", "passive", 0);
    if (simd != nullptr) setenv("OCEAN_SIMD", simd, 1);
    execv("/proc/self/exe", values);
}

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    }
    return "unknown";
}

void report_facts(const TableOptions& options, Report& report) {
    report.fact("processor", processor());
    report.fact("pages", prctl(PR_GET_THP_DISABLE, 0, 0, 0, 0) == 1 ? "ordinary" : "huge");
    report.fact("compiler", OCEAN_BENCH_COMPILER);
    report.fact("instruction set", std::string(simd_name(options.level)));
    report.fact("FFTW3f", fftw_library().version());
    const TransformLibrary* const mkl = mkl_library(options.level);
    std::string mkl_version = mkl == nullptr ? "not there" : mkl->version();
    // Seen with MKL 2026.2 on an AMD EPYC: the same time with MKL_ENABLE_INSTRUCTIONS=SSE4_2.
    if (mkl != nullptr && !__builtin_cpu_is("intel")) mkl_version += ", its generic code only";
    report.fact("MKL", mkl_version);
}

int run_table(const Arguments& arguments) {
    const TableOptions& options = arguments.table;
    Report report(arguments.json);
    report_facts(options, report);
    const bool has_1024 =
        std::find(options.sizes.begin(), options.sizes.end(), 1024) != options.sizes.end();
    const int n = has_1024 ? 1024 : options.sizes.back();
    bool right = true;
    if (arguments.wants("machine")) machine_figures(options, report);
    if (arguments.wants("traffic")) traffic_figures(options, report);
    if (arguments.wants("vertices")) right &= frames_table(FrameKind::vertices, options, report);
    if (arguments.wants("planar")) right &= frames_table(FrameKind::planar, options, report);
    if (arguments.wants("peers")) right &= peers_table(n, options, report);
    if (arguments.wants("capi")) right &= c_api_figures(n, options, report);
    if (arguments.wants("readback")) {
        for (const int size : options.sizes) read_back_figures(size, options, report);
    }
    if (arguments.wants("busy")) busy_figures(n, options, report);
    if (arguments.wants("rebuild")) rebuild_figures(n, options, report);
    if (arguments.wants("product")) product_figures(n, options, report);
    if (arguments.wants("hosts")) {
        for (const int size : {512, 1024}) host_figures(size, options, report);
    }
    if (arguments.wants("large") && !options.quick) large_figures(options, report);
    return right ? 0 : 1;
}

/// frame/N/threads/library, variant: by Google Benchmark's manual time, as `Clock` of the table.
void register_subject(FrameKind kind, int n, int threads, const SubjectMaker& maker) {
    const std::string name = std::string(frame_name(kind)) + "/" + std::to_string(n) + "/" +
                             std::to_string(threads) + "/" + maker.library + ", " + maker.variant;
    benchmark::RegisterBenchmark(
        name.c_str(),
        [=](benchmark::State& state) {
            ThreadPool pool;
            const auto sea = std::make_shared<const Sea>(n, pool);
            const auto rivals = std::make_shared<const RivalSea>(sea->modes);
            const Subject subject = maker.make({sea, rivals, kind, threads, simd_level()});
            if (!subject.frame) return state.SkipWithError("the library refuses");
            const Clock clock = threads == 1 ? Clock::cpu : Clock::wall;
            double time = 0.0;
            for (int warm = 0; warm < 3; ++warm) subject.frame(time);
            for ([[maybe_unused]] const auto iteration : state) {
                const double start = seconds(clock);
                subject.frame(time += 0.04);
                state.SetIterationTime(seconds(clock) - start);
            }
        })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

void register_all() {
    std::vector<SubjectMaker> makers = rival_makers(simd_level());
    makers.insert(makers.begin(), {"ours", std::string(simd_name(simd_level())), 1, make_ours});
    for (const FrameKind kind : {FrameKind::vertices, FrameKind::planar}) {
        for (const int n : {256, 512, 1024, 2048}) {
            for (const int threads : {1, 2}) {
                for (const SubjectMaker& maker : makers) {
                    if (threads >= maker.least_threads) register_subject(kind, n, threads, maker);
                }
            }
        }
    }
}

int run_benchmarks(int count, char** values) {
    benchmark::Initialize(&count, values);
    if (benchmark::ReportUnrecognizedArguments(count, values)) return 2;
    register_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

}  // namespace
}  // namespace ocean::bench

int main(int argc, char** argv) {
    using namespace ocean::bench;
    prepare_environment(argc, argv);
    try {
        for (int i = 1; i < argc; ++i) {
            if (std::strcmp(argv[i], "--table") == 0) return run_table(parse(argc, argv));
        }
        return run_benchmarks(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "ocean_bench: " << error.what() << '\n';
        return 2;
    }
}
