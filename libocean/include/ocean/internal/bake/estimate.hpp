// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Estimates of a bake before it starts: memory, files, disk space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ocean/bake/plan.hpp"

namespace ocean {

/// The distribution of a bake's threads.
struct WorkShare {
    int frames_at_a_time = 1;
    int threads_each = 1;  // of a frame
};
/// Returns as many parallel frames as fit into half of the available memory; frames of a sequential
/// plan follow each other. Throws Error out_of_memory if not even one fits.
WorkShare share_work(const BakePlan& plan);

/// Returns an upper bound of the memory of a bake with that many parallel frames [bytes].
std::uint64_t bake_memory_bytes(const BakePlan& plan, int frames_at_a_time);

/// Returns the subject's warnings. For a subject that plays a take they are the warnings of the
/// first frame that has any, among the first `frames` frames.
std::vector<std::string> bake_warnings(const BakePlan& plan, std::size_t frames);

struct BakeForecast {
    /// One file; or, in a long bake, all frame files whose paths differ in the number alone.
    struct File {
        std::string path;  // "FIRST ... LAST" for several files
        long kept = 0;     // number of complete files, which are not written again
        long count = 1;
    };
    std::vector<File> files;

    /// Return the number of all files, and of those that are kept.
    long all() const;
    long kept() const;
    std::vector<std::string> warnings;  // for a take, of its first hundred frames
    std::uint64_t bytes = 0;            // upper bound for the files that are not kept
    std::uint64_t free_bytes = 0;       // on their disk
    std::uint64_t memory_bytes = 0;     // an upper bound
};
/// A bake of more files than this lists the first and the last one of each kind.
inline constexpr std::size_t kMaxForecastFiles = 100000;
/// Returns the files of a bake and the space they need. Reads existing files, writes none.
BakeForecast forecast_bake(const BakePlan& plan);
/// How fast this machine computes frames; writing them comes on top.
struct BakePace {
    double first = 0.0;  // frame, with the past of its foam [s]
    double next = 0.0;   // frame [s]
    int frames_at_a_time = 1;

    /// Returns the seconds of so many frames.
    double seconds(int frames) const;
};
/// Computes the first two frames of a plan.
BakePace measure_bake_pace(const BakePlan& plan);

}  // namespace ocean
