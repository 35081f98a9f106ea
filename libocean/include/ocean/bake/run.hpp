// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bakes the frames of a plan and reports its progress to a host.
//
//     struct Console : BakeHost {
//         void frame_baked(int frame, double seconds, const std::vector<std::string>&) override {
//             std::printf("frame %d: %.1f s\n", frame, seconds);
//         }
//         void warning(const std::string& text) override { std::puts(text.c_str()); }
//     };
//     Console host;
//     run_bake(make_bake_plan(options, standard_catalogue()), host);
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bake/plan.hpp"

namespace ocean {

struct WorkShare;

/// Receives the events of a bake; every default ignores its event. begin, end and the events of
/// frames come in the order of the frames from the thread of run_bake, all other calls from any
/// thread. An exception of a host ends the bake.
class BakeHost {
  public:
    virtual ~BakeHost() = default;

    virtual void begin(const BakePlan&, const WorkShare&) {}
    virtual void frame_baked(int /*frame*/, double /*seconds*/,
                             const std::vector<std::string>& /*files*/) {}
    /// The frame was complete already.
    virtual void frame_skipped(int /*frame*/, const std::vector<std::string>& /*files*/) {}
    /// `continues` is true if other frames follow; else the error ends the bake.
    virtual void frame_failed(int /*frame*/, const std::string& /*message*/, bool /*continues*/) {}
    virtual void end() {}

    virtual void note(const std::string&) {}
    virtual void warning(const std::string&) {}
    /// Returns the function that a worker calls while it computes earlier foam; may be empty.
    virtual std::function<void(std::int64_t done, std::int64_t total)> foam_progress() {
        return {};
    }

    /// Returns the function that is called while the subject is built, with what is being computed
    /// and the share of it that is done; may be empty.
    virtual std::function<void(std::string_view work, double share)> build_progress() { return {}; }

    /// Calls `write`; the process should not end before it returns.
    virtual void run_uninterrupted(const std::function<void()>& write) { write(); }
    /// Sets the function to call before the process ends on an interrupt; an empty one removes it.
    virtual void set_interrupt_handler(std::function<void()> /*handler*/) {}
};

/// Bakes the plan. Throws Error if the plan needs more memory than is available, and the error of
/// the first frame that fails.
void run_bake(const BakePlan& plan, BakeHost& host);

}  // namespace ocean
