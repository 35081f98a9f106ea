// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The two halves of the table: frames against rivals, and figures of our own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "report.hpp"

namespace ocean::bench {

struct TableOptions {
    std::vector<int> sizes = {256, 512, 1024, 2048};
    SimdLevel level = simd_level();
    bool quick = false;
    bool all_variants = false;  // of every library, not only the strongest

    RoundPlan rounds(State state, int threads) const;
};

/// vertices or planar, each size, 1 and 2 threads, hot and cold. False if a field is wrong.
bool frames_table(FrameKind kind, const TableOptions& options, Report& report);
/// Ours against Blender's scheme and the posts' radix-2, vertices, hot.
bool peers_table(int n, const TableOptions& options, Report& report);

/// Memory and multipliers.
void machine_figures(const TableOptions& options, Report& report);
/// Each pass beside the least time that its bytes take, for each size.
void traffic_figures(const TableOptions& options, Report& report);
/// ocean_evaluate into the caller's memory against the kernel alone. False if the bits differ.
bool c_api_figures(int n, const TableOptions& options, Report& report);
/// Maps that their caller reads next, written through the caches and past them, against the choice
/// that the kernel makes by itself.
void read_back_figures(int n, const TableOptions& options, Report& report);
/// Two threads against one while another process wants a processor too.
void busy_figures(int n, const TableOptions& options, Report& report);
/// Spectrum and modes after a parameter moved, against a frame.
void rebuild_figures(int n, const TableOptions& options, Report& report);
/// Frames of our own that no rival makes: the product, a foam tick.
void product_figures(int n, const TableOptions& options, Report& report);
/// What hosts ask for beside frames, against a map frame.
void host_figures(int n, const TableOptions& options, Report& report);
/// Vertices on maps too large for the caches.
void large_figures(const TableOptions& options, Report& report);

}  // namespace ocean::bench
