// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the wake of a hull costs beside a frame of the open sea, on one thread: a straight track and
// a turn, frame after frame and each frame alone. The subjects take turns, and times are those of
// the processor, so that other processes change no ratio by much.
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/simd/simd_level.hpp"
#include "hulls/wake.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/kernel/map_kernel.hpp"

namespace {

using namespace ocean;

constexpr int kFrames = 96;  // 4 s: whole blocks of a wake's clock
constexpr double kRate = 24.0;
constexpr int kTurn = 16;  // frames of one subject in a row
constexpr int kRounds = 7;

/// A ferry that goes straight on at 8 m/s and, if it turns, round a circle of 120 m from -60 s on.
Hull ferry(bool turns) {
    auto track = std::make_shared<HullTrack>();
    constexpr double kSpeed = 8.0, kRadius = 120.0;
    for (double t = -400.0; t <= 100.0; t += 0.5) {
        const double q = turns ? std::max(0.0, kSpeed * (t + 60.0) / kRadius) : 0.0;
        const double on = kSpeed * t - kRadius * q;
        track->rows.push_back({t, on + kRadius * std::sin(q), kRadius * (1.0 - std::cos(q))});
    }
    Hull hull;
    hull.length = 30.0;
    hull.beam = 6.0;
    hull.draught = 1.8;
    hull.wake_resolution = 256;
    hull.track = track;
    return hull;
}

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Subject {
    const char* name;
    std::function<void(int frame)> run;
    std::vector<std::vector<double>> seconds = std::vector<std::vector<double>>(kFrames);

    /// Returns the medians of each frame.
    std::vector<double> medians() const {
        std::vector<double> all;
        for (const auto& frame : seconds) all.push_back(median(frame));
        return all;
    }
};

}  // namespace

/// With a name: only the subject of that name.
int main(int argc, char** argv) {
    ThreadPool pool(1);
    Parameters sea;
    sea.grid.resolution = 512;
    const Modes modes = make_modes(make_directional_spectrum(sea), sea, pool);
    MapKernel kernel(pack_modes(map_modes(modes, 0.0, 512), pool), cache_sizes());
    PageVector<float> displacement(std::size_t{3} * 512 * 512);
    MapOutput output{displacement.data(), 3, {}};
    const Quantity quantities[] = {Channel::dx, Channel::dy, Channel::height};
    for (std::size_t c = 0; c < 3; ++c) output.component[c].quantity = quantities[c];

    const auto time_of = [](int frame) { return frame / kRate; };
    // Two frames in a row lie in other blocks.
    const auto scattered = [&](int frame) {
        return time_of(frame * 29 % kFrames) + 8.0 * (frame % 3);
    };
    const auto wake_of = [&](bool turns) {
        return std::make_shared<Wake>(ferry(turns), sea.water, 0.0, pool);
    };
    const auto move = [&](Wake& wake, double time, bool rates) {
        wake.move_to(time, rates, pool);
        wake.prepare(-1e6, 1e6, pool);
    };
    std::vector<Subject> subjects;
    subjects.push_back(
        {"frame of 512^2", [&](int frame) {
             kernel.run({modes.tau(time_of(frame)), sea.surface, {&output, 1}, {}}, pool);
         }});
    for (const bool turns : {false, true}) {
        for (const bool rates : {false, true}) {
            const char* const names[2][2] = {{"straight", "straight, velocities"},
                                             {"turn", "turn, velocities"}};
            subjects.push_back({names[turns][rates], [&, rates, wake = wake_of(turns)](int frame) {
                                    move(*wake, time_of(frame), rates);
                                }});
        }
        subjects.push_back(
            {turns ? "turn, alone" : "straight, alone",
             [&, wake = wake_of(turns)](int frame) { move(*wake, scattered(frame), false); }});
    }
    if (argc > 1) {
        std::erase_if(subjects, [&](const Subject& subject) {
            return &subject != &subjects.front() && std::string_view(subject.name) != argv[1];
        });
    }
    for (int round = 0; round < kRounds; ++round) {
        for (int first = 0; first < kFrames; first += kTurn) {
            for (Subject& subject : subjects) {
                for (int frame = first; frame < first + kTurn; ++frame) {
                    const double before = processor_seconds();
                    subject.run(frame);
                    subject.seconds[static_cast<std::size_t>(frame)].push_back(processor_seconds() -
                                                                               before);
                }
            }
        }
    }
    const auto mean = [](const std::vector<double>& values) {
        double sum = 0.0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    const double unit = mean(subjects.front().medians());
    std::printf("one thread, %s; ms and frames of 512^2 in the mean, frames at most\n",
                std::string(simd_name(simd_level())).c_str());
    for (const Subject& subject : subjects) {
        const auto medians = subject.medians();
        std::printf("%-22s %7.3f %6.2f %6.2f\n", subject.name, 1e3 * mean(medians),
                    mean(medians) / unit, std::ranges::max(medians) / unit);
    }
}
