// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a bake will take, known before it begins: memory, files, room on the disk.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ocean/bake/plan.hpp"

namespace ocean {

/// How the threads are shared out.
struct WorkShare {
    int frames_at_a_time = 1;
    int threads_each = 1;
};
/// Frames side by side as far as memory goes; frames with foam follow each other. Throws Error
/// out_of_memory when not even one fits.
WorkShare share_work(const BakePlan& plan);

/// With so many frames at a time, at most.
std::uint64_t bake_memory_bytes(const BakePlan& plan, int frames_at_a_time);

struct BakeForecast {
    struct File {
        std::string path;
        bool kept;  // complete already
    };
    std::vector<File> files;
    std::uint64_t bytes = 0;         // of those that are not kept, at most
    std::uint64_t free_bytes = 0;    // on their disk
    std::uint64_t memory_bytes = 0;  // at most
};
/// Reads what there is, writes nothing.
BakeForecast forecast_bake(const BakePlan& plan);

}  // namespace ocean
