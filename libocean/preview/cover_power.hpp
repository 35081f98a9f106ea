// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The power of the foam that is its cover, solved beside the frames: it takes tenths of a second,
// and a sea that glides has another one in every frame.
#pragma once

#include <memory>

#include "ocean/ocean.hpp"
#include "ocean/preview/sea_maps.hpp"

namespace ocean::preview {

class CoverPower {
  public:
    CoverPower();
    /// Stops what is being solved.
    ~CoverPower();
    CoverPower(const CoverPower&) = delete;
    CoverPower& operator=(const CoverPower&) = delete;

    /// Ocean::cover_power of a sea at a time, on maps of that resolution, or the one before until
    /// it is solved; of what is asked for meanwhile the last is solved next. Throws Error.
    double of(Ocean& sea, double time, int resolution);
    /// Returns whether it is being solved, or is solved and the next call of of() takes it.
    Pending pending() const;

  private:
    struct Job;

    Revision revision_;  // of the modes that were asked for last
    SurfaceSettings settings_;
    int resolution_ = 0;
    double power_ = 3.0;  // of a fresh breeze, about
    std::unique_ptr<Job> job_;
};

}  // namespace ocean::preview
