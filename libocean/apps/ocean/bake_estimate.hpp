// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a bake will take of the machine: memory, threads, room on the disk.
#pragma once

#include "bake_plan.hpp"

namespace ocean::app {

class Console;

/// How many frames are computed side by side, and with how many threads each.
struct Crew {
    int workers = 1;
    int threads = 1;  // of each
};
/// `threads` = 0 means all. Throws Error out_of_memory if not even one frame fits.
Crew choose_crew(const BakePlan& plan, int threads);
/// Bytes of memory for the modes and the frames in hand.
std::uint64_t memory_bytes(const BakePlan& plan, int workers);

/// -n: the paths of all files on standard output, with a tab and "kept" after those that
/// --skip-existing keeps; what the others need at most, and what there is. Writes nothing.
void show_plan(const BakePlan& plan, const Crew& crew, Console& console);

}  // namespace ocean::app
