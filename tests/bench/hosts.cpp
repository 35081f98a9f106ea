// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What hosts ask for beside frames, each as so many map frames: a displacement map of the same sea
// on one thread.
#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <new>
#include <random>
#include <string>
#include <vector>

#include "frame_maps.hpp"
#include "ocean/ocean.hpp"
#include "table.hpp"

namespace ocean::bench {

namespace {

constexpr std::size_t kManyPoints = 100000;
/// Frames of a knob in motion: a second, in which it passes two or three steps of the wind. The
/// waves of a step are made at once.
constexpr int kPlayed = 60;

/// A wind sea that folds nowhere on its grid.
Parameters host_sea(int n) {
    Parameters parameters;
    parameters.grid.resolution = n;
    parameters.waves.front().spectrum = SpectrumKind::jonswap;
    parameters.surface.choppiness = 0.5;
    return parameters;
}

std::vector<WorldPoint> random_points(std::size_t count, double period) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, period);
    std::vector<WorldPoint> points(count);
    for (WorldPoint& point : points) point = {place(random), place(random)};
    return points;
}

class MapFrame {
  public:
    explicit MapFrame(const Parameters& parameters)
        : ocean_(parameters, {.threads = 1}),
          displacement_(3 * Lattice{parameters.grid.resolution, 1.0}.size()) {
        output_ = {displacement_.data(), 3, {}};
        output_.component[0].quantity = Channel::dx;
        output_.component[1].quantity = Channel::dy;
        output_.component[2].quantity = Channel::height;
    }
    Ocean& ocean() { return ocean_; }
    void run(double time) { ocean_.evaluate_into(time, {&output_, 1}); }
    /// Performs a wind as soon after the last as a take holds events, and runs its frame.
    template <typename WindAt>
    void play(const WindAt& wind_at) {
        played_until_ += kMinEventSpacing;
        ocean_.perform(played_until_, "wind_speed", std::to_string(wind_at(played_until_)));
        run(played_until_);
    }

  private:
    Ocean ocean_;
    double played_until_ = 0.0;
    HugeArray<float> displacement_;
    MapOutput output_;
};

/// A host's own: on pages of 4 KiB, 16 bytes behind their beginning, as malloc gives it.
class HostArray {
  public:
    explicit HostArray(std::size_t size)
        : bytes_(size * sizeof(float) + kPage),
          memory_(static_cast<char*>(std::aligned_alloc(kPage, bytes_ / kPage * kPage + kPage)),
                  &std::free) {
        if (!memory_) throw std::bad_alloc();
        madvise(memory_.get(), bytes_, MADV_NOHUGEPAGE);
        std::fill_n(memory_.get(), bytes_, '\0');
    }
    float* data() const { return reinterpret_cast<float*>(memory_.get() + 16); }

  private:
    static constexpr std::size_t kPage = 4096;
    std::size_t bytes_;
    std::unique_ptr<char, decltype(&std::free)> memory_;
};

/// Positions and normals in one kind of memory.
template <typename Array>
class VertexFrame {
  public:
    explicit VertexFrame(const Parameters& parameters)
        : ocean_(parameters, {.threads = 1}),
          position_(3 * Lattice{parameters.grid.resolution, 1.0}.size()),
          normal_(3 * Lattice{parameters.grid.resolution, 1.0}.size()) {
        using enum Channel;
        outputs_[0] = {position_.data(), 3, {{{dx}, {dy}, {height}}}};
        outputs_[1] = {normal_.data(), 3, {{{nx}, {ny}, {nz}}}};
    }
    void run(double time) { ocean_.evaluate_into(time, outputs_); }

  private:
    Ocean ocean_;
    Array position_;
    Array normal_;
    MapOutput outputs_[2];
};

/// Foam of a live tool, whose every map is a tick on. A frame shows foam and nothing else.
class FoamTicks {
  public:
    explicit FoamTicks(const Parameters& parameters)
        : ocean_(parameters, {.threads = 1, .foam_start = FoamStart::empty}),
          foam_(Lattice{parameters.grid.resolution, 1.0}.size()) {}

    void tick(int resolution) {
        MapOutput output{foam_.data(), 1, {}};
        output.component[0].quantity = Channel::foam;
        // A sum of steps would round, and miss the time of a tick.
        const double time = ++ticks_[resolution] * ocean_.parameters().surface.foam_step;
        ocean_.evaluate_into(time, {&output, 1}, resolution);
    }

  private:
    Ocean ocean_;
    HugeArray<float> foam_;
    std::map<int, int> ticks_;
};

/// s that the past of foam still works, at most of a few tries, after its host wants it to stop.
double stop_latency(const Parameters& parameters) {
    using Time = std::chrono::steady_clock;
    struct Stopped {};
    double longest = 0.0;
    for (int attempt = 1; attempt <= 5; ++attempt) {
        const Time::time_point stop = Time::now() + std::chrono::milliseconds(73 * attempt);
        Ocean ocean(parameters, {.threads = 1, .interrupt = [stop] {
                                     if (Time::now() >= stop) throw Stopped{};
                                 }});
        try {
            ocean.evaluate(10.0, {Channel::foam});
        } catch (const Stopped&) {
            longest = std::max(longest, std::chrono::duration<double>(Time::now() - stop).count());
        }
    }
    return longest;
}

}  // namespace

void host_figures(int n, const TableOptions& options, Report& report) {
    const Parameters parameters = host_sea(n);
    const std::string simd(simd_name(simd_level()));
    const std::string name = ", N = " + std::to_string(n);
    MapFrame map(parameters);
    MapFrame played(parameters);
    MapFrame hurried(parameters);
    Ocean asked(parameters, {.threads = 1});
    Ocean asked_coarsely(parameters, {.threads = 1});
    Ocean asked_much(parameters, {.threads = 1});
    Ocean kept(parameters, {.threads = 1});
    Ocean below(parameters, {.threads = 1});
    VertexFrame<HugeArray<float>> huge(parameters);
    VertexFrame<HostArray> plain(parameters);
    std::vector<WaterPoint> depths;
    for (int i = 0; i < 8; ++i) depths.push_back({10.0 * i, 5.0, -1.0 * i});
    std::vector<WaterMotion> motions(depths.size());
    const auto points = random_points(kManyPoints, parameters.grid.patch_size);
    const std::span<const WorldPoint> one(points.data(), 1);
    std::vector<QuerySample> samples(points.size());
    kept.query(0.0, points, samples, {.foam = false});
    map.run(0.0);
    FoamTicks foam_of_two_sizes(parameters);
    foam_of_two_sizes.tick(n);
    foam_of_two_sizes.tick(n / 2);
    const Frame frames[] = {
        [&](double time) { map.run(time); },
        [&](double time) { asked.query(time, one, samples, {.foam = false}); },
        [&](double time) {
            asked_coarsely.query(time, one, samples,
                                 {.foam = false, .resolution = std::max(n / 4, kMinResolution)});
        },
        [&](double time) { asked_much.query(time, points, samples, {.foam = false}); },
        [&](double) { kept.query(0.0, points, samples, {.foam = false}); },
        [&](double) {
            for (int i = 0; i < kPlayed; ++i) {
                played.play([](double time) { return 10.0 + std::fmod(time, 1.0); });
            }
        },
        [&](double) { Ocean(map.ocean(), {.threads = 1}); },
        [&](double) { foam_of_two_sizes.tick(n); },
        [&](double) {
            foam_of_two_sizes.tick(n);
            foam_of_two_sizes.tick(n / 2);
        },
        [&](double time) { below.water_motion(time, depths, motions); },
        [&](double time) { huge.run(time); },
        [&](double time) { plain.run(time); },
        [&](double) {
            hurried.play([](double time) { return std::fmod(time, 1.0) < 0.5 ? 30.0 : 5.0; });
        },
    };
    const Rounds rounds = measure(frames, options.rounds(State::hot, 1));
    const double frame = median(rounds.seconds[0]);
    report.figure("map frame" + name, simd, 1, 1e3 * frame, "ms");
    const auto in_frames = [&](const char* what, std::size_t subject, double times = 1.0) {
        report.figure(what + (" / map frame" + name), simd, 1,
                      median_ratio(rounds, subject, 0) / times, "");
    };
    in_frames("a point at a new time", 1);
    in_frames("a point at a new time, of a map a quarter as fine", 2);
    in_frames("100 000 points at a new time", 3);
    report.figure("points a second, of one time" + name, simd, 1,
                  1e-6 * kManyPoints / median(rounds.seconds[4]), "million");
    in_frames("a performed change and its frame", 5, kPlayed);
    in_frames("a fast performed change and its frame", 12);
    in_frames("a clone", 6);
    in_frames("a tick of foam", 7);
    in_frames("a tick of foam on maps of two sizes, in turn", 8);
    in_frames("velocity and pressure at 8 depths", 9);
    report.figure("positions and normals into 4 KiB pages of malloc / huge pages" + name, simd, 1,
                  median_ratio(rounds, 11, 10), "");
    report.figure("from a stop to the end of a call" + name, simd, 1,
                  1e3 * stop_latency(parameters), "ms");
}

}  // namespace ocean::bench
