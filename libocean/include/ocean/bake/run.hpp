// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Baking the frames of a plan, for whoever wants to watch.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ocean/bake/estimate.hpp"
#include "ocean/bake/plan.hpp"

namespace ocean {

/// What becomes of a bake is told to one of these; a host that wants to know nothing takes it as it
/// is. begin, end and those of a frame are called in the order of the frames from the thread of
/// run_bake, the others from any thread. What it throws ends the bake.
class BakeHost {
  public:
    virtual ~BakeHost() = default;

    virtual void begin(const BakePlan&, const WorkShare&) {}
    virtual void frame_baked(int /*frame*/, double /*seconds*/,
                             const std::vector<std::string>& /*files*/) {}
    /// It was complete already.
    virtual void frame_kept(int /*frame*/, const std::vector<std::string>& /*files*/) {}
    /// `goes_on`: other frames follow; else the error ends the bake.
    virtual void frame_failed(int /*frame*/, const std::string& /*message*/, bool /*goes_on*/) {}
    virtual void end() {}

    virtual void note(const std::string&) {}
    virtual void warning(const std::string&) {}
    /// What a worker tells of the foam that it follows; may be empty.
    virtual std::function<void(std::int64_t done, std::int64_t total)> foam_progress() {
        return {};
    }

    /// Calls `write`; until it returns the process should not end.
    virtual void whole(const std::function<void()>& write) { write(); }
    /// What to do if the process is about to end, until it is replaced by an empty function.
    virtual void if_interrupted(std::function<void()> /*last_act*/) {}
};

/// Throws Error: a plan for which there is not enough memory, and the first frame that fails.
void run_bake(const BakePlan& plan, BakeHost& host);

}  // namespace ocean
