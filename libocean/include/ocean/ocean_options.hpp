// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How a sea is computed, and what a frame of it costs.
//
//     Ocean ocean(sea, {.threads = 4, .backend = gl::kBackend, .interrupt = [] {
//                           if (stopped) throw Error(ErrorKind::interrupted, "stopped");
//                       }});
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "ocean/backend.hpp"
#include "ocean/channel.hpp"
#include "ocean/parameters.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

struct OceanOptions {
    int threads = 0;                    // 0 = the cores this process may use
    ThreadPool::RunJobs run_jobs = {};  // runs jobs on a host's own threads
    Backend backend = Backend::cpu;
    /// settled: foam at a time does not depend on earlier calls. empty: for live tools, which must
    /// not wait; foam begins with the first frame and is correct after foam_settling_ticks().
    FoamStart foam_start = FoamStart::settled;
    /// Called while foam is followed from its beginning; may throw to stop the call.
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    /// Called by the calling thread about 100 times a second during a computation; may throw to
    /// stop it. The outputs of a stopped call are incomplete; the Ocean can still be used.
    std::function<void()> interrupt = {};
    /// Channels beside those of the table, computed by their formulas with any backend:
    /// Channel(kChannelCount + i) is row i. Rows and names must outlive the Ocean.
    std::span<const ChannelInfo> channels = {};
    /// Called while the coast of a sea over a bed is computed, with what is being computed and the
    /// share of it that is done, 0 .. 1; may throw to stop the call.
    std::function<void(std::string_view work, double share)> build_progress = {};
};

/// Approximate seconds that a frame of displacement, normal and foam takes on this machine.
struct FrameCost {
    double alone = 0.0;        // with the whole past of its foam
    double in_sequence = 0.0;  // after the previous frame
};

}  // namespace ocean
