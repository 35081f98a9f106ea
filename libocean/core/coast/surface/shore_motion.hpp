// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The motion of the water below the surface of a sea over its bed, by linear theory at the depth of
// each place.
#pragma once

#include <optional>
#include <span>

#include "coast/surface/shore_surface.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/parameters.hpp"
#include "ocean/query.hpp"

namespace ocean {

class ThreadPool;

class ShoreMotion {
  public:
    /// Writes the motion at the height z [m] at each place, without displacement. `surface` must
    /// have rates, `modes` are its modes. The waves of each band and sector decay by the wavenumber
    /// of the band's middle at the local depth; the waves in no band, and all waves where none
    /// feels the bed, decay as in the open sea (OrbitalMotion, which is kept for the next call).
    /// Above z = 0 the motion equals the motion at z = 0; in and below the bed it is 0. exact: see
    /// ShoreSurface::read; without it the time is the surface's.
    void sample(const ShoreSurface& surface, const Modes& modes, const Water& water,
                std::span<const WorldPoint> places, double z, std::span<WaterMotion> motions,
                const ShoreSums* exact, ThreadPool& pool);

  private:
    bool is_exact_ = false;
    std::optional<OrbitalMotion> open_;
    std::optional<OrbitalMotion> remainder_;
};

}  // namespace ocean
