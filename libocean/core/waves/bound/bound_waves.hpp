// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves that the products of a sea's long waves bind, as modes again: whatever makes maps or
// sums of modes makes those of bound waves.
#pragma once

#include <memory>

#include "ocean/internal/map_request.hpp"
#include "ocean/internal/modes.hpp"

namespace ocean {

class ThreadPool;

class BoundWaves {
  public:
    BoundWaves();
    ~BoundWaves();
    BoundWaves(BoundWaves&&) noexcept;
    BoundWaves& operator=(BoundWaves&&) noexcept;

    /// Returns the bound waves of a sea whose binding_limit is not 0, as modes whose state at time
    /// 0 is that of the sea's time. They add to the height at a label and displace nothing; their
    /// mean is mean(). rates: their height_rate is valid. Depends neither on the map's resolution
    /// nor on the number of threads. Valid until the next call.
    const Modes& at(const MapModes& sea, double choppiness, bool rates, ThreadPool& pool);
    /// Returns the mean over the labels [m] of the waves that at() returned: crests are squeezed
    /// together, so that the mean level of a choppy sea would lie below still water.
    double mean() const;

    /// Returns an upper bound of the bytes that the bound waves of such a grid need.
    static std::uint64_t bytes(int grid_resolution);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean
