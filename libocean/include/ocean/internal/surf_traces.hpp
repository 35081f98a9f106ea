// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The traces of waves on a coast: constants of the foam of breaking waves and of wet sand, for
// hosts that follow them on samples of their own. Ocean::region() follows them on labels.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "ocean/domain.hpp"

namespace ocean {

class Ocean;
struct RegionTraces;

/// Time in which sand that the swash has wetted dries to 1/e [s].
inline constexpr double kDryingTime = 25.0;

/// Foam of breaking waves hides the share foam^kSurfCoverPower of the water: its lace opens as it
/// fades.
inline constexpr float kSurfCoverPower = 1.35f;

/// Returns how wet the ground is under water of this depth [m], 0 .. 1.
float covered_by(float depth);

/// The samples of a region over which waves can break by the depth or run up. All other samples
/// have no foam of breaking waves, and are as wet as at rest.
class RegionSurf {
  public:
    explicit RegionSurf(const Domain& domain);
    RegionSurf(RegionSurf&&) noexcept;
    ~RegionSurf();

    /// Visits these samples at a time [s]: the index in the region, the source of foam 0 .. 1, and
    /// the depth of the water [m]. The sea must have a bed, the same one in all calls. Costs a part
    /// of a region. Throws as Ocean::region().
    void read(Ocean& sea, double time,
              const std::function<void(std::uint32_t index, float breaking, float depth)>& visit);

  private:
    std::unique_ptr<RegionTraces> traces_;
};

}  // namespace ocean
