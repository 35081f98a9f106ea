// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See estimate.hpp.
#include "ocean/internal/bake/estimate.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <span>
#include <utility>

#include "complete_file.hpp"
#include "formats/spray_points.hpp"
#include "frame_baker.hpp"
#include "manifest.hpp"
#include "ocean/internal/bake/existing_frames.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

/// Memory of the program and its libraries without a sea [bytes], measured.
constexpr std::uint64_t kProgramBytes = 30 << 20;

/// Returns the memory of a frame: its maps, the work of making them, and the format's part [bytes].
std::uint64_t frame_bytes(const BakePlan& plan) {
    std::uint64_t bytes = plan.format->frame_bytes(plan);
    const Costs costs = plan.subject->costs();
    const int maps = plan.maps.channels.size() + (plan.follows_foam() ? kFoamMaps : 0);
    const auto add = [&](int resolution, int map_count, ChannelSet channels) {
        bytes +=
            maps_bytes(resolution, map_count) +
            costs.map({.backend = plan.backend, .channels = plan.channels}, channels, resolution);
    };
    for (const int resolution : plan.maps.resolutions) add(resolution, maps, plan.maps.channels);
    if (plan.maps.finer > 0) {
        add(plan.maps.finer, plan.maps.finer_channels.size(), plan.maps.finer_channels);
    }
    return bytes;
}

/// Returns the size of the files of any frame [bytes], an upper bound.
std::uint64_t max_bytes_of_a_frame(const BakePlan& plan) {
    // The texts of a frame's number and of its time in a header: 11 and 24 characters at most.
    constexpr std::uint64_t kFrameTexts = 64;
    std::uint64_t bytes = 0;
    for (const BakeFile& file : plan.format->files(plan, plan.frames.front())) {
        bytes += plan.format->max_bytes(plan, file) + kFrameTexts;
    }
    return bytes;
}

/// Adds the files of all frames. The frames in `kept`, which ascends, are complete.
void list_frames(const BakePlan& plan, const std::vector<int>& kept, BakeForecast& forecast) {
    if (plan.frames.empty()) return;
    std::vector<BakeFile> first = plan.format->files(plan, plan.frames.front());
    if (plan.frames.size() * first.size() > kMaxForecastFiles) {
        const std::vector<BakeFile> last = plan.format->files(plan, plan.frames.back());
        for (std::size_t i = 0; i < first.size(); ++i) {
            forecast.files.push_back({first[i].path + " ... " + last[i].path,
                                      static_cast<long>(kept.size()),
                                      static_cast<long>(plan.frames.size())});
        }
        return;
    }
    for (const int frame : plan.frames) {
        const bool keep = std::ranges::binary_search(kept, frame);
        for (BakeFile& file : plan.format->files(plan, frame)) {
            forecast.files.push_back({std::move(file.path), keep ? 1 : 0});
        }
    }
}

}  // namespace

std::uint64_t bake_memory_bytes(const BakePlan& plan, int frames_at_a_time) {
    const Costs costs = plan.subject->costs();
    return kProgramBytes + plan.format->library_bytes + costs.shared +
           static_cast<std::uint64_t>(frames_at_a_time) * (costs.each + frame_bytes(plan));
}

WorkShare share_work(const BakePlan& plan) {
    require_memory(bake_memory_bytes(plan, 1),
                   format_text("a bake of %d x %d samples", plan.finest(), plan.finest()));
    const int all = plan.threads > 0 ? plan.threads : available_cores();
    const int frames = static_cast<int>(plan.frames.size());
    int at_a_time = plan.is_sequential() ? 1 : std::clamp(frames, 1, all);
    // Uses half of the available memory, because the disk's cache and other programs need some too.
    while (at_a_time > 1 && bake_memory_bytes(plan, at_a_time) > available_memory() / 2) {
        --at_a_time;
    }
    return {at_a_time, all / at_a_time};
}

std::vector<std::string> bake_warnings(const BakePlan& plan, std::size_t frames) {
    if (plan.frames.empty()) return {};
    const Timeline timeline = plan.subject->timeline();
    std::vector<std::string> all;
    for (const int frame : std::span(plan.frames).first(std::min(frames, plan.frames.size()))) {
        const std::string of = timeline.plays_take ? "frame " + std::to_string(frame) + ": " : "";
        for (const auto& warning : plan.subject->warnings(timeline.time_of(frame))) {
            all.push_back(of + warning);
        }
        if (!all.empty() || !timeline.plays_take) break;
    }
    if (std::string warning = spray_cell_warning(plan); !warning.empty()) {
        all.push_back(std::move(warning));
    }
    return all;
}

long BakeForecast::all() const {
    return std::accumulate(files.begin(), files.end(), 0L,
                           [](long sum, const File& file) { return sum + file.count; });
}

long BakeForecast::kept() const {
    return std::accumulate(files.begin(), files.end(), 0L,
                           [](long sum, const File& file) { return sum + file.kept; });
}

BakeForecast forecast_bake(const BakePlan& plan) {
    constexpr std::size_t kFramesOfATake = 100;
    const WorkShare share = share_work(plan);
    const Manifest manifest(plan.pattern, plan.shard);
    refuse_to_overwrite_others(plan, manifest);
    io::require_folder(plan.pattern.folder());
    const auto is_complete = [&](const std::vector<BakeFile>& files) {
        return std::ranges::all_of(files, [&](const BakeFile& file) {
            return find_complete(plan, file, manifest, share.threads_each).has_value();
        });
    };
    BakeForecast forecast;
    if (plan.format->has_shared_files) {
        const std::vector<BakeFile> shared = plan.format->shared_files(plan);
        const bool keep = plan.skip_existing && is_complete(shared);
        for (const BakeFile& file : shared) {
            forecast.files.push_back({file.path, keep ? 1 : 0});
            if (!keep) forecast.bytes += plan.format->max_bytes(plan, file);
        }
    }
    std::vector<int> kept = plan.skip_existing ? frames_that_may_exist(plan) : std::vector<int>();
    std::erase_if(kept, [&](int f) { return !is_complete(plan.format->files(plan, f)); });
    list_frames(plan, kept, forecast);
    if (!plan.frames.empty()) {
        forecast.bytes += (plan.frames.size() - kept.size()) * max_bytes_of_a_frame(plan);
    }
    forecast.free_bytes = io::free_bytes(plan.pattern.folder());
    forecast.memory_bytes = bake_memory_bytes(plan, share.frames_at_a_time);
    forecast.warnings = bake_warnings(plan, kFramesOfATake);
    return forecast;
}

double BakePace::seconds(int frames) const {
    if (frames < 1) return 0.0;
    return first + std::max(static_cast<double>(frames) / frames_at_a_time - 1.0, 0.0) * next;
}

BakePace measure_bake_pace(const BakePlan& plan) {
    if (plan.frames.empty()) return {};
    const WorkShare share = share_work(plan);
    const auto source = plan.subject->open(plan.maps_options());
    Manifest manifest(plan.pattern, plan.shard);
    BakeHost host;
    const Bake bake{plan, *source, manifest, host};
    FrameBaker baker(bake, share.threads_each);
    const auto seconds_of = [&](int frame) {
        const auto begin = std::chrono::steady_clock::now();
        baker.make_maps(plan.subject->timeline().time_of(frame));
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const double first = seconds_of(plan.frames.front());
    const double next = plan.frames.size() == 1 ? first : seconds_of(plan.frames[1]);
    return {first, next, share.frames_at_a_time};
}

}  // namespace ocean
