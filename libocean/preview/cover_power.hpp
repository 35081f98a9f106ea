// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The exponent from foam to its cover, solved in another thread: it takes tenths of a second, and a
// gliding sea has a new one in every frame.
#pragma once

#include <memory>

#include "ocean/internal/open_sea.hpp"
#include "ocean/internal/preview/sea_maps.hpp"

namespace ocean::preview {

class CoverPower {
  public:
    CoverPower();
    /// Stops a solution that is in work.
    ~CoverPower();
    CoverPower(const CoverPower&) = delete;
    CoverPower& operator=(const CoverPower&) = delete;

    /// Returns OpenSea::cover_power of a sea at a time [s], or the previous value until it is
    /// solved. A call while a solution is in work returns that value too; the first call after it
    /// begins the next solution. Throws Error.
    double of(OpenSea& sea, double time, const ShownFoam& foam);
    /// Returns whether a solution is in work, or ready for the next call of of().
    Pending pending() const;

  private:
    struct Job;

    Revision revision_;  // of the modes of the last request
    SurfaceSettings settings_;
    ShownFoam foam_{};
    double power_ = 3.0;  // about that of a fresh breeze
    std::unique_ptr<Job> job_;
};

}  // namespace ocean::preview
